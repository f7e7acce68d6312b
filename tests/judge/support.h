// What the tests of model/judge share: one triangle, stated and snapped, and its right samples.
#pragma once

#include <vector>

#include "model/judge/comparison.h"

namespace pineda::judge {

inline constexpr spec::FrameState kFrame{64, 48, spec::Cull::kNone, spec::DepthFunc::kLess};

/// The triangle as a scene states it, with w's apart and a colour that varies but for alpha.
inline exact::ScreenTriangle stated() {
  return {{{3.25f, 2.5f, .125f, 1, {10, 200, 30, 77}},
           {50.75f, 9.f, .5f, 2, {250, 100, 31, 77}},
           {11.f, 40.5f, .75f, 4, {90, 0, 32, 77}}}};
}

inline exact::ScreenJudge judge_of(const spec::Design& design = spec::kHighTile,
                                   const spec::FrameState& frame = kFrame) {
  return {stated(), format_of(design), exact_frame(frame)};
}

/// The triangle as the default design takes it.
inline spec::Triangle snapped() {
  spec::Triangle t;
  const exact::ScreenJudge judge = judge_of();
  for (size_t i = 0; i < 3; ++i) {
    const exact::Vertex& v = judge.snapped().vertices()[i];
    t.v[i].x = static_cast<int32_t>(v.x);
    t.v[i].y = static_cast<int32_t>(v.y);
    t.v[i].z = v.z;
    for (size_t k = 0; k < 4; ++k) t.v[i].attr[k] = v.attr[k];
    t.v[i].inverse_w = 1 << (spec::kHighTile.inverse_w_bits - 1);  // w = 1, 2, 4
    t.v[i].inverse_w_shift = static_cast<int32_t>(i);
  }
  return t;
}

/// All samples with the nearest codes, row by row; attributes from `smooth` on are flat, from the
/// first vertex.
inline std::vector<Drawn> nearest(const ScreenTruth& truth, const Values& values = {}) {
  std::vector<Drawn> all;
  for (const exact::Sample& s : truth.samples()) {
    Drawn drawn{s.x, s.y, s.z.nearest, {}};
    for (size_t i = 0; i < static_cast<size_t>(values.channels); ++i) {
      drawn.attr[i] = i < static_cast<size_t>(values.smooth)
                          ? static_cast<int32_t>(truth.attribute(s, i, values.perspective).nearest)
                          : truth.flat()[i];
    }
    all.push_back(drawn);
  }
  return all;
}

}  // namespace pineda::judge
