// The cycles of a long stream of triangles, estimated from windows of it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/scene/snap.h"
#include "model/timing/raster_top.h"

namespace pineda::studies {

/// Which triangles are simulated, by their numbers in the scene; dropped triangles count, too.
///
/// The stream is cut into blocks of `window` triangles, the blocks into `windows` strata of equal
/// length, and of each stratum one block is drawn at random. So every triangle is as likely to be
/// counted as any other, and no period of the scene can hide between the windows. The `warm_up`
/// triangles before a window are simulated and not counted. What lies between is not simulated.
struct SamplePlan {
  uint64_t triangles = 0;  // of the stream
  uint64_t window = 0;     // triangles
  uint64_t warm_up = 0;    // triangles
  uint64_t windows = 0;    // 30 at least
};

/// A plan that simulates `share` of the triangles, in (0, 1). A warm-up has 64 triangles, a window
/// 256, or down to 64 so that there are at least 30 windows. Of short streams a larger share is
/// simulated; there is no plan where that would exceed half, since sampling then does not pay.
std::optional<SamplePlan> plan_sample(uint64_t triangles, double share);

/// A window's cycles: by how much the window delays RasterTop::idle_from(), the cycle in which all
/// triangles so far have left the pipeline. The time between two acceptances by setup is not used:
/// setup accepts further triangles while a large one is still drawn, so the large one's cycles
/// would be counted for the triangles behind it.
struct SampledWindow {
  uint64_t stratum_triangles = 0;
  uint64_t triangles = 0;
  timing::Cycle cycles = 0;
};

/// An estimate of CycleCounters::drained, and half the width of its 95 % confidence interval.
/// FrameResult::cycles is not estimated: the windows do not tell whether the last triangles of the
/// stream write anything.
struct CycleEstimate {
  double cycles = 0;
  double half_width = 0;
  double skewness = 0;          // of the windows' cycles a triangle, within strata
  uint64_t windows_wanted = 0;  // with fewer the interval is too narrow: few large triangles
};

/// Scales each window's cycles per triangle to its stratum and adds `other_cycles`, which do not
/// grow with the stream: those that fill the pipeline, and empty the memories behind it.
///
/// The variance of the cycles per triangle is half the mean square of the differences between
/// neighbouring windows, not the variance of all windows: a slow change along the stream is part of
/// the estimate, not of its error. Its expected value is never too small. It is reduced by the
/// share of triangles that was simulated. The interval is that of Student's t with the degrees of
/// freedom of such differences, 2 (n-1)^2 / (3n - 4). With a skewness of G > 0 it needs 25 G^2
/// windows; then it is wrong in 6 of 100 draws at most. G comes from r[i] = x[i] - (x[i-1] +
/// x[i+1]) / 2, whose second and third moments are 3/2 and 3/4 of those of independent x.
/// Errors   std::invalid_argument: fewer than three windows.
/// Source   Cochran, Sampling Techniques, 1977, 2.15 (skewness), 5.9 (strata), 5A.12 (one unit a
///          stratum); von Neumann et al., The Mean Square Successive Difference, 1941.
CycleEstimate estimate_cycles(const std::vector<SampledWindow>& windows,
                              timing::Cycle other_cycles);

/// The two-sided 95 % quantile of Student's t, right to .001 from 8 degrees of freedom on.
double student_t_95(double degrees);

struct SampleResult {
  CycleEstimate estimate;
  std::vector<SampledWindow> windows;
  uint64_t counted = 0;    // triangles in windows
  uint64_t simulated = 0;  // triangles pulled: those and the warm-up
};

/// Runs all windows of the plan as one frame, one after the other, without clearing, draining or
/// refilling in between. The warm-up replaces what the units still hold of the window before: it is
/// several times as many small triangles as fit into the pipeline. Where a few large triangles lie
/// among many dropped ones it does not suffice: setup then drops triangles at no cost behind the
/// last large triangle sampled, not behind the last one of the stream. In the mean the two are
/// equal, since both are drawn alike.
///
/// In       source: at its first triangle; what the plan leaves out is skipped, not read.
///          progress(n): n triangles simulated so far.
/// Errors   std::invalid_argument: hierarchical z, for which time depends on the depth of triangles
///          that are not drawn. What the source throws.
SampleResult sample_cycles(timing::RasterTop* top, const spec::Contract& contract,
                           const spec::FrameState& frame, scene::SnappedSource* source,
                           const SamplePlan& plan, uint64_t seed,
                           const std::function<void(uint64_t)>& progress = {});

}  // namespace pineda::studies
