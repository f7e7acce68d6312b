#include "model/timing/units/triangle_range.h"

#include <cstring>

#include "model/spec/fields.h"

namespace pineda::timing {

namespace {

// The bits of a word above its lowest ones.
uint64_t above(int bits) { return bits >= 64 ? 0 : ~uint64_t{0} << bits; }
uint32_t above32(int bits) { return static_cast<uint32_t>(above(bits)); }

}  // namespace

TriangleRange::TriangleRange(const spec::Contract& contract)
    : contract_(contract),
      half_(1U << (contract.width.coord - 1)),
      above_coordinate_(above32(contract.width.coord)),
      attributes_(static_cast<size_t>(spec::channels(contract.design))) {
  const spec::Design& d = contract.design;
  if (d.depth_test) above_depth_ = above(contract.width.depth_in);
  if (d.perspective) {
    // Its top bit is 1: half of the range is left.
    least_inverse_w_ = 1U << (d.inverse_w_bits - 1);
    above_inverse_w_ = above32(d.inverse_w_bits - 1);
    above_shift_ = above32(spec::kInverseWShiftBits);
  }
  for (size_t a = 0; a < attributes_; ++a) {
    above_first_[a] = above32(d.attribute_bits);
    if (a < static_cast<size_t>(d.attributes)) above_others_[a] = above_first_[a];
  }
}

std::string TriangleRange::reason(const spec::Triangle& triangle) const {
  const int bits = contract_.design.inverse_w_bits;
  for (const auto& field : spec::fields<spec::Triangle>(contract_)) {
    if (std::strcmp(field.name, "id") == 0) continue;
    const bool is_w = std::strcmp(field.name, "inverse_w") == 0;
    const int64_t least = field.is_signed ? -(int64_t{1} << (field.bits - 1))
                          : is_w          ? int64_t{1} << (bits - 1)
                                          : 0;
    const int64_t count = int64_t{1} << (is_w ? bits - 1 : field.bits);
    const int of_vertex = std::strcmp(field.name, "flat") == 0 ? field.count : field.count / 3;
    for (int i = 0; i < field.count; ++i) {
      const int64_t value = field.get(contract_, triangle, i);
      if (value >= least && value < least + count) continue;
      std::string name = field.name;
      if (of_vertex > 1) name += "[" + std::to_string(i % of_vertex) + "]";
      return "triangle " + std::to_string(triangle.id) + ", vertex " +
             std::to_string(i / of_vertex) + ", " + name + ": expected " + std::to_string(least) +
             " to " + std::to_string(least + count - 1) + ", got " + std::to_string(value);
    }
  }
  return {};
}

}  // namespace pineda::timing
