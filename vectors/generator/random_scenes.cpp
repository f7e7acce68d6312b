// Random triangles by size, in every raster state.
#include <algorithm>

#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

void random_state(Draw& d) {
  d.scene().frame.depth = static_cast<spec::DepthFunc>(d.random().between(0, 2));
  // Half of the scenes cull nothing.
  d.scene().frame.cull =
      d.random().coin() ? spec::Cull::kNone : static_cast<spec::Cull>(d.random().between(1, 2));
}

// Triangles with sides up to 2*reach px about points of a small window.
void in_window(Draw& d, int triangles, int64_t reach) {
  const int width = d.random().between(6, 11);
  d.frame(width, d.random().between(6, 11));
  random_state(d);
  for (int i = 0; i < triangles; ++i) {
    const Point p = d.point(0, 0, d.scene().frame.width, d.scene().frame.height);
    d.add(figures::around(d, p, reach * d.px()));
  }
}
void random_1px(Draw& d) { in_window(d, 10, 1); }
void random_4px(Draw& d) { in_window(d, 5, 4); }
void random_16px(Draw& d) { in_window(d, 4, 16); }
void random_256px(Draw& d) { in_window(d, 4, 256); }
void random_8192px(Draw& d) { in_window(d, 4, 8192); }
void random_guard(Draw& d) { in_window(d, 5, 32768); }

// Small triangles anywhere in the greatest frame or a smaller one: every bit of an address is used.
void random_anywhere(Draw& d) {
  const int side = 1 << std::max(0, d.contract().design.guard_bits - d.index() % 4);
  d.frame(side, side);
  random_state(d);
  for (int i = 0; i < 4; ++i) {
    const Point p = d.point(0, 0, side, side);
    d.add(figures::around(d, p, 3 * d.px()));
  }
}

// Low and wide, or high and narrow: every bit of a column or row, in a frame that memory holds.
void random_strip(Draw& d) {
  const int side = 1 << d.contract().design.guard_bits;
  const bool wide = d.index() % 2 == 0;
  d.frame(wide ? side : 3, wide ? 3 : side);
  random_state(d);
  for (int i = 0; i < 5; ++i) {
    const Point p = d.point(0, 0, d.scene().frame.width, d.scene().frame.height);
    d.add(figures::around(d, p, 3 * d.px()));
  }
}

// Any triangle of the guard band in the greatest frame; too large for all units but setup.
void random_large(Draw& d) {
  const int side = 1 << d.contract().design.guard_bits;
  d.frame(side, side);
  random_state(d);
  for (int i = 0; i < 4; ++i) {
    const auto anywhere = [&] { return d.point(-side, -side, side, side); };
    d.add({anywhere(), anywhere(), anywhere()});
  }
}

}  // namespace

std::vector<SceneClass> random_classes() {
  return {{"random_1px", 12, random_1px},          {"random_4px", 16, random_4px},
          {"random_16px", 12, random_16px},        {"random_256px", 12, random_256px},
          {"random_8192px", 12, random_8192px},    {"random_guard", 12, random_guard},
          {"random_anywhere", 8, random_anywhere}, {"random_strip", 8, random_strip},
          {"random_large", 12, random_large}};
}

}  // namespace pineda::vectors
