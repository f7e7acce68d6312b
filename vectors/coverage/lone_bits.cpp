#include "vectors/coverage/lone_bits.h"

#include <algorithm>

namespace pineda::vectors {
namespace {

// Bits of a coordinate below its sign.
int bits_of(const spec::Contract& c) { return c.width.coord - 1; }

bool is_power(int64_t value) { return value > 0 && (value & (value - 1)) == 0; }

constexpr size_t kPairs[6][2] = {{0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}};

}  // namespace

Bins lone_bits(const spec::Contract& c) {
  return product(
      product(named({"x,", "y,"}), named({"lowest two", "highest two"})),
      product(named({"0 below 1", "1 below 0", "0 below 2", "2 below 0", "1 below 2", "2 below 1"}),
              numbered(0, bits_of(c) - 1, "bit")));
}

void see_lone_bits(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int shift = s.contract.design.subpixel_bits;
  const int half = 1 << (shift - 1);
  const auto bits = static_cast<size_t>(bits_of(s.contract));
  const auto& v = s.triangle.v;
  for (size_t axis = 0; axis < 2; ++axis) {
    const auto at = [&](size_t i) { return axis == 0 ? v[i].x : v[i].y; };
    const int first = axis == 0 ? s.frame.scissor_x0 : s.frame.scissor_y0;
    const int end = axis == 0 ? s.frame.scissor_x1 : s.frame.scissor_y1;
    for (size_t side = 0; side < 2; ++side) {
      // The side of a box that begins, or ends, with a vertex.
      const auto border = [&](int value) {
        const int own = side == 0 ? (value + half - 1) >> shift : (value - half - 1) >> shift;
        return std::clamp(own, first, end - 1);
      };
      for (size_t pair = 0; pair < 6; ++pair) {
        const int low = at(kPairs[pair][0]), high = at(kPairs[pair][1]);
        const int third = at(3 - kPairs[pair][0] - kPairs[pair][1]);
        const int64_t apart = int64_t{high} - low;
        const bool is_beyond = side == 0 ? third > high : third < low;
        if (!is_power(apart) || (low & apart) != 0 || !is_beyond || border(low) == border(high)) {
          continue;
        }
        const auto bit = static_cast<size_t>(length_of(apart)) - 1;
        if (bit < bits) hits->add(((axis * 2 + side) * 6 + pair) * bits + bit);
      }
    }
  }
}

Bins powers_of_two(const spec::Contract& c) {
  return product(named({"width of a level top, edge 0,", "height towards the lower right, edge 0,",
                        "height towards the lower right, edge 1,"}),
                 numbered(0, bits_of(c) - 1, "bit"));
}

void see_powers_of_two(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const auto bits = static_cast<size_t>(bits_of(s.contract));
  for (size_t edge = 0; edge < 2; ++edge) {
    const spec::Vertex &from = s.vertex(edge), &to = s.vertex(edge + 1);
    const int64_t dx = int64_t{to.x} - from.x, dy = int64_t{to.y} - from.y;
    const bool is_level = edge == 0 && dy == 0;
    const int64_t length = is_level ? dx : dy;
    if (dx <= 0 || !is_power(length)) continue;
    const auto bit = static_cast<size_t>(length_of(length)) - 1;
    if (bit < bits) hits->add((is_level ? 0 : edge + 1) * bits + bit);
  }
}

Bins far_samples(const spec::Contract& c) {
  return product(named({"lowest x,", "highest x,", "lowest y,", "highest y,"}),
                 numbered(0, c.design.guard_bits - 1, "bit"));
}

void see_far_samples(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const spec::Design& d = s.contract.design;
  const int shift = d.subpixel_bits, half = 1 << (shift - 1);
  const int sides[] = {s.x_low, s.x_high, s.y_low, s.y_high};
  for (size_t side = 0; side < 4; ++side) {
    const int value = sides[side];
    if (value < 0 || (value & ((1 << shift) - 1)) != half) continue;
    for (int bit = 0; bit < d.guard_bits; ++bit) {
      if ((value >> shift >> bit & 1) == 0) continue;
      hits->add(side * static_cast<size_t>(d.guard_bits) + static_cast<size_t>(bit));
    }
  }
}

}  // namespace pineda::vectors
