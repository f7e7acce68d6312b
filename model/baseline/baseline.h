// Textbook rasterizers for comparison, all with the same small interface. Each is corrected where
// its published form is wrong, and otherwise implemented as published. In the comments of each
// algorithm "As printed" says what was published and "Mended" what is corrected here.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/spec/structs.h"

namespace pineda::baseline {

/// A covered sample, with the values that the algorithm would write.
struct Sample {
  int x = 0;  // px
  int y = 0;
  int64_t z = 0;              // depth code, 0 .. 2^depth_bits - 1
  std::array<int, 4> rgba{};  // 0 .. 2^attribute_bits - 1
};

/// Receives the samples of a triangle in the order in which they are found.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void sample(const Sample& sample) = 0;
};

/// One algorithm in one frame.
///
/// In       snapped triangles inside the guard band: x, y in units of 2^-S px, z in units of 2^-8
///          codes, attributes 0 to 3 red, green, blue, alpha.
/// Out      each sample (pixel centre) that the algorithm considers covered, as often as it hits
///          it.
/// Drops    triangles of zero area or culled by facing (except `points`); samples outside the
///          frame.
/// Errors   none: values are rounded half up and clamped, a NaN counts as 0. No depth test.
class Rasterizer {
 public:
  virtual ~Rasterizer() = default;
  virtual void draw(const spec::Triangle& triangle, Sink* sink) = 0;

  /// Pixels that the inner loops tested since construction: the cycles at one pixel a cycle.
  uint64_t visited() const { return visited_; }

 protected:
  uint64_t visited_ = 0;
};

/// One row of the catalogue.
struct Baseline {
  const char* name;       // key of a report
  const char* summary;    // one line for a person
  const char* source;     // where it is published
  bool orders_the_scene;  // needs the triangles in paint_order() and no depth buffer
  std::unique_ptr<Rasterizer> (*make)(const spec::Contract&, const spec::FrameState&);
};

/// All baselines, in the order of a report.
const std::vector<Baseline>& baselines();

/// The order of the painter's algorithm: indices of the triangles from far to near by mean depth,
/// in the scene's order where equal.
std::vector<uint32_t> paint_order(const std::vector<spec::Triangle>& triangles);

}  // namespace pineda::baseline
