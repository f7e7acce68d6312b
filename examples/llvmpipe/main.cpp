// Draws a scene with Mesa's llvmpipe, off screen by OSMesa, and writes the frame for pineda judge:
//   draw_by_llvmpipe SCENE DIR
//   draw_by_llvmpipe --version     # of OpenGL and Mesa
//
// Positions are given to OpenGL as they are snapped to 1/256 px, which is what llvmpipe snaps to.
#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <vector>

#include "examples/llvmpipe/clip_space.h"
#include "examples/llvmpipe/gl.h"
#include "model/scene/writers.h"
#include "model/spec/clear_depth.h"

namespace {

using namespace pineda;
using llvmpipe::Context;
using llvmpipe::Gl;
using llvmpipe::Vertex;

/// All triangles of a scene in clip space.
std::vector<Vertex> clip_vertices(const scene::Scene& scene) {
  std::vector<Vertex> vertices;
  for (spec::Triangle triangle; scene.source->next(&triangle);) {
    for (const Vertex& v : llvmpipe::clip_vertices(scene, triangle)) vertices.push_back(v);
  }
  return vertices;
}

void set_state(const Gl& gl, const spec::FrameState& frame) {
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.Viewport(0, 0, frame.width, frame.height);
  gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.Enable(GL_SCISSOR_TEST);
  gl.FrontFace(GL_CW);  // since rows run down
  if (frame.cull != spec::Cull::kNone) {
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(frame.cull == spec::Cull::kBack ? GL_BACK : GL_FRONT);
  }
  if (frame.has_bias()) {
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    // A unit is r, which an implementation chooses; Mesa's is two codes, the scene's constant counts codes.
    gl.PolygonOffset(static_cast<float>(frame.bias_slope) / 256,
                     static_cast<float>(frame.bias_constant) / 2);
  }
}

void clear_and_draw(const Gl& gl, const spec::FrameState& frame, size_t vertices) {
  gl.Scissor(0, 0, frame.width, frame.height);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const int x = std::max(frame.clip_x0(), 0), y = std::max(frame.clip_y0(), 0);
  gl.Scissor(x, y, std::max(frame.clip_x1() - x, 0), std::max(frame.clip_y1() - y, 0));
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices));
}

scene::Frame drawn(const scene::Scene& scene) {
  const Context context;
  const Gl gl;
  const spec::FrameState& state = scene.frame;
  const auto vertices = clip_vertices(scene);
  bind_vertices(gl, 4, vertices.data(), vertices.size());

  const size_t samples = static_cast<size_t>(state.width) * static_cast<size_t>(state.height);
  scene::Frame frame;
  frame.width = state.width;
  frame.height = state.height;
  set_state(gl, state);

  // Depth and colour
  use_program(gl, state.shade == spec::Shade::kFlat ? "flat" : "smooth");
  bind_frame(gl, GL_RGBA8, state.width, state.height);
  static constexpr GLenum kFunctions[] = {GL_LESS,    GL_LEQUAL,   GL_ALWAYS, GL_NEVER, GL_EQUAL,
                                          GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(kFunctions[static_cast<size_t>(state.depth)]);
  gl.ClearDepth(state.clear_depth);
  gl.ClearColor(0, 0, 0, 0);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Scissor(0, 0, state.width, state.height);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.DepthMask(state.depth_write && state.depth != spec::DepthFunc::kOff ? GL_TRUE : GL_FALSE);
  clear_and_draw(gl, state, vertices.size());
  std::vector<uint8_t> rgba(4 * samples);
  gl.ReadPixels(0, 0, state.width, state.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  frame.color.assign(rgba.begin(), rgba.end());
  frame.depth.resize(samples);
  gl.ReadPixels(0, 0, state.width, state.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                frame.depth.data());
  for (uint32_t& code : frame.depth) code >>= 8;
  frame.clear_depth = spec::depth_code(state.clear_depth, 24);

  // Hits: 1 is added for each triangle, without a depth test.
  use_program(gl, "flat");
  bind_frame(gl, GL_R32F, state.width, state.height);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  std::vector<Vertex> ones = vertices;
  for (Vertex& vertex : ones) vertex.rgba[0] = 255;
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ones.size() * sizeof(Vertex)), ones.data(),
                GL_STATIC_DRAW);
  clear_and_draw(gl, state, ones.size());
  std::vector<float> hits(samples);
  gl.ReadPixels(0, 0, state.width, state.height, GL_RED, GL_FLOAT, hits.data());
  for (const float count : hits) {
    frame.hits.push_back(static_cast<uint16_t>(std::min(count, 65535.f)));
  }
  if (gl.GetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL has an error");
  return frame;
}

}  // namespace

int main(int argc, char** argv) {
  const bool asks_version = argc == 2 && std::string(argv[1]) == "--version";
  if (argc != 3 && !asks_version) {
    std::fputs("usage: draw_by_llvmpipe SCENE DIR, or draw_by_llvmpipe --version\n", stderr);
    return 2;
  }
  try {
    if (asks_version) {
      const Context context;
      fmt::print("{}\n", reinterpret_cast<const char*>(Gl().GetString(GL_VERSION)));
      return 0;
    }
    const auto contract = spec::contract(*spec::find_design("persp"));
    scene::write_dump(argv[2], drawn(scene::open_scene(contract, argv[1], {})));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_by_llvmpipe: %s\n", error.what());
    return 2;
  }
  return 0;
}
