// Speed against error: every design point and every baseline on one scene, before the exact judge.
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

/// A triangle as the scene states it, for the judge, and snapped, for what is judged.
struct SceneTriangle {
  exact::ScreenTriangle screen;
  spec::Triangle snapped;
};

/// What a scene may have at most, so that time and memory stay bounded: some minutes, 2 GB.
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

/// One design or baseline. Values are judged at samples that it rightly covers, hidden ones
/// included; colour as affine interpolation of the snapped vertices, of a design with perspective
/// as corrected by it, and a flat attribute as the first vertex's.
struct Subject {
  std::string name;
  std::string summary;
  bool is_design = false;
  bool judged_by_frame = false;  // painter: the visible samples of its finished frame only

  uint64_t judged = 0;                      // samples that both cover
  uint64_t missing = 0;                     // exact covers, it does not
  uint64_t extra = 0;                       // it covers, exact does not; a second time counts too
  Distribution depth;                       // ulp; nothing without depth
  Distribution color;                       // LSB, four values a sample
  std::optional<spec::ErrorBounds> bounds;  // what a design promises
  ErrorMap map;                             // empty unless asked for

  double seconds = 0;             // of a frame in memory, median of ErrorStudy::runs
  std::optional<double> cycles;   // of the whole frame: the cycle model's
  std::optional<double> visited;  // baselines: pixels their loops look at; cycles at one a clock

  bool holds() const;
};

struct ErrorStudy {
  int width = 0;
  int height = 0;
  uint64_t triangles = 0;  // judged
  uint64_t samples = 0;    // covered by exact arithmetic, hidden ones included
  int runs = 0;            // timed, of every subject in turn
  /// Largest distance of affine from perspective-correct colours, LSB; 0 where all w are equal.
  double affine_lsb = 0;
  std::vector<Subject> subjects;  // designs first, in their order

  bool holds() const;  // no design misses a sample or its bounds
};

struct ErrorOptions {
  std::vector<spec::Design> designs;  // of the same formats at their input
  bool baselines = true;
  bool maps = false;
  /// Called now and then with what is being done and how much of it; may be empty.
  std::function<void(const char* what, uint64_t done)> progress;
};

/// Do two designs take a scene the same way: coordinates, depth, attributes?
bool same_formats(const spec::Design& a, const spec::Design& b);

/// Samples that exact arithmetic covers, hidden ones included; stops counting beyond `limit`.
int64_t count_samples(const std::vector<SceneTriangle>& triangles, const spec::FrameState& frame,
                      const spec::Design& design, int64_t limit);

/// Judges and times everything but the designs' cycles, which it leaves empty.
///
/// In       triangles in the order of the scene, within the limits.
/// Errors   std::invalid_argument for designs whose formats differ.
ErrorStudy study_errors(const std::vector<SceneTriangle>& triangles, const spec::FrameState& frame,
                        const ErrorOptions& options);

}  // namespace pineda::studies
