// What the commands of pineda share: options, exit codes, and the scene they open.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/memory/kinds.h"
#include "model/memory/stalls.h"
#include "model/scene/scene.h"
#include "model/spec/widths.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library calls itself so
class App;
class Option;
}  // namespace CLI

namespace pineda::cli {

/// Exit codes of every command.
inline constexpr int kHolds = 0;
inline constexpr int kMismatch = 1;  // a mismatch, or a bound broken
inline constexpr int kBadInput = 2;  // bad usage or bad input

/// Bad usage, found after the command line was parsed. One line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Options of the commands that take a scene.
struct Options {
  std::string scene;
  std::string design = "high_tile";
  std::string json;  // file, "-" = stdout; empty = none
  bool quiet = false;
  uint64_t seed = 0;

  // Meshes
  std::string size;  // WxH
  std::optional<int> tessellate;
  std::string cull;
  std::string depth;
  std::string scissor;  // X,Y,W,H
  std::string depth_write;
  std::string depth_bias;  // C,S
  std::string clear_depth;
  bool reverse_z = false;
  std::string shade;
  std::vector<double> eye, look_at;
  std::optional<double> fov_deg;
  std::optional<int> camera;  // of the file

  // Time
  std::string memory = spec::name_of(memory::Kind::kIdeal);
  std::optional<int> latency_cycles;
  std::string stall = spec::name_of(memory::StallMode::kNone);
};

/// Adds --json and --quiet.
void add_output_options(CLI::App* command, Options* options);
/// Adds the scene and all options about it.
void add_scene_options(CLI::App* command, Options* options);
/// Adds --memory, --latency and --stall.
void add_time_options(CLI::App* command, Options* options);

/// The design by name or from its file. Throws UsageError that lists the designs there are, or
/// spec::DesignFileError.
spec::Contract contract_of(const Options& options);
/// What a design lacks for a command, or an empty text: spec::no_cycles_reason,
/// spec::no_rtl_reason.
using Lack = std::string (*)(const spec::Design&);
/// UsageError where the design lacks something.
void require_of(const Options& options, const spec::Design& design, Lack lack);
/// UsageError if the file that an option names has another ending; an empty name passes.
void require_ending(const char* option, const std::string& file,
                    const std::vector<std::string>& endings);
/// Opens the scene, with `multi_pass` so that it can be rewound.
scene::Scene open(const Options& options, const spec::Contract& contract, bool multi_pass);
int latency_of(const Options& options, const spec::Contract& contract);
/// The memory behind the ports; its latency if it is ideal.
memory::Kind memory_kind_of(const Options& options);
/// "depth latency 8 cycles", or "memory dram".
std::string memory_text(const Options& options, const spec::Contract& contract);
memory::StallMode stall_mode_of(const Options& options);

/// The commands: each adds itself to the program. The return value of a command's run is its exit
/// code, stored in *exit_code by the callback.
void add_check(CLI::App* program, int* exit_code);
void add_render(CLI::App* program, int* exit_code);
void add_time(CLI::App* program, int* exit_code);
void add_rtl(CLI::App* program, int* exit_code);
void add_study(CLI::App* program, int* exit_code);
void add_area_study(CLI::App* study, int* exit_code);
void add_netlist_study(CLI::App* study, int* exit_code);
void add_parameters_study(CLI::App* study, int* exit_code);
void add_cycles_study(CLI::App* study, int* exit_code);
void add_run_study(CLI::App* study, int* exit_code);
void add_error(CLI::App* program, int* exit_code);
void add_designs(CLI::App* program, int* exit_code);
void add_scenes(CLI::App* program, int* exit_code);
void add_walk(CLI::App* program, int* exit_code);
void add_needs(CLI::App* program, int* exit_code);
void add_judge(CLI::App* program, int* exit_code);
void add_vectors(CLI::App* program, int* exit_code);

}  // namespace pineda::cli
