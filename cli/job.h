// A scene with the design that draws it, or with --design auto the one that it needs.
#pragma once

#include <optional>

#include "cli/output.h"
#include "studies/needs/needs.h"

namespace pineda::cli {

/// The design that --design auto shrinks.
inline constexpr spec::Design kAutoBase{};

/// Says in a command's help that it takes --design auto.
void allow_auto(CLI::App* command);

/// A Lack for open_job() that every design passes.
inline std::string lacks_nothing(const spec::Design&) { return {}; }

/// A scene and what draws it.
struct Job {
  spec::Contract contract;
  scene::Scene scene;
  std::optional<studies::Needs> needs;  // with --design auto
};

/// Opens the scene for the design of the options; with auto for the smallest design that holds on
/// the scene, which is found first and printed. `lack`: why a design will not do, or an empty text.
///
/// Errors   UsageError: no such design, or it lacks what is needed; scene::InputError.
Job open_job(const Options& options, Lack lack, bool multi_pass, const Output& output,
             Progress* progress);

/// Prints the scene's notes. Parts that the design leaves out since the scene does not need them
/// are not noted.
void print_notes(const Output& output, const Job& job);

/// Why the base itself will not do.
std::string not_found(const scene::Scene& scene, const studies::Needs& needs);

/// find_needs() with progress. scene::InputError where no design is found and `must_hold`.
studies::Needs needs_of(const scene::Scene& scene, const studies::NeedsOptions& options,
                        bool must_hold, Progress* progress);

}  // namespace pineda::cli
