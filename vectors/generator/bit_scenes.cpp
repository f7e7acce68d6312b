// Scenes in which one bit alone decides: two vertices apart by it, an edge as long as it, a corner on a sample.
#include <algorithm>

#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

constexpr int kScenes = 24;

// Calls draw(bit) with the bits of a coordinate, below its sign, that are the scene's: one, or two in a design
// with more bits than scenes.
template <class Visitor>
void for_each_bit(const Draw& d, Visitor&& draw) {
  const int bits = d.contract().width.coord - 1;
  for (int bit = d.index() % std::min(bits, kScenes); bit < bits; bit += kScenes) draw(bit);
}

// Two vertices differ in one bit of x or y alone, the row or column of their box with it, and the third lies
// beyond one of them: each pair, either way round, on each side.
void lone_bit(Draw& d, int bit) {
  const int64_t apart = int64_t{1} << bit;
  for (int i = 0; i < 24; ++i) {
    const bool is_x = i % 2 == 1, is_high = i / 2 % 2 == 1;
    const int64_t start = 4 * d.px() * d.random().between(1, 3);
    int64_t low = start + (2 * apart == d.px() ? d.half() / 2 : d.half());
    if ((low & apart) != 0) low -= apart;
    const int64_t beyond =
        is_high ? low - d.reach(4) : std::min(low + apart + d.reach(4), d.greatest());
    std::array<int64_t, 3> along{low, low + apart, beyond};
    std::array<int64_t, 3> across{2 * d.px(), 12 * d.px(), d.random().between(4, 8) * d.px()};
    std::array<spec::Vertex, 3> v;
    constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                   {2, 0, 1}, {1, 2, 0}, {2, 1, 0}};
    for (size_t k = 0; k < 3; ++k) {
      const auto from = static_cast<size_t>(kOrders[i / 4][k]);
      v[k] = d.vertex(is_x ? Point{along[from], across[from]} : Point{across[from], along[from]});
    }
    d.add_ordered(v);
  }
}

// The level top is so long, or an edge to the lower right so high: a power of two, whose other bits are zero.
void power_of_two(Draw& d, int bit) {
  const int64_t length = int64_t{1} << bit;
  const Point start = d.center(2, 2);
  const int64_t wide = 3 * d.px(), step = d.random().between(1, d.px());
  d.add({start, start + Point{length, 0}, start + Point{-d.px(), wide}});
  d.add({start, start + Point{wide, length}, start + Point{-d.px(), wide}});
  const Point second = start + Point{wide, step};
  const int64_t across = d.random().between(1, 2);
  d.add({start, second, second + Point{across, length}});
}

void lone_bits(Draw& d) {
  d.frame(16, 16);
  for_each_bit(d, [&](int bit) { lone_bit(d, bit); });
}
void powers_of_two(Draw& d) {
  d.frame(16, 16);
  for_each_bit(d, [&](int bit) { power_of_two(d, bit); });
}

// Corners on samples, so that each side of the box hangs on one bit, anywhere in a frame low and wide, or high and
// narrow.
void far_on_samples(Draw& d) {
  constexpr int kReach = 7;
  const int side = 1 << d.contract().design.guard_bits;
  const bool wide = d.index() % 2 == 0;
  d.frame(wide ? side : kReach + 1, wide ? kReach + 1 : side);
  for (int i = 0; i < 8; ++i) {
    const int64_t first = d.random().between(0, side - kReach - 1);
    const Point low = wide ? Point{first, 0} : Point{0, first};
    const Point high = low + Point{kReach, kReach};
    d.add({d.center_in_box(low, high), d.center_in_box(low, high), d.center_in_box(low, high)});
  }
}

}  // namespace

std::vector<SceneClass> bit_classes() {
  return {{"lone_bit", kScenes, lone_bits},
          {"power_of_two", kScenes, powers_of_two},
          {"far_on_samples", kScenes, far_on_samples}};
}

}  // namespace pineda::vectors
