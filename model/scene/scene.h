// Opens a scene by name or path: the entry point of this folder.
#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/camera.h"
#include "model/scene/error.h"
#include "model/scene/mesh_reader.h"
#include "model/scene/snap.h"
#include "model/scene/state.h"

namespace pineda::scene {

struct Size {
  int width = 640;
  int height = 480;
};

/// In px; width and height are not negative. It may reach beyond the frame on every side.
struct Scissor {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Options for opening a scene. An option that does not apply to the scene is an error, not
/// ignored.
struct Options {
  // For meshes and built-in scenes; .tri, .ptrb and hard cases define these themselves
  std::optional<Size> size;  // default 640x480, `triangle` 64x64
  std::optional<spec::Cull> cull;
  std::optional<spec::DepthFunc> depth;
  std::optional<Scissor> scissor;
  std::optional<bool> depth_write;
  std::optional<DepthBias> depth_bias;  // |constant| < 2^depth_bits
  std::optional<float> clear_depth;     // 0 to 1
  std::optional<spec::Shade> shade;
  // Meshes only: depth is 1 at the near plane. Then `depth` defaults to greater and `clear_depth`
  // to 0.
  bool reverse_z = false;
  std::optional<Camera> camera;      // meshes only; default: framing_view()
  std::optional<int> camera_number;  // index in Mesh::camera; .gltf, .glb only; without `camera`

  std::optional<int> tessellate;  // `teapot` only: quads along a patch's side, default 10
  uint64_t seed = 0;              // of random scenes
  bool multi_pass = false;        // rewind() must work, so a pipe is copied to a temporary file
  std::istream* input = nullptr;  // the stream for "-"; nullptr: standard input
};

struct Scene {
  std::string name;
  spec::FrameState frame;
  std::unique_ptr<SnappedSource> source;
  std::shared_ptr<const ClipMesh> mesh;  // the mesh that `source` draws, unclipped; null: none
  std::vector<std::string> warnings;     // found while opening, one line each
};

/// In       a path that ends in .tri, .ptrb, .obj, .ply, .gltf or .glb; "-" for a .ptrb on standard
///          input; or teapot, triangle, grid, layers, random/NAME or hard/NAME, as
///          built_in_scenes() lists them.
/// Errors   InputError, one line, for everything that is wrong with the name, the options or the
///          file. A .tri line or a .ptrb vertex may be found wrong only by next().
Scene open_scene(const spec::Contract& contract, const std::string& name, const Options& options);

/// A scene that needs no file.
struct BuiltIn {
  std::string name;  // as open_scene() takes it
  std::string summary;
  std::string right_answer;  // of a hard case; else empty
};
std::vector<BuiltIn> built_in_scenes();

/// Notes for the user, one sentence each: what was dropped or changed so far, and what this design
/// cannot draw as the scene states it.
std::vector<std::string> notes(const spec::Design& design, const spec::FrameState& frame,
                               const Counters& counters);
std::vector<std::string> notes(const Scene& scene);

}  // namespace pineda::scene
