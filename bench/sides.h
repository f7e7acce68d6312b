// The two sides of the comparison: each draws the same triangles to a frame of its own.
#pragma once

#include <string>
#include <vector>

#include "bench/scenes.h"
#include "examples/llvmpipe/gl.h"
#include "model/fast/renderer.h"

namespace pineda::bench {

/// What a frame's triangles leave, as each side counts it.
struct Samples {
  uint64_t covered = 0;  // by any triangle, each time
  uint64_t passed = 0;   // the depth test
};

/// Mesa's llvmpipe. One object in a program, since it is one context of OpenGL.
class Llvmpipe {
 public:
  /// Errors   std::runtime_error where OSMesa draws with something else.
  Llvmpipe();

  /// "llvmpipe (...), 4.5 (Core Profile) Mesa ...".
  std::string name() const;
  /// Copies the triangles to a buffer that OpenGL draws from.
  void load(const std::vector<scene::ScreenTriangle>& triangles);
  Samples count() const;
  /// Clears, draws and waits until it is done.
  void draw() const;

 private:
  uint64_t count(GLenum depth_function) const;
  void clear_and_draw() const;

  /// What Mesa reads when it makes a context: this driver, no threads beside the caller's.
  struct Settings {
    Settings();
  };
  Settings settings_;
  llvmpipe::Context context_;
  llvmpipe::Gl gl_;
  GLuint buffer_ = 0;
  GLuint query_ = 0;
  GLsizei vertices_ = 0;
};

/// The quick model.
class Pineda {
 public:
  explicit Pineda(const spec::Contract& contract);

  void load(const std::vector<scene::ScreenTriangle>& triangles);
  Samples count();
  void draw();

 private:
  spec::Contract contract_;
  fast::TriangleList triangles_;
  fast::Renderer renderer_;
};

}  // namespace pineda::bench
