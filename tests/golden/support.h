// What the tests of the C interface share: scenes of the project, as the interface takes them.
#pragma once

#include <gtest/gtest.h>
#include <pineda/golden.h>

#include <memory>
#include <string>
#include <vector>

#include "model/core/frame.h"
#include "model/scene/scene.h"

namespace pineda::test {

#define EXPECT_OK(call) EXPECT_EQ(call, PINEDA_OK) << pineda_last_error()
#define ASSERT_OK(call) ASSERT_EQ(call, PINEDA_OK) << pineda_last_error()

struct Close {
  void operator()(pineda_model* model) const { pineda_close(model); }
};
using Model = std::unique_ptr<pineda_model, Close>;

inline Model open_model(const std::string& design) {
  pineda_model* model = nullptr;
  EXPECT_OK(pineda_open(design.c_str(), &model));
  return Model(model);
}

inline pineda_frame stated(const spec::FrameState& state) {
  pineda_frame frame = pineda_default_frame(state.width, state.height);
  frame.cull = static_cast<int32_t>(state.cull);
  frame.depth_func = static_cast<int32_t>(state.depth);
  frame.depth_write = state.depth_write ? 1 : 0;
  frame.shade = static_cast<int32_t>(state.shade);
  frame.has_scissor = 1;
  frame.scissor_x = state.scissor_x0;
  frame.scissor_y = state.scissor_y0;
  frame.scissor_width = state.scissor_x1 - state.scissor_x0;
  frame.scissor_height = state.scissor_y1 - state.scissor_y0;
  frame.bias_slope = state.bias_slope;
  frame.bias_constant = state.bias_constant;
  frame.clear_depth = state.clear_depth;
  return frame;
}

inline pineda_triangle stated(const spec::Triangle& from) {
  pineda_triangle to{};
  to.id = from.id;
  for (size_t i = 0; i < 3; ++i) {
    to.v[i].x = from.v[i].x;
    to.v[i].y = from.v[i].y;
    to.v[i].z = from.v[i].z;
    for (size_t a = 0; a < spec::kMaxAttributes; ++a) to.v[i].attr[a] = from.v[i].attr[a];
    to.v[i].inverse_w = from.v[i].inverse_w;
    to.v[i].inverse_w_shift = from.v[i].inverse_w_shift;
  }
  return to;
}

inline pineda_screen_triangle stated(const scene::ScreenTriangle& from) {
  pineda_screen_triangle to{};
  to.id = from.id;
  for (size_t i = 0; i < 3; ++i) {
    const scene::ScreenVertex& v = from.v[i];
    to.v[i] = {v.x, v.y, v.z, v.w, {v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]}};
  }
  return to;
}

/// A built-in scene in a design's formats, and what core draws of it.
struct DrawnScene {
  DrawnScene(const spec::Contract& contract, const std::string& name) {
    const scene::Scene scene = scene::open_scene(contract, name, {});
    frame = scene.frame;
    core::Renderer renderer(contract, frame);
    for (spec::Triangle t; scene.source->next(&t);) {
      snapped.push_back(t);
      triangles.push_back(stated(t));
      screen.push_back(stated(scene.source->screen()));
      renderer.draw(t);
    }
    buffer = renderer.buffer();
  }

  spec::FrameState frame;
  std::vector<spec::Triangle> snapped;
  std::vector<pineda_triangle> triangles;
  std::vector<pineda_screen_triangle> screen;
  core::FrameBuffer buffer;
};

}  // namespace pineda::test
