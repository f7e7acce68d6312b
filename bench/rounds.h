// Both sides in turns: the same triangles, counted, then timed.
#pragma once

#include <string>
#include <vector>

#include "bench/sides.h"

namespace pineda::bench {

/// Shares of the covered samples by which the sides' counts may differ.
inline constexpr double kToleratedShare = 1e-5;

/// Milliseconds of the frames of one side, round by round. CPU time, of all threads, does not count
/// what other programs take.
struct Times {
  std::vector<double> cpu_ms;
  std::vector<double> wall_ms;
};

struct Row {
  std::string scene;
  size_t triangles = 0;
  Samples of_llvmpipe, of_pineda;
  Times llvmpipe, pineda;  // no rounds where the counts differ too much

  bool agrees() const;
  /// How many times faster pineda is, by the medians of CPU time, and in each round.
  double ratio() const;
  std::vector<double> ratios() const;
};

/// Median; the mean of the middle two of an even number.
double median(std::vector<double> values);

/// Draws a scene on both sides: once to count, once to warm up, then in `rounds` rounds, in which one
/// side and the other begins.
Row compare(const std::string& name, const std::vector<scene::ScreenTriangle>& triangles,
            int rounds, Llvmpipe* llvmpipe, Pineda* pineda);

}  // namespace pineda::bench
