#include "model/scene/tri_writer.h"

#include <fmt/format.h>

#include "model/spec/names.h"

namespace pineda::scene {

std::string tri_state(const spec::FrameState& f) {
  std::string text = fmt::format("size {} {}\ncull {}\ndepth {}\n", f.width, f.height,
                                 spec::name_of(f.cull), spec::name_of(f.depth));
  if (f.scissor_x1 != spec::kNoScissorPx || f.scissor_y1 != spec::kNoScissorPx ||
      f.scissor_x0 != 0 || f.scissor_y0 != 0) {
    text += fmt::format("scissor {} {} {} {}\n", f.scissor_x0, f.scissor_y0,
                        f.scissor_x1 - f.scissor_x0, f.scissor_y1 - f.scissor_y0);
  }
  text += fmt::format("depthwrite {}\n", spec::name_of(f.depth_write));
  if (f.has_bias()) text += fmt::format("depthbias {} {}\n", f.bias_constant, f.bias_slope / 256.);
  if (f.clear_depth != 1) {
    text += fmt::format("cleardepth {}\n", static_cast<float>(f.clear_depth));
  }
  return text + fmt::format("shade {}\n", spec::name_of(f.shade));
}

std::string tri_vertices(const ScreenTriangle& triangle) {
  std::string text;
  for (const ScreenVertex& v : triangle.v) {
    text += fmt::format("v {} {} {} {} {} {} {} {}\n", v.x, v.y, v.z, v.w, v.rgba[0], v.rgba[1],
                        v.rgba[2], v.rgba[3]);
  }
  return text;
}

std::string tri_text(const spec::FrameState& frame, const std::vector<ScreenTriangle>& triangles) {
  std::string text = "pineda-tri 1\n" + tri_state(frame);
  for (const ScreenTriangle& triangle : triangles) text += tri_vertices(triangle);
  return text;
}

}  // namespace pineda::scene
