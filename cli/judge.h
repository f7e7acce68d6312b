// The functional model's samples before the exact judge.
#pragma once

#include <functional>

#include "model/core/frame.h"

namespace pineda::cli {

/// What exact arithmetic says of a frame: every covered sample of every triangle, hidden ones too.
/// Depth and colour are judged against the snapped vertices.
struct Judgement {
  uint64_t samples = 0;  // judged
  uint64_t missing = 0;  // exact covers, the model does not
  uint64_t extra = 0;    // the model covers, exact does not
  double max_depth_ulp = 0;
  double max_color_lsb = 0;
};

/// Draws all triangles on `renderer` and judges them.
Judgement judge(const std::function<bool(spec::Triangle*)>& next, core::Renderer* renderer);

}  // namespace pineda::cli
