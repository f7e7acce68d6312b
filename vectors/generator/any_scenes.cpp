// Scenes in which everything is drawn evenly over its length in bits or over its kinds: what the classes
// of a level leave out is found here.
#include <algorithm>

#include "model/spec/clear_depth.h"
#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

using spec::DepthFunc;
using spec::Vertex;

bool one_in(Draw& d, int n) { return d.random().between(1, n) == 1; }

// 1 to `greatest`, every length in bits equally likely.
int64_t any_length(Draw& d, int64_t greatest) {
  const int bits = d.random().between(0, spec::bit_length(static_cast<uint64_t>(greatest)) - 1);
  const int64_t low = int64_t{1} << bits;
  return std::min(d.random().between(low, 2 * low - 1), greatest);
}

// -greatest - 1 to greatest; often 0, an end or small.
int64_t any_signed(Draw& d, int64_t greatest) {
  const int kind = d.random().between(0, 4);
  if (kind == 0) return 0;
  if (kind == 1) return d.random().coin() ? greatest : -greatest - 1;
  const int64_t length = any_length(d, greatest);
  return d.random().coin() ? length : -length;
}

int any_side(Draw& d) {
  const int greatest = 1 << d.contract().design.guard_bits;
  const int kind = d.random().between(0, 3);
  if (kind <= 1) return std::min(d.random().between(1, 20), greatest);
  return static_cast<int>(any_length(d, greatest));
}

void any_scissor(Draw& d, int side, int* low, int* high) {
  if (d.random().coin()) *low = static_cast<int>(any_length(d, side)) - 1;
  if (d.random().coin()) *high = static_cast<int>(any_length(d, side));
}

void any_state(Draw& d) {
  spec::FrameState& f = d.scene().frame;
  const int width = any_side(d);
  d.frame(width, any_side(d));
  f.cull =
      d.random().coin() ? spec::Cull::kNone : static_cast<spec::Cull>(d.random().between(1, 2));
  f.depth = static_cast<DepthFunc>(d.random().between(0, 8));
  f.depth_write = d.random().coin();
  f.shade = one_in(d, 4) ? spec::Shade::kFlat : spec::Shade::kSmooth;
  if (one_in(d, 4)) {
    any_scissor(d, f.width, &f.scissor_x0, &f.scissor_x1);
    any_scissor(d, f.height, &f.scissor_y0, &f.scissor_y1);
  }
  if (one_in(d, 4)) {
    f.bias_constant = any_signed(d, d.far() >> spec::kDepthInputFractionBits);
    f.bias_slope = static_cast<int32_t>(any_signed(d, (1 << (spec::kBiasSlopeBits - 1)) - 1));
  }
  if (one_in(d, 4)) {
    const int depth_bits = d.contract().design.depth_bits;
    const int64_t top = (int64_t{1} << depth_bits) - 1;
    const int64_t code = d.random().coin() ? d.random().between(0, 3) * (top / 3)
                                           : d.random().between(int64_t{0}, top);
    f.clear_depth = spec::depth_of_code(static_cast<uint32_t>(code), depth_bits);
  }
}

// About a sample of the frame, a corner of the frame or of the scissor, or anywhere.
Point any_place(Draw& d) {
  const spec::FrameState& f = d.scene().frame;
  const int kind = d.random().between(0, 5);
  if (kind == 0) return d.in_box({d.least(), d.least()}, {d.greatest(), d.greatest()});
  if (kind == 1) return d.px() * Point{f.width, f.height};
  if (kind == 2) {
    const Point low{f.clip_x0(), f.clip_y0()}, high{f.clip_x1(), f.clip_y1()};
    const bool left = d.random().coin();
    return d.px() * Point{left ? low.x : high.x, d.random().coin() ? low.y : high.y};
  }
  return d.center_in_box({0, 0}, {f.width - 1, f.height - 1});
}

// Samples of the frame in the box of a triangle, at most; a case must stay small.
int64_t samples_in_box(Draw& d, const Corners& p) {
  const spec::FrameState& f = d.scene().frame;
  const auto length = [&](int64_t a, int64_t b, int64_t c, int low, int high) {
    const int64_t first = std::max<int64_t>(std::min({a, b, c}) / d.px(), low);
    const int64_t last = std::min<int64_t>(std::max({a, b, c}) / d.px(), high - 1);
    return std::max<int64_t>(last - first + 1, 0);
  };
  return length(p[0].x, p[1].x, p[2].x, f.clip_x0(), f.clip_x1()) *
         length(p[0].y, p[1].y, p[2].y, f.clip_y0(), f.clip_y1());
}

