// What a triangle's numbers may be, checked before it is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "model/spec/structs.h"

namespace pineda::spec {

/// Are a triangle's numbers legal? Coordinates, attributes and 1/w fill the fields that the hardware
/// has for them, and would lose their upper bits in it. Depth ends at the greatest code with
/// fraction 0, which is 1.0: a plane through more has codes beyond the greatest.
class TriangleRange {
 public:
  explicit TriangleRange(const Contract& contract);

  /// Without a branch, since it is asked of every triangle.
  bool holds(const Triangle& triangle) const {
    const auto& v = triangle.v;
    uint64_t outside = 0;
    uint32_t least_shift = ~0U;
    for (const Vertex& vertex : v) {
      const auto shift = static_cast<uint32_t>(vertex.inverse_w_shift);
      outside |= (static_cast<uint32_t>(vertex.x) + half_) & above_coordinate_;
      outside |= (static_cast<uint32_t>(vertex.y) + half_) & above_coordinate_;
      outside |= static_cast<uint64_t>(static_cast<uint64_t>(vertex.z) > greatest_z_);
      outside |= (static_cast<uint32_t>(vertex.inverse_w) - least_inverse_w_) & above_inverse_w_;
      outside |= shift & above_shift_;
      least_shift = shift < least_shift ? shift : least_shift;
    }
    outside |= least_shift & least_shift_;
    // Four attributes at a time; those that the design does not have may be anything.
    Four attributes{};
    for (size_t a = 0; a < attributes_; a += 4) {
      const Four others = four(v[1].attr.data() + a) | four(v[2].attr.data() + a);
      attributes |= (four(v[0].attr.data() + a) & four(above_first_.data() + a)) |
                    (others & four(above_others_.data() + a));
    }
    outside |= attributes[0] | attributes[1] | attributes[2] | attributes[3];
    return outside == 0;
  }

  /// The first number outside its range, as "v[1].x: expected -8 to 7, got 9"; empty if there is
  /// none.
  std::string reason(const Triangle& triangle) const;

 private:
  typedef uint32_t Four __attribute__((vector_size(16)));
  static_assert(kMaxAttributes % 4 == 0);
  template <class Number>
  static Four four(const Number* from) {
    Four numbers;
    std::memcpy(&numbers, from, sizeof numbers);
    return numbers;
  }

  Design design_;
  // The bits that must be 0; none of a number that the design does not have.
  uint32_t half_;  // of the coordinates' range
  uint32_t above_coordinate_;
  uint64_t greatest_z_ = ~uint64_t{0};
  uint32_t least_inverse_w_ = 0;
  uint32_t above_inverse_w_ = 0;
  uint32_t above_shift_ = 0;
  uint32_t least_shift_ = 0;
  size_t attributes_;
  std::array<uint32_t, kMaxAttributes> above_first_{};   // of vertex 0, which has flat ones
  std::array<uint32_t, kMaxAttributes> above_others_{};  // of the other two
};

}  // namespace pineda::spec
