// Hard cases at limits: of the guard band, the frame, tiles and number formats.
#include <algorithm>
#include <limits>

#include "model/scene/hard/draw.h"

namespace pineda::scene::hard {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

// Triangles of three corners of the guard band, in both windings; then triangles with an edge
// through the frame whose ends lie thousands of pixels away.
std::vector<ScreenTriangle> huge() {
  Drawing d(11);
  for (size_t i = 0; i < 4; ++i) {
    const auto [a, b, c] = figures::three_of(figures::guard_band(d), i);
    d.add({a, b, c});
    d.add({a, c, b});
  }
  for (int i = 0; i < 16; ++i) {
    const Point q = d.in_box({0, 0}, {24 * kPx, 16 * kPx});
    const Point along = d.near({0, 0}, 8000 * kPx);
    d.add_shuffled(figures::through(q, along, d.near({0, 0}, d.greatest())));
  }
  return d.triangles();
}

// A closed fan from the middle of the frame to the borders of the guard band.
std::vector<ScreenTriangle> guard_band_fan() {
  Drawing d(19);
  const auto ring = figures::guard_band_ring(d, 16, 500 * kPx);
  const Point middle = d.near({160 * kPx, 120 * kPx}, 20 * kPx);
  for (const Corners& triangle : figures::fan(middle, ring)) d.add_shuffled(triangle);
  return d.triangles();
}

// A jittered mesh in the far corner of the widest frame, up to the border of the guard band.
std::vector<ScreenTriangle> far_mesh() {
  constexpr int kColumns = 60;
  constexpr int kRows = 16;
  constexpr int64_t kSpacing = 4 * kPx;
  Drawing d(20);
  const auto corner = [&](int i, int j) {
    const bool inside = i > 0 && i < kColumns && j > 0 && j < kRows;
    const Point p{d.greatest() - (kColumns - i) * kSpacing, j * kSpacing};
    return inside ? d.near(p, kSpacing / 5) : p;
  };
  for (const auto& quad : figures::mesh(kColumns, kRows, corner)) {
    for (const Corners& half : figures::halves(quad, false)) d.add_shuffled(half);
  }
  return d.triangles();
}

// One coordinate outside the guard band: from just beyond it to infinity.
std::vector<ScreenTriangle> beyond_guard_band() {
  Drawing d(12);
  for (const float beyond :
       {16384.f, 16384.5f, 20000.f, 1e6f, 0x1p31f, std::numeric_limits<float>::max(), kInf}) {
    for (size_t component = 0; component < 4; ++component) {
      const Point b = d.in_box({0, 0}, {24 * kPx, 16 * kPx});
      const Point c = d.in_box({0, 0}, {24 * kPx, 16 * kPx});
      std::array<ScreenVertex, 3> v{d.vertex({}), d.vertex(b), d.vertex(c)};
      // -16384 itself is inside.
      const float value = component < 2 ? beyond : -beyond - .5f;
      (component % 2 == 0 ? v[0].x : v[0].y) = value;
      (component % 2 == 0 ? v[0].y : v[0].x) = d.random().uniform(-20, 40);
      d.add_shuffled(v);
    }
  }
  return d.triangles();
}

// Triangles across every corner and side of the frame, and around its middle.
std::vector<ScreenTriangle> over_borders(uint64_t seed, int width, int height, int reach_px) {
  Drawing d(seed);
  const Point middle{width * kHalfPx, height * kHalfPx};
  for (int i = 0; i < 27; ++i) {
    const Point at{(i % 3) * middle.x, (i / 3 % 3) * middle.y};
    d.add_shuffled(figures::around(d, at, reach_px * kPx));
  }
  return d.triangles();
}
std::vector<ScreenTriangle> odd_frame_641x479() { return over_borders(13, 641, 479, 24); }
std::vector<ScreenTriangle> odd_frame_13x7() { return over_borders(14, 13, 7, 12); }
std::vector<ScreenTriangle> odd_frame_1x1() { return over_borders(15, 1, 1, 2); }

// Vertices on the corners of 8x8 tiles, or off them by a subpixel or half a pixel; then edges along
// tile borders.
std::vector<ScreenTriangle> tile_corners() {
  Drawing d(16);
  const auto corner = [&] {
    const Point p = d.tile() * d.in_box({0, 0}, {5, 5});
    const int64_t offset = d.coin() ? 1 : kHalfPx;
    return p + offset * d.in_box({-1, -1}, {1, 1});
  };
  for (int i = 0; i < 32; ++i) d.add_shuffled(Corners{{corner(), corner(), corner()}});
  for (int i = 0; i < 16; ++i) {
    const int64_t x = figures::tile_border(d, 1 + i % 4);
    const Point far = d.in_box({0, 0}, {5 * d.tile(), 5 * d.tile()});
    const Point a{x, d.random().between(0, 2 * d.tile())};
    const Point b{x, d.random().between(3 * d.tile(), 5 * d.tile())};
    const auto turned = [&](Point p) { return i < 8 ? p : Point{p.y, p.x}; };
    d.add_shuffled({turned(a), turned(b), turned(far)});
  }
  return d.triangles();
}

// Coordinates at the extremes of the format or next to zero, in all combinations of signs, with
// minimal or maximal depth and colour. Then, in cells, small triangles with all combinations of
// extreme depths and colours.
std::vector<ScreenTriangle> format_extremes() {
  Drawing d(17);
  const auto extreme = [](ScreenVertex v, bool far, bool bright) {
    v.z = far ? 1.f : 0.f;
    v.rgba.fill(bright ? 255 : 0);
    return v;
  };
  for (int i = 0; i < 64; ++i) {
    std::array<ScreenVertex, 3> v;
    for (int k = 0; k < 3; ++k) {
      const Point p = figures::extreme_corner(d, i >> (2 * k));
      const bool far = d.coin();
      const bool bright = d.coin();
      v[static_cast<size_t>(k)] = extreme(d.vertex(p), far, bright);
    }
    d.add(v);
  }
  for (int i = 0; i < 16; ++i) {
    const Point origin = cell(i, 4);
    std::array<ScreenVertex, 3> v;
    for (int k = 0; k < 3; ++k) {
      const Point p = origin + d.in_box({0, 0}, {kCellPx * kPx, kCellPx * kPx});
      // In the first eight triangles far vertices are bright, in the others near ones.
      const bool high = (i >> k & 1) != 0;
      v[static_cast<size_t>(k)] = extreme(d.vertex(p), high, high == (i < 8));
    }
    d.add(v);
  }
  return d.triangles();
}

// NaN in each component of each vertex in turn, then both infinities, then denormals; an ordinary
// triangle at the end.
std::vector<ScreenTriangle> not_numbers() {
  Drawing d(18);
  const auto add = [&](size_t corner, size_t component, float value) {
    std::array<ScreenVertex, 3> v{d.vertex({4 * kPx, 3 * kPx}), d.vertex({29 * kPx, 9 * kPx}),
                                  d.vertex({11 * kPx, 28 * kPx})};
    ScreenVertex& at = v[corner];
    (component == 0 ? at.x : component == 1 ? at.y : component == 2 ? at.z : at.w) = value;
    d.add(v);
  };
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), kInf, -kInf, kDenormal,
                            -kDenormal, std::numeric_limits<float>::min() - kDenormal}) {
    // w is only set to NaN, which drops the triangle: readers reject an infinite or denormal w.
    const size_t components = value != value ? 4 : 3;
    for (size_t i = 0; i < 3 * components; ++i) add(i / components, i % components, value);
  }
  add(0, 3, 1);
  return d.triangles();
}

}  // namespace

