#include "model/spec/difference.h"

#include <fmt/format.h>

#include <cmath>

namespace pineda::spec {

std::string value_text(int bits, int fraction_bits, const char* unit, int64_t value) {
  const uint64_t code = static_cast<uint64_t>(value) & (~uint64_t{0} >> (64 - bits));
  const double real = std::ldexp(static_cast<double>(value), -fraction_bits);
  return fmt::format("0x{:0{}x} ({}{}{})", code, (bits + 3) / 4, real, *unit == '\0' ? "" : " ",
                     unit);
}

std::string difference_text(const std::string& name, int bits, int fraction_bits, const char* unit,
                            int64_t expected, int64_t got) {
  return fmt::format("{}: expected {}, got {}", name,
                     value_text(bits, fraction_bits, unit, expected),
                     value_text(bits, fraction_bits, unit, got));
}

}  // namespace pineda::spec
