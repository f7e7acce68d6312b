// The cycles of a long stream of triangles, estimated from windows of it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/scene/snap.h"
#include "model/timing/raster_top.h"

namespace pineda::studies {

/// Which triangles are simulated: those numbers of the scene, dropped ones included.
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

/// A plan in which `share` of the triangles, (0, 1), are simulated. 64 of warm-up; windows of 256,
/// or of down to 64 so that there are 30. Short streams have a larger share simulated; none where
/// that would be more than half: then sampling is not worth while.
std::optional<SamplePlan> plan_sample(uint64_t triangles, double share);

/// A window's cycles: by how much it puts off the cycle in which all triangles until then have left
/// the pipeline, RasterTop::idle_from(). Not the time between two acceptances by setup: those run
/// ahead of what a large triangle has still to do, which would be put down to triangles behind it.
struct SampledWindow {
  uint64_t stratum_triangles = 0;
  uint64_t triangles = 0;
  timing::Cycle cycles = 0;
};

/// An estimate of CycleCounters::drained, and half of the interval that holds it in 95 of 100
/// draws. Not of FrameResult::cycles: whether the stream's end writes is not to be known from
/// windows.
struct CycleEstimate {
  double cycles = 0;
  double half_width = 0;
  double skewness = 0;          // of the windows' cycles a triangle, within strata
  uint64_t windows_wanted = 0;  // with fewer the interval is too narrow: few large triangles
};

/// The strata's triangles at their windows' cycles a triangle, and `other_cycles` that do not grow
/// with the stream: to fill the pipeline, and to empty memories behind it.
///
/// The variance of cycles a triangle is half the mean square of the differences of neighbours in
/// the stream, not that of all: what changes slowly along the stream is in the estimate, not in its
/// error. It is never too small in the mean, less the share that was seen. The interval is that of
/// Student's t with the degrees of freedom of such differences, 2 (n-1)^2 / (3n - 4). It wants
/// 25 G^2 windows for a skewness of G > 0, then it is wrong in 6 of 100 draws at most. G comes from
/// r[i] = x[i] - (x[i-1] + x[i+1]) / 2, whose second and third moments are 3/2 and 3/4 of those of
/// independent x.
/// Errors   std::invalid_argument: fewer than three windows.
/// Source   Cochran, Sampling Techniques, 1977, 2.15 (skewness), 5.9 (strata), 5A.12 (one unit a
///          stratum); von Neumann et al., The Mean Square Successive Difference, 1941.
CycleEstimate estimate_cycles(const std::vector<SampledWindow>& windows,
                              timing::Cycle other_cycles);

/// Two-sided 95 % point of Student's t; within .001 from 8 degrees of freedom on.
double student_t_95(double degrees);

struct SampleResult {
  CycleEstimate estimate;
  std::vector<SampledWindow> windows;
  uint64_t counted = 0;    // triangles in windows
  uint64_t simulated = 0;  // triangles pulled: those and the warm-up
};

/// Runs the windows of the plan as one frame, each after the one before it, and clears, drains and
/// fills nothing in between. A warm-up replaces what the units hold of the last window: of small
/// triangles it is several times what fits. Of large ones, a few among many dropped, it is not, and
/// then the shadow in which setup drops triangles for nothing is that of the last large triangle
/// sampled: in the mean that of one in the stream, since both are drawn alike.
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
