// What the tests of model/baseline share: samples gathered, and a verdict of the exact judge.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/baseline/baseline.h"
#include "tests/core/support.h"

namespace pineda::test {

/// A figure for the test's report.
inline void record(const char* key, double value) {
  testing::Test::RecordProperty(key, std::to_string(value));
}

inline spec::FrameState square(int size_px) {
  return {size_px, size_px, spec::Cull::kNone, spec::DepthFunc::kLess};
}

/// Keeps the samples in the order in which they come.
struct Gathered final : baseline::Sink {
  std::vector<baseline::Sample> samples;
  void sample(const baseline::Sample& s) override { samples.push_back(s); }
};

/// The row of the catalogue; throws std::out_of_range when there is none.
const baseline::Baseline& find_baseline(const std::string& name);

/// The samples of one triangle in one frame.
std::vector<baseline::Sample> samples_of(const std::string& name, const spec::FrameState& frame,
                                         const spec::Triangle& triangle);

/// Samples against the judge, summed over triangles.
struct Verdict {
  int64_t wanted = 0;    // samples of the triangles
  int64_t missing = 0;   // of them, not sent
  int64_t extra = 0;     // sent, not of the triangle
  int64_t twice = 0;     // sent once more within a triangle
  double depth_ulp = 0;  // largest errors at samples rightly sent
  double color_lsb = 0;
  int64_t triangles = 0;  // with a sample wanted
  int64_t wrong = 0;      // triangles with a fault of coverage

  int64_t faults() const { return missing + extra + twice; }
};

/// Adds a triangle's samples to the verdict.
void judge_samples(const spec::FrameState& frame, const spec::Triangle& triangle,
                   const std::vector<baseline::Sample>& samples, Verdict* verdict,
                   int subpixel_bits = 8);

/// `count` random triangles of a shape through one baseline.
Verdict judge_random(const std::string& name, Shape shape, int count, uint64_t seed);

/// The baselines that promise to hit every sample of every triangle once.
const std::vector<std::string>& exact_baselines();

/// Corners anywhere in size x size px.
spec::Triangle triangle_in(Random& random, int size_px);

/// A square of quads, each split along one diagonal, corners on the half-pixel lattice: many
/// samples lie on edges. Every pixel of [1, size_px - 1) x [1, size_px - 1) belongs to one
/// triangle.
std::vector<spec::Triangle> lattice_mesh(Random& random, int size_px);

/// How often each pixel of a square frame is hit.
class Hits {
 public:
  explicit Hits(int size_px)
      : size_(size_px), hits_(static_cast<size_t>(size_px) * static_cast<size_t>(size_px)) {}
  void add(int x, int y) {
    if (x >= 0 && y >= 0 && x < size_ && y < size_) ++hits_[index(x, y)];
  }
  int at(int x, int y) const { return hits_[index(x, y)]; }
  /// Pixels hit more than once.
  int doubles() const;
  /// Pixels of [1, size - 1)^2 that nothing hits.
  int holes() const;

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(size_) + static_cast<size_t>(x);
  }
  int size_;
  std::vector<int> hits_;
};

/// A mesh through one baseline.
Hits hits_of(const std::string& name, const std::vector<spec::Triangle>& mesh, int size_px);

}  // namespace pineda::test
