// Raster state and perspective: what a frame or a vertex says beyond position, depth and colour.
#include <algorithm>
#include <array>

#include "model/spec/clear_depth.h"
#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

using spec::DepthFunc;
using spec::Vertex;

// Triangles whose depths are few, so that many samples are equal.
void add_few_depths(Draw& d, int count) {
  for (int i = 0; i < count; ++i) {
    const int64_t z = d.random().between(0, 3) * (d.far() / 3);
    const auto vertex = [&] {
      Vertex v = d.vertex(d.point(0, 0, 8, 8));
      v.z = z;
      return v;
    };
    d.add_shuffled({vertex(), vertex(), vertex()});
  }
}

// Each function in turn, depth writes on and off.
void depth_function(Draw& d) {
  d.frame(8, 8);
  d.scene().frame.depth = static_cast<DepthFunc>(d.index() % 9);
  d.scene().frame.depth_write = d.index() / 9 % 2 == 0;
  add_few_depths(d, 6);
}

// Each cull state with each function and write, on depths cleared to a code: some triangles lie within
// a few codes of it, so that of a stamp some samples are nearer, equal and farther.
void state(Draw& d) {
  d.frame(8, 8);
  spec::FrameState& f = d.scene().frame;
  f.cull = static_cast<spec::Cull>(d.index() % 3);
  f.depth = static_cast<DepthFunc>(d.index() / 3 % 9);
  f.depth_write = d.index() / 27 % 2 == 0;
  constexpr int64_t kCode = int64_t{1} << spec::kDepthInputFractionBits;
  const int64_t code = d.far() / kCode / 3;
  f.clear_depth = spec::depth_of_code(static_cast<uint32_t>(code), d.contract().design.depth_bits);
  for (int i = 0; i < 4; ++i) {
    const auto vertex = [&] {
      Vertex v = d.vertex(d.point(0, 0, 8, 8));
      const int64_t off = d.random().between(-2 * kCode, 2 * kCode);
      v.z = std::max<int64_t>(code * kCode + off, 0);
      return v;
    };
    d.add_shuffled({vertex(), vertex(), vertex()});
  }
  add_few_depths(d, 4);
}

// Borders through stamps and tiles, beyond the frame, an empty one.
void scissor(Draw& d) {
  d.frame(20, 18);
  spec::FrameState& frame = d.scene().frame;
  frame.scissor_x0 = d.random().between(0, 12);
  frame.scissor_y0 = d.random().between(0, 12);
  frame.scissor_x1 = frame.scissor_x0 + static_cast<int>(d.random().between(d.index() % 3, 12));
  frame.scissor_y1 = frame.scissor_y0 + static_cast<int>(d.random().between(d.index() % 3, 12));
  d.add({d.point(-40, -40, -1, -1), d.point(60, -20, 80, 5), d.point(-30, 60, 10, 90)});
  for (int i = 0; i < 3; ++i) {
    d.add({d.point(0, 0, 20, 18), d.point(0, 0, 20, 18), d.point(0, 0, 20, 18)});
  }
}

// Constants and slopes small and at the ends of their range, on flat planes and on cliffs.
void depth_bias(Draw& d) {
  d.frame(8, 8);
  spec::FrameState& frame = d.scene().frame;
  frame.depth = d.random().coin() ? DepthFunc::kLequal : DepthFunc::kGequal;
  const int64_t top = d.far() >> spec::kDepthInputFractionBits;
  const int64_t reach = d.index() % 3 == 0 ? top : 1000;
  frame.bias_constant = d.index() % 4 == 1 ? 0 : d.random().between(-reach, reach);
  frame.bias_slope = static_cast<int32_t>(d.index() % 4 == 2   ? 0
                                          : d.index() % 3 == 0 ? d.random().between(-32768, 32767)
                                                               : d.random().between(-512, 512));
  if (d.index() % 4 == 3) frame.bias_slope = d.random().coin() ? -32768 : 32767;
  add_few_depths(d, 2);
  for (int i = 0; i < 3; ++i) {
    d.add({d.point(-9, -9, 17, 17), d.point(-9, -9, 17, 17), d.point(-9, -9, 17, 17)});
  }
}

// The first vertex gives the colours, whichever is the anchor.
void flat_shading(Draw& d) {
  d.frame(8, 8);
  d.scene().frame.shade = spec::Shade::kFlat;
  for (int i = 0; i < 4; ++i) {
    d.add({d.point(0, 0, 8, 8), d.point(0, 0, 8, 8), d.point(0, 0, 8, 8)});
  }
}

