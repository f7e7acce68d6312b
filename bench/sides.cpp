#include "bench/sides.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

namespace pineda::bench {
namespace {

// As the buffer holds it; OpenGL adds w = 1.
struct ClipVertex {
  float x, y, z;
  std::array<uint8_t, 4> rgba;
};
constexpr int kComponents = 3;
static_assert(sizeof(ClipVertex) == kComponents * sizeof(float) + 4);

ClipVertex clip_vertex(const scene::ScreenVertex& v) {
  return {2 * v.x / kWidth - 1, 2 * v.y / kHeight - 1, v.z, v.rgba};
}

}  // namespace

Llvmpipe::Settings::Settings() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("LP_NUM_THREADS", "0", 1);
}

Llvmpipe::Llvmpipe() {
  if (name().rfind("llvmpipe", 0) != 0) {
    throw std::runtime_error(fmt::format("expected OSMesa to draw with llvmpipe, got {}", name()));
  }
  gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl_.Viewport(0, 0, kWidth, kHeight);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_BLEND);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.ClearDepth(1);
  gl_.ClearColor(0, 0, 0, 0);
  llvmpipe::use_program(gl_, "noperspective");
  llvmpipe::bind_frame(gl_, GL_RGBA8, kWidth, kHeight);
  gl_.GenQueries(1, &query_);
}

std::string Llvmpipe::name() const {
  return fmt::format("{}, {}", reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER)),
                     reinterpret_cast<const char*>(gl_.GetString(GL_VERSION)));
}

void Llvmpipe::load(const std::vector<scene::ScreenTriangle>& triangles) {
  std::vector<ClipVertex> vertices;
  vertices.reserve(3 * triangles.size());
  for (const scene::ScreenTriangle& triangle : triangles) {
    for (const scene::ScreenVertex& v : triangle.v) vertices.push_back(clip_vertex(v));
  }
  gl_.DeleteBuffers(1, &buffer_);
  buffer_ = llvmpipe::bind_vertices(gl_, kComponents, vertices.data(), vertices.size());
  vertices_ = static_cast<GLsizei>(vertices.size());
}

Samples Llvmpipe::count() const {
  Samples samples;
  samples.covered = count(GL_ALWAYS);
  samples.passed = count(GL_LESS);
  return samples;
}

uint64_t Llvmpipe::count(GLenum depth_function) const {
  gl_.DepthFunc(depth_function);
  gl_.BeginQuery(GL_SAMPLES_PASSED, query_);
  clear_and_draw();
  gl_.EndQuery(GL_SAMPLES_PASSED);
  GLuint64 samples = 0;
  gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &samples);
  if (gl_.GetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL has an error");
  return samples;
}

void Llvmpipe::draw() const {
  clear_and_draw();
  gl_.Finish();
}

void Llvmpipe::clear_and_draw() const {
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl_.DrawArrays(GL_TRIANGLES, 0, vertices_);
}

Pineda::Pineda(const spec::Contract& contract)
    : contract_(contract),
      triangles_(contract, frame_state()),
      renderer_(contract, frame_state(), {}, fast::Renderer::Hits::kUncounted) {}

void Pineda::load(const std::vector<scene::ScreenTriangle>& triangles) {
  triangles_ = snapped(contract_, triangles);
}

Samples Pineda::count() {
  draw();
  const core::FrameCounters counters = renderer_.counters();
  return {counters.fragments, counters.passed};
}

void Pineda::draw() {
  renderer_.clear();
  renderer_.draw(triangles_);
}

}  // namespace pineda::bench
