// Speed and error of every design point and every baseline on one scene, judged by exact
// arithmetic.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/exact/exact.h"
#include "model/spec/bounds.h"
#include "model/spec/structs.h"
#include "studies/error/distribution.h"

namespace pineda::studies {

/// A triangle as the scene's floats, which the judge takes, and snapped, which the subjects draw.
struct SceneTriangle {
  exact::ScreenTriangle screen;
  spec::Triangle snapped;
};

/// Limits on a scene, so that a study takes some minutes and 2 GB at most.
struct ErrorLimits {
  int64_t pixels = int64_t{1} << 22;     // of the frame
  int64_t triangles = int64_t{1} << 20;  // that are not dropped
  int64_t samples = int64_t{1} << 25;    // covered, hidden ones included
};

/// The largest errors of each pixel, row-major, over all triangles that cover it.
struct ErrorMap {
  std::vector<float> depth_ulp;
  std::vector<float> color_lsb;
  std::vector<uint8_t> coverage;  // bit 0: a sample missing, bit 1: one too many
};

/// One design or baseline. Values are judged at the samples that it covers and should cover, hidden
/// ones included. Colours are compared with affine interpolation of the snapped vertices, in a
/// design with perspective with perspective-correct interpolation, and a flat attribute with the
/// first vertex's.
struct Subject {
  std::string name;
  std::string summary;
  bool is_design = false;
  bool judged_by_frame = false;  // painter: only the visible samples of its finished frame

  uint64_t judged = 0;                      // samples that it and exact arithmetic cover
  uint64_t missing = 0;                     // covered by exact arithmetic, but not by it
  uint64_t extra = 0;                       // covered by it, not by exact arithmetic, or repeatedly
  Distribution depth;                       // ulp; nothing without depth
  Distribution color;                       // LSB, four values a sample
  std::optional<spec::ErrorBounds> bounds;  // what a design promises
  ErrorMap map;                             // empty unless asked for

  double seconds = 0;             // of a frame in memory, median of ErrorStudy::runs
  std::optional<double> cycles;   // of the whole frame, by the cycle model
  std::optional<double> visited;  // baselines: pixels that their loops visit, taken as one a clock

  bool holds() const;
};

struct ErrorStudy {
  int width = 0;
  int height = 0;
  uint64_t triangles = 0;  // judged
  uint64_t samples = 0;    // covered by exact arithmetic, hidden ones included
  int runs = 0;            // how often each subject was timed, taking turns
  /// Largest distance of affine from perspective-correct colours, LSB; 0 where all w are equal.
  double affine_lsb = 0;
  std::vector<Subject> subjects;  // designs first, in their order

  bool holds() const;  // no design misses a sample or its bounds
};

struct ErrorOptions {
  std::vector<spec::Design> designs;  // all with the same input formats
  bool baselines = true;
  bool maps = false;
  /// Reports the current step and how far it is; may be empty.
  std::function<void(const char* what, uint64_t done)> progress;
};

/// Do two designs have the same input formats: coordinates, depth, attributes, 1/w?
bool same_formats(const spec::Design& a, const spec::Design& b);

/// Samples that exact arithmetic covers, hidden ones included; stops counting beyond `limit`.
int64_t count_samples(const std::vector<SceneTriangle>& triangles, const spec::FrameState& frame,
                      const spec::Design& design, int64_t limit);

/// Judges and times all subjects; leaves Subject::cycles empty.
///
/// In       triangles in the order of the scene, within the limits.
/// Errors   std::invalid_argument for designs whose formats differ.
ErrorStudy study_errors(const std::vector<SceneTriangle>& triangles, const spec::FrameState& frame,
                        const ErrorOptions& options);

}  // namespace pineda::studies