// Each function twice, on depth cleared to the nearest, to one of the depths that are drawn, next
// to the farthest, or to any: what is nearer and what is farther than the cleared depth is drawn.
void clear_depth(Draw& d) {
  d.frame(8, 8);
  spec::FrameState& frame = d.scene().frame;
  frame.depth = static_cast<DepthFunc>(d.index() % 9);
  const int64_t top = d.far() >> spec::kDepthInputFractionBits;
  const std::array<int64_t, 5> codes{0, top / 3, top - 1, d.random().between(0, top - 1),
                                     top / 3 * 2};
  const auto code =
      static_cast<uint32_t>(codes[static_cast<size_t>(d.index() + d.index() / 9) % 5]);
  frame.clear_depth = spec::depth_of_code(code, d.contract().design.depth_bits);
  add_few_depths(d, 4);
}

// Frames and scissors of every length in bits, wide or high: triangles hang over their far border, and
// only there is a sample drawn.
void far_border(Draw& d, bool by_scissor) {
  const int lengths = d.contract().design.guard_bits + 1;
  const int length = d.index() % lengths;  // bits below the first one
  const int limit = 1 << d.contract().design.guard_bits;
  const int far =
      std::min((1 << length) + static_cast<int>(d.random().between(0, (1 << length) - 1)), limit);
  const int low = static_cast<int>(d.random().between(1, 3));
  const bool is_wide = d.index() / lengths % 2 == 0;
  spec::FrameState& frame = d.scene().frame;
  const int side = by_scissor ? std::min(2 * far, limit) : far;
  d.frame(is_wide ? side : low, is_wide ? low : side);
  if (by_scissor) {
    (is_wide ? frame.scissor_x1 : frame.scissor_y1) = far;
    (is_wide ? frame.scissor_x0 : frame.scissor_y0) = far - std::min(far, 5);
  }
  for (int i = 0; i < 4; ++i) {
    const int border = by_scissor && i % 2 == 0 ? far - std::min(far, 5) : far;
    const Point middle{is_wide ? border : low / 2, is_wide ? low / 2 : border};
    d.add(figures::around(d, d.px() * middle, 3 * d.px()));
  }
}
void frame_border(Draw& d) { far_border(d, false); }
void scissor_border(Draw& d) { far_border(d, true); }

// A frame and a triangle over all of it: each stamp is sent, one after the other.
void full_frame(Draw& d, int64_t width, int64_t height) {
  d.frame(static_cast<int>(width), static_cast<int>(height));
  d.scene().frame.depth = DepthFunc::kLequal;
  d.add({Point{-d.reach(2 * width), -d.px()}, Point{d.reach(3 * width), -d.px()},
         Point{0, d.reach(4 * height)}});
}
// More stamps than wait for their depths when a port stalls.
void many_stamps(Draw& d) {
  full_frame(d, 8 << d.contract().design.stamp_width_log2,
             8 << d.contract().design.stamp_height_log2);
}
// Every unit is at work when the frame is reset; the cycles of these scenes are in a row. Depths in the far
// half of what is nearer passes: the frame that is begun, whose depths are turned over, is drawn, and the one
// after the reset is not, so nothing hides what is left of the first.
void reset_at_work(Draw& d) {
  full_frame(d, 32, 8);
  spec::FrameState& frame = d.scene().frame;
  const int64_t top = d.far() >> spec::kDepthInputFractionBits;
  frame.depth = DepthFunc::kLess;
  frame.clear_depth =
      spec::depth_of_code(static_cast<uint32_t>(top / 2), d.contract().design.depth_bits);
  for (spec::Vertex& vertex : d.scene().triangles.back().v) {
    vertex.z = std::max(vertex.z, d.far() - vertex.z);
  }
  d.scene().reset_cycle = static_cast<uint64_t>(40 + 5 * d.index() + d.random().between(0, 4));
}

}  // namespace

std::vector<SceneClass> state_classes() {
  return {{"depth_function", 18, depth_function}, {"scissor", 9, scissor},
          {"depth_bias", 12, depth_bias},         {"flat_shading", 3, flat_shading},
          {"clear_depth", 18, clear_depth},       {"state", 54, state},
          {"frame_border", 30, frame_border},     {"scissor_border", 30, scissor_border},
          {"many_stamps", 8, many_stamps},        {"reset_at_work", 24, reset_at_work}};
}

}  // namespace pineda::vectors