std::vector<HardCase> limit_cases() {
  return {
      {"huge", "corners of the guard band, and edges of 8000 px through the frame",
       "exact coverage and values; nothing saturates", frame(24, 16), huge},
      {"guard_band_fan", "a fan from the middle of the frame to the borders of the guard band",
       "every sample exactly once", frame(320, 240), guard_band_fan},
      {"far_mesh", "small triangles 16,000 px from the origin, up to the border of the guard band",
       "every sample exactly once; single-precision setup leaves holes", frame(16384, 64),
       far_mesh},
      {"beyond_guard_band", "one component from 16384 px to infinity",
       "saturated at the guard band and counted, never wrapped", frame(24, 16), beyond_guard_band},
      {"odd_frame_641x479", "triangles over all borders of a frame that cuts stamps and tiles",
       "nothing outside the frame is read, written or counted", frame(641, 479), odd_frame_641x479},
      {"odd_frame_13x7", "the same on two tiles, both cut",
       "nothing outside the frame is read, written or counted", frame(13, 7), odd_frame_13x7},
      {"odd_frame_1x1", "the same on a single sample",
       "nothing outside the frame is read, written or counted", frame(1, 1), odd_frame_1x1},
      {"tile_corners", "vertices in the corners of tiles, edges along their borders",
       "no stamp is lost or sent twice", frame(40, 40), tile_corners},
      {"format_extremes", "greatest, least and smallest coordinates, depths and colours",
       "every width holds; shifts floor", frame(64, 64), format_extremes},
      {"not_numbers", "NaN, infinities and denormals in each component in turn",
       "NaN drops the triangle, an infinity saturates, a denormal is 0; all are counted",
       frame(32, 32), not_numbers},
  };
}

}  // namespace pineda::scene::hard
