// Hard cases of raster state: scissor, depth functions, depth write, depth bias, cleared depth,
// flat shading.
#include "model/scene/hard/draw.h"

namespace pineda::scene::hard {
namespace {

using spec::DepthFunc;
using spec::FrameState;

// A scissor whose borders cut tiles and stamps.
constexpr FrameState scissored() {
  FrameState f = kGridFrame;
  f.scissor_x0 = 13;
  f.scissor_y0 = 7;
  f.scissor_x1 = 51;
  f.scissor_y1 = 36;
  return f;
}

std::vector<ScreenTriangle> under_scissor() { return grid(50, 1733, 1); }

// Only four depths, so that many are equal; one is the far end, which is the clear depth.
std::vector<ScreenTriangle> few_depths() {
  Drawing d(51);
  for (int i = 0; i < 60; ++i) {
    const Point a = d.in_box({0, 0}, {32 * kPx, 32 * kPx});
    const Point b = d.near(a, 16 * kPx);
    const Point c = d.near(a, 16 * kPx);
    d.add_flat({a, b, c}, static_cast<float>(d.random().between(1, 4)) / 4);
  }
  return d.triangles();
}

constexpr FrameState few_depths_frame(DepthFunc func, bool depth_write) {
  FrameState f = frame(32, 32, func);
  f.depth_write = depth_write;
  return f;
}

// The same with five depths, which include both ends of the range.
std::vector<ScreenTriangle> few_depths_from_0() {
  Drawing d(54);
  for (int i = 0; i < 60; ++i) {
    const Point a = d.in_box({0, 0}, {32 * kPx, 32 * kPx});
    const Point b = d.near(a, 16 * kPx);
    const Point c = d.near(a, 16 * kPx);
    d.add_flat({a, b, c}, static_cast<float>(d.random().between(0, 4)) / 4);
  }
  return d.triangles();
}

constexpr FrameState cleared(FrameState f, double depth) {
  f.clear_depth = depth;
  return f;
}

constexpr FrameState biased(int64_t constant, int32_t slope) {
  FrameState f = frame(64, 48);
  f.bias_constant = constant;
  f.bias_slope = slope;
  return f;
}

constexpr FrameState reversed(FrameState f) {
  f.depth = DepthFunc::kGreater;
  return f;
}

// Triangles from level to so steep that depth runs through all codes within some pixels. The depths
// of every third triangle are near an end of the range, and the bias carries them beyond it.
std::vector<ScreenTriangle> slopes() {
  Drawing d(52);
  for (int i = 0; i < 36; ++i) {
    const float range = i % 4 == 0 ? 0 : i % 4 == 1 ? .001f : i % 4 == 2 ? .1f : 1;
    const float low = d.random().uniform(0, 1 - range);
    std::array<ScreenVertex, 3> v;
    for (ScreenVertex& corner : v) {
      corner = d.vertex(d.in_box({-8 * kPx, -8 * kPx}, {72 * kPx, 56 * kPx}));
      corner.z = low + range * corner.z;
      if (i % 3 == 1) corner.z *= 3e-5f;
      if (i % 3 == 2) corner.z = 1 - corner.z * 3e-5f;
    }
    d.add_shuffled(v);
  }
  return d.triangles();
}

constexpr FrameState flat() {
  FrameState f = frame(64, 48);
  f.shade = spec::Shade::kFlat;
  return f;
}

std::vector<ScreenTriangle> flat_shading() {
  Drawing d(53);
  for (int i = 0; i < 24; ++i) {
    std::array<ScreenVertex, 3> v;
    for (ScreenVertex& corner : v) {
      corner = d.vertex(d.in_box({-8 * kPx, -8 * kPx}, {72 * kPx, 56 * kPx}));
      corner.w = i % 2 == 0 ? 1 : d.random().uniform(1, 1000);
    }
    d.add_shuffled(v);
  }
  return d.triangles();
}

}  // namespace

std::vector<HardCase> state_cases() {
  return {
      {"scissor", "a mesh over a scissor whose borders cut tiles and stamps",
       "every sample inside is hit exactly once, none outside", scissored(), under_scissor},
      {"depth_notequal", "overlapping triangles of few depths; depth notequal",
       "one at the depth that is stored is not seen, any other is",
       few_depths_frame(DepthFunc::kNotequal, true), few_depths},
      {"depth_gequal", "the same with depth gequal",
       "what lies at the far end is seen, the last of it in front; nothing nearer ever is",
       few_depths_frame(DepthFunc::kGequal, true), few_depths},
      {"depth_write_off", "the same with depth less that is not written",
       "the last one nearer than the far end is seen; depths stay cleared",
       few_depths_frame(DepthFunc::kLess, false), few_depths},
      {"depth_bias_near", "level to steep triangles, biased nearer by 300 codes and 1.75 slopes",
       "within the bound and the slope's; codes stop at 0", biased(-300, -448), slopes},
      {"depth_bias_far", "the same, biased farther by 77 codes and 2.5 slopes",
       "within the bound and the slope's; codes stop at the greatest", biased(77, 640), slopes},
      {"reversed_z", "overlapping triangles of few depths; depth greater, cleared to 0",
       "the one of the greatest depth is seen, the first of equal ones; what lies at 0 is not",
       cleared(few_depths_frame(DepthFunc::kGreater, true), 0), few_depths_from_0},
      {"reversed_z_gequal", "the same with depth gequal",
       "the one of the greatest depth is seen, the last of equal ones; what lies at 0 is, too",
       cleared(few_depths_frame(DepthFunc::kGequal, true), 0), few_depths_from_0},
      {"reversed_z_slopes", "level to steep triangles; depth greater, cleared to 0, biased nearer",
       "within the bound and the slope's; the one of the greatest depth is seen",
       cleared(reversed(biased(300, 448)), 0), slopes},
      {"clear_depth", "overlapping triangles of few depths; depth less, cleared to .75",
       "what is nearer than .75 is seen, the nearest in front; nothing else ever is",
       cleared(few_depths_frame(DepthFunc::kLess, true), .75), few_depths_from_0},
      {"flat_shading", "vertices of three colours, in any order, with and without perspective",
       "every sample has exactly the colour of its triangle's first vertex", flat(), flat_shading},
  };
}

}  // namespace pineda::scene::hard
