#include "model/spec/clear_depth.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace pineda::spec {

uint32_t depth_code(double z, int depth_bits) {
  if (!(z >= 0 && z <= 1)) {
    throw std::invalid_argument("clear depth: expected 0 to 1, got " + std::to_string(z));
  }
  constexpr int kMantissaBits = 53;
  // z = mantissa * 2^-shift, and the product has 85 bits.
  int exponent;
  const auto mantissa = static_cast<int64_t>(std::ldexp(std::frexp(z, &exponent), kMantissaBits));
  const int shift = kMantissaBits - exponent;
  const int128_t product = int128_t{mantissa} * ((int64_t{1} << depth_bits) - 1);
  // With a shift of 86 or more the result is below one half, so 0.
  return shift > kMantissaBits + 32 ? 0 : static_cast<uint32_t>(round_half_up(product, shift));
}

double depth_of_code(uint32_t code, int depth_bits) {
  return static_cast<double>(code) / static_cast<double>((int64_t{1} << depth_bits) - 1);
}

uint32_t cleared_depth(const Design& d, const FrameState& frame) {
  return d.depth_test ? depth_code(frame.clear_depth, d.depth_bits) : 0xffffff;
}

}  // namespace pineda::spec
