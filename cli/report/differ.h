// When cycles differ: finds the first triangle that model and RTL retire in different cycles, the
// unit, and the states around that cycle.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/output.h"
#include "model/scene/scene.h"
#include "model/timing/raster_top.h"
#include "studies/cycles/compare_cycles.h"
#include "studies/cycles/retirement.h"
#include "tb/frame_bench.h"

namespace pineda::cli {

/// States of the model, or of the RTL, around a cycle.
struct StatesAround {
  studies::ByBoundary<studies::Token> tokens;
  std::array<timing::Cause, timing::kUnits> causes{};               // in that cycle
  std::array<std::optional<uint32_t>, timing::kUnits> triangles{};  // the model's
};

struct FirstRetireDifference {
  studies::RetireDifference retire;
  studies::TokenDifference token;
  StatesAround model, rtl;
  std::string waveform;         // of the RTL; empty: none was asked for
  int64_t from = 0, until = 0;  // cycles of it, the last one excluded
};

/// Both sides of a frame, to be run again.
struct Rerun {
  const scene::Scene& scene;
  const tb::RtlLibrary& library;
  const tb::BenchOptions& bench;
  timing::RasterTop* model;
  Progress* progress;
};

/// The waveform shows so many cycles before the difference, and after it.
inline constexpr int64_t kWaveformCycles = 200;

/// Nothing if all triangles retire in the same cycles, by RetireCycles of both sides; an older
/// differ.fst is removed. Else runs both sides again, twice, and writes FOLDER/differ.fst if there
/// is a folder.
///
/// Errors   scene::InputError: the waveform cannot be written.
std::optional<FirstRetireDifference> find_retire_difference(const Rerun& rerun,
                                                            const std::vector<int64_t>& model,
                                                            const std::vector<int64_t>& rtl,
                                                            const std::string& folder);

/// "6,320 triangles, all equal".
std::string retire_text(const studies::RetireErrors& errors);
/// Names and what they are, for the table and the page.
std::vector<std::pair<std::string, std::string>> difference_rows(const FirstRetireDifference& d);
Json retire_json(const studies::RetireErrors& errors);
/// null where there is none.
Json difference_json(const std::optional<FirstRetireDifference>& difference);

}  // namespace pineda::cli
