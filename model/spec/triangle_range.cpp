#include "model/spec/triangle_range.h"

#include <fmt/format.h>

namespace pineda::spec {

namespace {

// 2^bits
constexpr int64_t power(int bits) { return int64_t{1} << bits; }

// The bits of a word above its lowest ones.
uint32_t above(int bits) { return static_cast<uint32_t>(~uint64_t{0} << bits); }

int64_t greatest_z(const Design& design) {
  return (power(design.depth_bits) - 1) << kDepthInputFractionBits;
}

// What is wrong with one number, if it is.
std::string wrong(int64_t value, int64_t low, int64_t high, size_t vertex,
                  const std::string& name) {
  if (value >= low && value <= high) return {};
  return fmt::format("v[{}].{}: expected {} to {}, got {}", vertex, name, low, high, value);
}

}  // namespace

TriangleRange::TriangleRange(const Contract& contract)
    : design_(contract.design),
      half_(1U << (contract.width.coord - 1)),
      above_coordinate_(above(contract.width.coord)),
      attributes_(static_cast<size_t>(channels(contract.design))) {
  const Design& d = design_;
  if (d.depth_test) greatest_z_ = static_cast<uint64_t>(greatest_z(d));
  if (d.perspective) {
    // Its top bit is 1: half of the range is left.
    least_inverse_w_ = 1U << (d.inverse_w_bits - 1);
    above_inverse_w_ = above(d.inverse_w_bits - 1);
    above_shift_ = above(kInverseWShiftBits);
    least_shift_ = ~0U;
  }
  for (size_t a = 0; a < attributes_; ++a) {
    above_first_[a] = above(d.attribute_bits);
    if (a < static_cast<size_t>(d.attributes)) above_others_[a] = above_first_[a];
  }
}

std::string TriangleRange::reason(const Triangle& triangle) const {
  const Design& d = design_;
  const int64_t half = half_;
  std::string text;
  bool has_greatest = !d.perspective;
  for (size_t i = 0; i < triangle.v.size(); ++i) {
    const Vertex& v = triangle.v[i];
    const auto has = [&text, i](int64_t value, int64_t low, int64_t high, const std::string& name) {
      if (text.empty()) text = wrong(value, low, high, i, name);
    };
    has(v.x, -half, half - 1, "x");
    has(v.y, -half, half - 1, "y");
    if (d.depth_test) has(v.z, 0, greatest_z(d), "z");
    const size_t attributes = i == 0 ? attributes_ : static_cast<size_t>(d.attributes);
    for (size_t a = 0; a < attributes; ++a) {
      has(v.attr[a], 0, power(d.attribute_bits) - 1, fmt::format("attr[{}]", a));
    }
    if (!d.perspective) continue;
    has(v.inverse_w, power(d.inverse_w_bits - 1), power(d.inverse_w_bits) - 1, "inverse_w");
    has(v.inverse_w_shift, 0, power(kInverseWShiftBits) - 1, "inverse_w_shift");
    has_greatest |= v.inverse_w_shift == 0;
  }
  if (text.empty() && !has_greatest) {
    text = "inverse_w_shift: expected 0 at one of the vertices";
  }
  return text;
}

}  // namespace pineda::spec
