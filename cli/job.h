// A scene with the design that draws it, or with --design auto the one that it needs.
#pragma once

#include <optional>

#include "cli/output.h"
#include "studies/needs/needs.h"

namespace pineda::cli {

/// What --design auto shrinks.
inline constexpr spec::Design kAutoBase{};

/// Says in a command's help that it takes --design auto.
void allow_auto(CLI::App* command);

/// For open_job(), where every design will do.
inline std::string lacks_nothing(const spec::Design&) { return {}; }

/// A scene and what draws it.
struct Job {
  spec::Contract contract;
  scene::Scene scene;
  std::optional<studies::Needs> needs;  // with --design auto
};

/// Opens the scene for the design of the options; with auto for the smallest that holds it, which
/// is found first and said. `lack`: why a design will not do, or an empty text.
///
/// Errors   UsageError: no such design, or it lacks what is needed; scene::InputError.
Job open_job(const Options& options, Lack lack, bool multi_pass, const Output& output,
             Progress* progress);

/// The scene's notes. Of what the design leaves out they say nothing where the scene needs none of
/// it.
void print_notes(const Output& output, const Job& job);

/// Why the base itself will not do.
std::string not_found(const scene::Scene& scene, const studies::Needs& needs);

/// find_needs() with progress. scene::InputError where no design is found and `must_hold`.
studies::Needs needs_of(const scene::Scene& scene, const studies::NeedsOptions& options,
                        bool must_hold, Progress* progress);

}  // namespace pineda::cli