Corners any_corners(Draw& d) {
  const Point place = any_place(d);
  const int64_t reach_x = any_length(d, d.greatest());
  const int64_t reach_y = d.random().coin() ? reach_x : any_length(d, d.greatest());
  Corners p;
  for (Point& corner : p) {
    const Point reach{reach_x, reach_y};
    corner = d.in_box(place - reach, place + reach);
    if (one_in(d, 3)) {  // on the half-pixel lattice
      corner.x = corner.x / d.half() * d.half();
      corner.y = corner.y / d.half() * d.half();
    }
    if (one_in(d, 12)) corner = d.near(place, 0);  // inside the guard band
  }
  if (one_in(d, 6)) p[1].x = p[0].x;
  if (one_in(d, 6)) p[2].y = p[one_in(d, 2) ? 0 : 1].y;
  constexpr int64_t kMost = 1024;
  return samples_in_box(d, p) <= kMost ? p : figures::around(d, place, 4 * d.px());
}

// A value of a vertex: an end of the range, one of few, or any.
int64_t any_value(Draw& d, int64_t greatest, int kind) {
  if (kind == 0) return d.random().coin() ? greatest : 0;
  if (kind == 1) return d.random().between(0, 3) * (greatest / 3);
  return d.random().between(int64_t{0}, greatest);
}

// Values that depend on one coordinate alone, up or down, over the triangle's extent.
void along_an_axis(Draw& d, const Corners& p, int64_t greatest, std::array<int64_t, 3>* value) {
  const bool is_x = d.random().coin(), is_falling = d.random().coin();
  const auto at = [&](size_t i) { return is_x ? p[i].x : p[i].y; };
  const int64_t low = std::min({at(0), at(1), at(2)}), high = std::max({at(0), at(1), at(2)});
  if (high == low) return;
  const int64_t step = greatest / (high - low);
  for (size_t i = 0; i < 3; ++i) (*value)[i] = step * (is_falling ? high - at(i) : at(i) - low);
}

void any_triangle(Draw& d, const Corners& p) {
  std::array<Vertex, 3> v{d.vertex(p[0]), d.vertex(p[1]), d.vertex(p[2])};
  const int kind = d.random().between(0, 4);
  std::array<int64_t, 3> z{v[0].z, v[1].z, v[2].z};
  for (int64_t& value : z) value = any_value(d, d.far(), kind);
  if (kind == 3) along_an_axis(d, p, d.far(), &z);
  if (one_in(d, 4)) z[1] = z[2] = z[0];
  for (size_t i = 0; i < 3; ++i) v[i].z = z[i];
  const auto channels = static_cast<size_t>(spec::channels(d.contract().design));
  for (size_t a = 0; a < channels; ++a) {
    std::array<int64_t, 3> value{};
    const int kind_of_attribute = d.random().between(0, 4);
    for (int64_t& x : value) x = any_value(d, d.full(), kind_of_attribute);
    if (kind_of_attribute == 3) along_an_axis(d, p, d.full(), &value);
    for (size_t i = 0; i < 3; ++i) v[i].attr[a] = static_cast<int32_t>(value[i]);
  }
  d.add_shuffled(v);
}

void any(Draw& d) {
  any_state(d);
  const int triangles = d.random().between(1, 6);
  Corners p = any_corners(d);
  for (int i = 0; i < triangles; ++i) {
    if (!one_in(d, 3)) p = any_corners(d);  // else once more, with other values
    any_triangle(d, p);
  }
}

// As many stamps as are in flight, and some more, each of a triangle of its own.
void crowd(Draw& d) {
  any_state(d);
  const int64_t width = int64_t{1} << d.contract().design.stamp_width_log2;
  const int64_t height = int64_t{1} << d.contract().design.stamp_height_log2;
  const int addresses = d.random().between(1, 40);
  d.frame(static_cast<int>(8 * width), static_cast<int>(5 * height));
  for (int i = 0; i < 72; ++i) {
    const int64_t x = width * (i % addresses % 8), y = height * (i % addresses / 8);
    const Point corner = d.px() * Point{x, y};
    any_triangle(d,
                 {corner, corner + d.px() * Point{width, 0}, corner + d.px() * Point{0, height}});
  }
}

}  // namespace

std::vector<SceneClass> any_classes() { return {{"any", 0, any}, {"any_crowd", 0, crowd}}; }

}  // namespace pineda::vectors
