#include "model/scene/scene.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "model/scene/builtin/builtin.h"
#include "model/scene/hard/cases.h"
#include "model/scene/mesh_reader.h"
#include "model/scene/readers/gltf/reader.h"
#include "model/scene/readers/lines.h"
#include "model/scene/readers/obj_reader.h"
#include "model/scene/readers/ply_reader.h"
#include "model/scene/readers/ptrb_reader.h"
#include "model/scene/readers/tri_reader.h"

namespace pineda::scene {
namespace {

constexpr std::string_view kHard = "hard/";      // prefix of a hard case's name
constexpr std::string_view kRandom = "random/";  // prefix of a random scene's name
constexpr int kDefaultTessellation = 10;
constexpr int kGreatestTessellation = 256;  // 4.2 million triangles

void refuse(const std::string& name, bool given, const char* option, const char* where) {
  if (given) throw InputError(name, fmt::format("expected no {}: {}", option, where));
}

void refuse_frame_options(const std::string& name, const Options& options,
                          const char* own = "the file states its own") {
  refuse(name, options.size.has_value(), "size option", own);
  refuse(name, options.cull.has_value(), "cull option", own);
  refuse(name, options.depth.has_value(), "depth option", own);
  refuse(name, options.scissor.has_value(), "scissor option", own);
  refuse(name, options.depth_write.has_value(), "depth write option", own);
  refuse(name, options.depth_bias.has_value(), "depth bias option", own);
  refuse(name, options.clear_depth.has_value(), "clear depth option", own);
  refuse(name, options.shade.has_value(), "shade option", own);
}

void check_size(const spec::Contract& contract, const std::string& name, Size size) {
  const int greatest = 1 << contract.design.guard_bits;
  if (size.width < 1 || size.width > greatest || size.height < 1 || size.height > greatest) {
    throw InputError(name, fmt::format("expected a size of 1x1 to {0}x{0}, got {1}x{2}", greatest,
                                       size.width, size.height));
  }
}

spec::FrameState frame_of(const spec::Contract& contract, const std::string& name,
                          const Options& options, Size fallback) {
  const Size size = options.size.value_or(fallback);
  check_size(contract, name, size);
  spec::FrameState frame;
  frame.width = size.width;
  frame.height = size.height;
  frame.cull = options.cull.value_or(spec::Cull::kNone);
  frame.depth = options.depth.value_or(options.reverse_z ? spec::DepthFunc::kGreater
                                                         : spec::DepthFunc::kLess);
  if (const auto& s = options.scissor) set_scissor(s->x, s->y, s->width, s->height, &frame);
  frame.depth_write = options.depth_write.value_or(true);
  if (options.depth_bias) {
    frame.bias_constant = options.depth_bias->constant;
    frame.bias_slope = options.depth_bias->slope.units;
  }
  frame.clear_depth = options.clear_depth.value_or(options.reverse_z ? 0.0f : 1.0f);
  frame.shade = options.shade.value_or(spec::Shade::kSmooth);
  return frame;
}

Scene snapped(const spec::Contract& contract, const std::string& name,
              const spec::FrameState& frame, std::unique_ptr<ScreenReader> reader,
              bool rounded_slope = false) {
  Scene scene;
  scene.name = name;
  scene.frame = frame;
  Counters start;
  start.rounded_slope = rounded_slope ? 1 : 0;
  scene.source = std::make_unique<SnappedSource>(contract, std::move(reader), start);
  return scene;
}

bool rounded_slope(const Options& options) {
  return options.depth_bias && options.depth_bias->slope.rounded;
}

Scene open_tri(const spec::Contract& contract, const std::string& path) {
  auto reader = std::make_unique<TriReader>(contract, path, open_file(path));
  const auto frame = reader->frame();
  const bool rounded = reader->rounded_slope();
  return snapped(contract, std::filesystem::path(path).stem().string(), frame, std::move(reader),
                 rounded);
}

// A pipe that holds more lets its two ends work side by side with fewer stops. Where there is no
// pipe, or the system allows no more, nothing changes.
void widen_standard_input() {
#ifdef F_SETPIPE_SZ
  ::fcntl(STDIN_FILENO, F_SETPIPE_SZ, 1 << 20);
#endif
}

Scene open_ptrb(const spec::Contract& contract, const std::string& path, const Options& options) {
  const bool is_standard_input = path == "-";
  const std::string file = is_standard_input ? "standard input" : path;
  std::shared_ptr<std::istream> stream;
  std::optional<uint64_t> bytes;
  if (is_standard_input) {
    if (options.input == nullptr) widen_standard_input();
    // Not owned, so the deleter does nothing.
    stream = {options.input != nullptr ? options.input : &std::cin, [](std::istream*) {}};
  } else {
    stream = open_file(path);
    std::error_code none;
    if (std::filesystem::is_regular_file(path, none)) {
      const auto size = std::filesystem::file_size(path, none);
      if (!none) bytes = size;
    }
  }
  if (!bytes && options.multi_pass) {
    uint64_t spooled = 0;
    stream = spool_ptrb(contract, file, *stream, &spooled);
    bytes = spooled;
  }
  auto reader = std::make_unique<PtrbReader>(contract, file, stream, bytes);
  const auto frame = reader->frame();
  const auto name = is_standard_input ? "stdin" : std::filesystem::path(path).stem().string();
  return snapped(contract, name, frame, std::move(reader));
}

View view_of(const std::string& name, const Mesh& mesh, const Options& options, int width,
             int height) {
  try {
    if (options.camera) return camera_view(*options.camera, mesh, width, height);
    if (!options.camera_number) return framing_view(mesh, width, height);
    const int number = *options.camera_number;
    if (number < 0 || static_cast<size_t>(number) >= mesh.camera.size()) {
      throw InputError(
          name, fmt::format("expected one of {} cameras, got {}", mesh.camera.size(), number));
    }
    return file_view(mesh.camera[static_cast<size_t>(number)], width, height);
  } catch (const std::invalid_argument& error) {
    throw InputError(name, error.what());
  }
}

Scene open_mesh(const spec::Contract& contract, const std::string& name, Mesh mesh,
                const Options& options) {
  const auto frame = frame_of(contract, name, options, Size{});
  View view = view_of(name, mesh, options, frame.width, frame.height);
  view.is_reversed = options.reverse_z;
  const auto seen = std::make_shared<const ClipMesh>(clip_mesh(std::move(mesh), view));
  Scene scene =
      snapped(contract, std::filesystem::path(name).stem().string(), frame,
              std::make_unique<MeshReader>(seen, frame, contract), rounded_slope(options));
  scene.mesh = seen;
  return scene;
}

using MeshFileReader = Mesh (*)(const std::string& file, std::vector<std::string>* warnings);

// The reader for a file name's ending; nullptr if it is no mesh format.
MeshFileReader mesh_file_reader(const std::string& ending) {
  if (ending == ".obj") return read_obj;
  if (ending == ".ply") return read_ply;
  if (ending == ".gltf" || ending == ".glb") return read_gltf;
  return nullptr;
}

Scene open_mesh_file(const spec::Contract& contract, const std::string& path,
                     const Options& options, MeshFileReader read) {
  std::vector<std::string> warnings;
  Mesh mesh = read(path, &warnings);
  if (!mesh.camera.empty() && !options.camera_number) {
    warnings.push_back(
        fmt::format("{}: {} cameras not used (--camera N takes one)", path, mesh.camera.size()));
  }
  Scene scene = open_mesh(contract, path, std::move(mesh), options);
  scene.warnings = std::move(warnings);
  return scene;
}

Scene open_teapot(const spec::Contract& contract, const std::string& name, const Options& options) {
  const int n = options.tessellate.value_or(kDefaultTessellation);
  if (n < 1 || n > kGreatestTessellation) {
    throw InputError(name, fmt::format("expected a tessellation from 1 to {}, got {}",
                                       kGreatestTessellation, n));
  }
  return open_mesh(contract, name, teapot(n), options);
}

template <class Make>
Scene open_list(const spec::Contract& contract, const std::string& name, const Options& options,
                Size fallback, Make make) {
  const auto frame = frame_of(contract, name, options, fallback);
  return snapped(contract, name, frame,
                 std::make_unique<ListReader>(make(frame.width, frame.height)),
                 rounded_slope(options));
}

Scene open_random(const spec::Contract& contract, const std::string& name, const Options& options) {
  std::string known;
  for (const RandomScene& random : kRandomScenes) {
    if (name.substr(kRandom.size()) == random.name) {
      return open_list(contract, name, options, Size{}, [&](int width, int height) {
        return random_triangles(random, width, height, options.seed);
      });
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", random.name);
  }
  throw InputError(name, fmt::format("expected {}NAME, one of {}", kRandom, known));
}

Scene open_hard(const spec::Contract& contract, const std::string& name, const Options& options) {
  const HardCase* hard_case = find_hard_case(name.substr(kHard.size()));
  if (hard_case == nullptr) {
    std::string known;
    for (const auto& other : hard_cases()) {
      known += fmt::format("{}{}", known.empty() ? "" : ", ", other.name);
    }
    throw InputError(name, fmt::format("expected {}NAME, one of {}", kHard, known));
  }
  refuse_frame_options(name, options, "the case states its own");
  check_size(contract, name, {hard_case->frame.width, hard_case->frame.height});
  return snapped(contract, name, hard_case->frame, std::make_unique<ListReader>(hard_case->make()));
}

}  // namespace

Scene open_scene(const spec::Contract& contract, const std::string& name, const Options& options) {
  const std::string ending = std::filesystem::path(name).extension().string();
  const MeshFileReader read_mesh = mesh_file_reader(ending);
  const bool is_mesh = read_mesh != nullptr || name == "teapot";
  refuse(name, options.tessellate && name != "teapot", "tessellation", "it is for teapot");
  refuse(name, options.camera && !is_mesh, "camera", "it is for meshes");
  refuse(name, options.reverse_z && !is_mesh, "reversed z", "it is for meshes");
  refuse(name, options.camera_number && read_mesh != read_gltf, "camera of the file",
         "only .gltf and .glb have them");
  refuse(name, options.camera_number && options.camera, "camera of the file", "another is given");
  if (name == "teapot") return open_teapot(contract, name, options);
  if (name == "triangle") return open_list(contract, name, options, {64, 64}, single_triangle);
  if (name == "grid") return open_list(contract, name, options, Size{}, jittered_grid);
  if (name == "layers") return open_list(contract, name, options, Size{}, layered_grids);
  if (read_mesh != nullptr) return open_mesh_file(contract, name, options, read_mesh);
  if (ending == ".tri") {
    refuse_frame_options(name, options);
    return open_tri(contract, name);
  }
  if (ending == ".ptrb" || name == "-") {
    refuse_frame_options(name, options);
    return open_ptrb(contract, name, options);
  }
  if (name.compare(0, kHard.size(), kHard) == 0) return open_hard(contract, name, options);
  if (name.compare(0, kRandom.size(), kRandom) == 0) return open_random(contract, name, options);
  throw InputError(
      name,
      "expected a scene: a file .tri, .ptrb, .obj, .ply, .gltf or .glb, - for a .ptrb "
      "on standard input, or teapot, triangle, grid, layers, random/NAME, hard/NAME (see "
      "pineda scenes)");
}

std::vector<BuiltIn> built_in_scenes() {
  std::vector<BuiltIn> scenes{{"teapot", "the Utah teapot: 32 bicubic patches", ""},
                              {"triangle", "one triangle, red, green and blue", ""},
                              {"grid", "jittered triangles that reach over the frame", ""},
                              {"layers", "eight such grids behind each other, out of order", ""}};
  for (const RandomScene& random : kRandomScenes) {
    scenes.push_back({std::string(kRandom) + random.name, random.summary, ""});
  }
  for (const HardCase& hard_case : hard_cases()) {
    scenes.push_back(
        {std::string(kHard) + hard_case.name, hard_case.summary, hard_case.right_answer});
  }
  return scenes;
}

}  // namespace pineda::scene
