#include "tests/core/hard_triangles.h"

#include <algorithm>
#include <array>

namespace pineda::test {

namespace {

// A number of `bits` bits: an extreme, near one, or any.
int64_t value_of(Random& random, int bits) {
  const int64_t greatest = (int64_t{1} << bits) - 1;
  const int64_t kind = random.between(0, 5);
  return kind < 2 ? 0 : kind < 4 ? greatest : random.between(0, greatest);
}

// A vertex at a border of the guard band, anywhere in it, or near a sample.
void place(Random& random, const spec::Design& d, const std::array<int, 2>& sample,
           spec::Vertex* v) {
  const int low = -(1 << (d.guard_bits + d.subpixel_bits));
  const int64_t kind = random.between(0, 7);
  const auto coordinate = [&](int near) {
    if (kind == 0) return random.between(0, 1) == 0 ? low : -low - 1;
    if (kind == 1) return random.between(low, -low - 1);
    const int reach = kind < 5 ? 2 : 3 << d.subpixel_bits;
    return static_cast<int>(
        std::clamp<int64_t>(near + random.between(-reach, reach), low, -low - 1));
  };
  v->x = coordinate(sample[0]);
  v->y = coordinate(sample[1]);
}

}  // namespace

spec::Triangle hard_triangle(Random& random, const spec::Design& d) {
  spec::Triangle t;
  std::array<int, 2> sample{};
  for (int& at : sample) {
    const int px = random.between(0, (1 << d.guard_bits) - 1);
    at = (px << d.subpixel_bits) + (1 << (d.subpixel_bits - 1));
  }
  for (auto& v : t.v) {
    place(random, d, sample, &v);
    v.z = value_of(random, d.depth_bits + spec::kDepthInputFractionBits);
    for (int32_t& a : v.attr) a = static_cast<int32_t>(value_of(random, d.attribute_bits));
    v.inverse_w = static_cast<int32_t>(random.between(1, 1 << 20));
    v.inverse_w_shift = static_cast<int32_t>(random.between(0, 30));
  }
  if (random.between(0, 7) == 0) t.v[1].y = t.v[0].y;
  if (random.between(0, 7) == 0) t.v[2].x = t.v[1].x;
  return t;
}

spec::FrameState hard_frame(Random& random, const spec::Design& d) {
  spec::FrameState frame;
  frame.width = frame.height = 1 << d.guard_bits;
  frame.cull = static_cast<spec::Cull>(random.between(0, 2));
  frame.shade = random.between(0, 3) == 0 ? spec::Shade::kFlat : spec::Shade::kSmooth;
  if (random.between(0, 3) == 0) {
    frame.scissor_x0 = random.between(0, frame.width / 2);
    frame.scissor_y0 = random.between(0, frame.height / 2);
    frame.scissor_x1 = random.between(0, frame.width + 9);
    frame.scissor_y1 = random.between(0, frame.height + 9);
  }
  return frame;
}

spec::Design variant(const char* name, int subpixel_bits, int attribute_bits, int attributes,
                     int reciprocal_bits) {
  spec::Design d;
  d.name = name;
  d.subpixel_bits = subpixel_bits;
  d.attribute_bits = attribute_bits;
  d.attributes = attributes;
  d.reciprocal_bits = reciprocal_bits;
  return d;
}

std::vector<spec::Design> limit_designs() {
  std::vector<spec::Design> all{
      variant("widest_narrow", 8, 8, 5, 31),      variant("product_too_wide", 8, 8, 4, 32),
      variant("numerator_too_wide", 8, 9, 3, 26), variant("wide_attributes", 4, 16, 1, 22),
      variant("sixteen", 4, 8, 16, 22),           variant("widest_planes", 12, 16, 2, 32),
  };
  all.back().depth_bits = 32;
  all.back().gradient_fraction_bits = 20;
  all.push_back(variant("longest_shift", 12, 16, 3, 32));
  all.back().gradient_fraction_bits = all.back().tile_fraction_bits = 8;
  all.push_back(variant("quadratic", 8, 8, 4, 26));
  all.back().reciprocal_scheme = spec::ReciprocalScheme::kQuadratic;
  all.push_back(variant("radix_4", 8, 8, 4, 26));
  all.back().reciprocal_scheme = spec::ReciprocalScheme::kRestoring4;
  return all;
}

}  // namespace pineda::test
