#include "cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <filesystem>

#include "model/spec/design_file.h"

namespace pineda::cli {
namespace {

// "640x480" -> width and height; nothing else around them.
std::optional<scene::Size> parse_size(const std::string& text) {
  scene::Size size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
  return size;
}

// "X,Y,W,H".
scene::Scissor parse_scissor(const std::string& text) {
  std::array<int, 4> value{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (size_t i = 0; i < value.size(); ++i) {
    const auto number = std::from_chars(at, end, value[i]);
    const bool last = i + 1 == value.size();
    const bool closed = last ? number.ptr == end : number.ptr != end && *number.ptr == ',';
    if (number.ec != std::errc() || !closed || (i >= 2 && value[i] < 0)) {
      throw UsageError(fmt::format(
          "--scissor: expected X,Y,W,H, whole numbers of px, W and H from 0, got '{}'", text));
    }
    at = number.ptr + (last ? 0 : 1);
  }
  return {value[0], value[1], value[2], value[3]};
}

// "C,S".
scene::DepthBias parse_depth_bias(const std::string& text, int depth_bits) {
  const auto refuse = [&](const std::string& expected) {
    return UsageError(fmt::format("--depth-bias: expected {}, got '{}'", expected, text));
  };
  const size_t comma = text.find(',');
  if (comma == std::string::npos) throw refuse("C,S");
  const auto constant = scene::parse_bias_constant(text.substr(0, comma).c_str(), depth_bits);
  if (!constant) throw refuse(scene::expected_bias_constant(depth_bits) + " before the comma");
  const auto slope = scene::parse_bias_slope(text.c_str() + comma + 1);
  if (!slope) throw refuse(scene::kExpectedBiasSlope + std::string(" after the comma"));
  return {*constant, *slope};
}

scene::Vec3 vector_of(const std::vector<double>& values) {
  return {values[0], values[1], values[2]};
}

void add_mesh_options(CLI::App* command, Options* o) {
  const std::string meshes = "Meshes";
  command->add_option("--size", o->size, "Frame size in px, 640x480 unless given")
      ->type_name("WxH")
      ->group(meshes);
  command->add_option("--tessellate", o->tessellate, "Teapot: quads along a patch's side")
      ->type_name("N")
      ->group(meshes);
  command->add_option("--cull", o->cull, "none, back or front; front = counter-clockwise")
      ->check(CLI::IsMember(spec::word_list<spec::Cull>()))
      ->type_name("FACE")
      ->group(meshes);
  command->add_option("--depth", o->depth, spec::alternatives<spec::DepthFunc>())
      ->check(CLI::IsMember(spec::word_list<spec::DepthFunc>()))
      ->type_name("FUNC")
      ->group(meshes);
  command->add_option("--scissor", o->scissor, "Draw in this rectangle alone, px")
      ->type_name("X,Y,W,H")
      ->group(meshes);
  command->add_option("--depth-write", o->depth_write, "on or off: of the samples that pass")
      ->check(CLI::IsMember(spec::word_list<bool>()))
      ->type_name("ON")
      ->group(meshes);
  command
      ->add_option("--depth-bias", o->depth_bias,
                   "Added to depth: C codes and S times a triangle's greatest slope")
      ->type_name("C,S")
      ->group(meshes);
  command->add_option("--clear-depth", o->clear_depth, "0 to 1, what depth is cleared to; 1 = far")
      ->type_name("Z")
      ->group(meshes);
  command
      ->add_flag("--reverse-z", o->reverse_z,
                 "Depth 1 at the near plane; depth greater, clear depth 0 unless they are given")
      ->group(meshes);
  command->add_option("--shade", o->shade, "smooth, or flat: the first vertex's colour")
      ->check(CLI::IsMember(spec::word_list<spec::Shade>()))
      ->type_name("SHADE")
      ->group(meshes);
}

void add_camera_options(CLI::App* command, Options* o) {
  const std::string camera = "Camera (frames the mesh unless --eye or --camera is given)";
  auto* eye = command->add_option("--eye", o->eye, "Position")
                  ->delimiter(',')
                  ->expected(3)
                  ->type_name("X,Y,Z")
                  ->group(camera);
  auto* look_at = command
                      ->add_option("--look-at", o->look_at,
                                   "Point in the middle of the picture, 0,0,0 unless given")
                      ->delimiter(',')
                      ->expected(3)
                      ->type_name("X,Y,Z")
                      ->needs(eye)
                      ->group(camera);
  auto* fov = command->add_option("--fov", o->fov_deg, "Vertical angle in degrees, 33 unless given")
                  ->type_name("DEG")
                  ->needs(eye)
                  ->group(camera);
  command->add_option("--camera", o->camera, "One of a glTF file's own cameras, from 0")
      ->type_name("N")
      ->excludes(eye, look_at, fov)
      ->group(camera);
}

}  // namespace

void add_output_options(CLI::App* command, Options* o) {
  command->add_option("--json", o->json, "Write the figures as JSON to a file, - for stdout")
      ->type_name("FILE");
  command->add_flag("--quiet", o->quiet, "Print nothing but errors");
}

void add_scene_options(CLI::App* command, Options* o) {
  command
      ->add_option(
          "scene", o->scene,
          "A .tri, .ptrb, .obj, .ply, .gltf or .glb file, - for a .ptrb on standard input, "
          "or built in: see `pineda scenes`")
      ->required()
      ->type_name("SCENE");
  command->add_option("--design", o->design, "Design point, see `pineda designs`")
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command
      ->add_option("--seed", o->seed,
                   "Seed of what is random: stalls of --stall, scenes random/NAME")
      ->type_name("N")
      ->capture_default_str();
  add_mesh_options(command, o);
  add_camera_options(command, o);
  add_output_options(command, o);
}

void add_time_options(CLI::App* command, Options* o) {
  command->add_option("--memory", o->memory, memory::kinds_text())
      ->check(CLI::IsMember(spec::word_list<memory::Kind>()))
      ->type_name("KIND")
      ->capture_default_str();
  command
      ->add_option("--latency", o->latency_cycles,
                   "Ideal memory: cycles from a depth read to its data, 1 to 64")
      ->type_name("N");
  command
      ->add_option("--stall", o->stall,
                   "Who stalls at the ports: " + spec::alternatives<memory::StallMode>())
      ->check(CLI::IsMember(spec::word_list<memory::StallMode>()))
      ->type_name("MODE")
      ->capture_default_str();
}

spec::Contract contract_of(const Options& options) {
  const std::string& name = options.design;
  if (const auto* design = spec::find_design(name); design != nullptr) {
    return spec::contract(*design);
  }
  if (name.size() > 5 && name.substr(name.size() - 5) == ".toml") {
    return spec::contract(spec::read_design(name));
  }
  std::string known;
  for (const auto& d : spec::designs())
    known += fmt::format("{}{}", known.empty() ? "" : ", ", d.name);
  throw UsageError(fmt::format("--design: expected one of {}, or a file .toml, got '{}'", known,
                               options.design));
}

void require_of(const Options& options, const spec::Design& design, Lack lack) {
  const std::string why = lack(design);
  if (!why.empty()) throw UsageError(fmt::format("--design {}: {}", options.design, why));
}

void require_ending(const char* option, const std::string& file,
                    const std::vector<std::string>& endings) {
  if (file.empty()) return;
  const std::filesystem::path path(file);
  std::string wanted;
  for (const std::string& ending : endings) {
    if (path.extension() == ending) return;
    wanted += (wanted.empty() ? "" : " or ") + ending;
  }
  throw UsageError(fmt::format("{}: expected a file {}, got '{}'", option, wanted, file));
}

scene::Scene open(const Options& o, const spec::Contract& contract, bool multi_pass) {
  scene::Options options;
  if (!o.size.empty()) {
    options.size = parse_size(o.size);
    if (!options.size) throw UsageError(fmt::format("--size: expected WxH, got '{}'", o.size));
  }
  // The text of an option that was not given is empty and names no value: nothing is set.
  options.cull = spec::named<spec::Cull>(o.cull);
  options.depth = spec::named<spec::DepthFunc>(o.depth);
  options.depth_write = spec::named<bool>(o.depth_write);
  options.shade = spec::named<spec::Shade>(o.shade);
  if (!o.scissor.empty()) options.scissor = parse_scissor(o.scissor);
  if (!o.depth_bias.empty()) {
    options.depth_bias = parse_depth_bias(o.depth_bias, contract.design.depth_bits);
  }
  if (!o.clear_depth.empty()) {
    options.clear_depth = scene::parse_clear_depth(o.clear_depth.c_str());
    if (!options.clear_depth) {
      throw UsageError(fmt::format("--clear-depth: expected {}, got '{}'",
                                   scene::kExpectedClearDepth, o.clear_depth));
    }
  }
  if (!o.eye.empty()) {
    scene::Camera camera;
    camera.eye = vector_of(o.eye);
    if (!o.look_at.empty()) camera.target = vector_of(o.look_at);
    if (o.fov_deg) camera.fovy_deg = *o.fov_deg;
    options.camera = camera;
  }
  options.camera_number = o.camera;
  options.reverse_z = o.reverse_z;
  options.tessellate = o.tessellate;
  options.seed = o.seed;
  options.multi_pass = multi_pass;
  return scene::open_scene(contract, o.scene, options);
}

int latency_of(const Options& o, const spec::Contract& contract) {
  const int cycles = o.latency_cycles.value_or(contract.design.depth_latency_cycles);
  if (cycles < 1 || cycles > spec::kMaxDepthLatencyCycles) {
    throw UsageError(
        fmt::format("--latency: expected 1 to {}, got {}", spec::kMaxDepthLatencyCycles, cycles));
  }
  return cycles;
}

memory::Kind memory_kind_of(const Options& o) {
  const auto kind = spec::named<memory::Kind>(o.memory).value_or(memory::Kind::kIdeal);
  if (!spec::row_of(kind).has_latency && o.latency_cycles) {
    throw UsageError("--latency: only an ideal memory has one, not " + o.memory);
  }
  return kind;
}

std::string memory_text(const Options& o, const spec::Contract& contract) {
  if (!spec::row_of(memory_kind_of(o)).has_latency) return "memory " + o.memory;
  return fmt::format("depth latency {} cycles", latency_of(o, contract));
}

memory::StallMode stall_mode_of(const Options& o) {
  return spec::named<memory::StallMode>(o.stall).value_or(memory::StallMode::kNone);
}

}  // namespace pineda::cli
