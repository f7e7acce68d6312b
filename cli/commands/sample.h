// pineda time --sample: the cycles of a long stream of triangles, estimated.
#pragma once

#include <string>

#include "cli/job.h"
#include "cli/report/seeing.h"
#include "model/timing/raster_top.h"
#include "studies/cycles/sample.h"

namespace pineda::cli {

struct SampleOptions {
  std::string share;  // of the triangles, as given; empty: all, nothing is estimated
};

/// Adds --sample, which excludes options that need every triangle.
void add_sample_options(CLI::App* command, SampleOptions* options);

/// The plan for the job's scene; none if it was not asked for, or the scene is too short, which is
/// said.
/// Errors   UsageError: the design's time cannot be sampled; scene::InputError.
std::optional<studies::SamplePlan> sample_plan(const SampleOptions& options, const Job& job,
                                               const Output& output);

/// Runs the windows, `bench` times with their median, and prints the estimate.
void run_sample(const studies::SamplePlan& plan, const Options& options, int bench, const Job& job,
                timing::RasterTop* top, const Output& output);

/// For a scene that was run whole: adds the JSON of an estimate, with an interval of width 0.
void add_whole(timing::Cycle drained, uint64_t triangles, Json* json);

}  // namespace pineda::cli
