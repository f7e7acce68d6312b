// What a triangle's numbers may be, checked before it is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/spec/structs.h"

namespace pineda::timing {

/// Do a triangle's numbers fit into the fields that the hardware has for them? A number that does not
/// would lose its upper bits there.
class TriangleRange {
 public:
  explicit TriangleRange(const spec::Contract& contract);

  /// Without a branch, since it is asked of every triangle.
  bool holds(const spec::Triangle& triangle) const {
    const auto& v = triangle.v;
    uint64_t outside = 0;
    for (const spec::Vertex& vertex : v) {
      outside |= (static_cast<uint32_t>(vertex.x) + half_) & above_coordinate_;
      outside |= (static_cast<uint32_t>(vertex.y) + half_) & above_coordinate_;
      outside |= static_cast<uint64_t>(vertex.z) & above_depth_;
      outside |= (static_cast<uint32_t>(vertex.inverse_w) - least_inverse_w_) & above_inverse_w_;
      outside |= static_cast<uint32_t>(vertex.inverse_w_shift) & above_shift_;
    }
    uint32_t attributes = 0;
    for (size_t a = 0; a < attributes_; ++a) {
      const auto others = static_cast<uint32_t>(v[1].attr[a] | v[2].attr[a]);
      attributes |= static_cast<uint32_t>(v[0].attr[a]) & above_first_[a];
      attributes |= others & above_others_[a];
    }
    return (outside | attributes) == 0;
  }

  /// The first number outside its range, in one line; empty if there is none.
  std::string reason(const spec::Triangle& triangle) const;

 private:
  spec::Contract contract_;
  // The bits that must be 0; none of a number that the design does not have.
  uint32_t half_;  // of the coordinates' range
  uint32_t above_coordinate_;
  uint64_t above_depth_ = 0;
  uint32_t least_inverse_w_ = 0;
  uint32_t above_inverse_w_ = 0;
  uint32_t above_shift_ = 0;
  size_t attributes_;
  std::array<uint32_t, spec::kMaxAttributes> above_first_{};   // of vertex 0, which has flat ones
  std::array<uint32_t, spec::kMaxAttributes> above_others_{};  // of the other two
};

}  // namespace pineda::timing
