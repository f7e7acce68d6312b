// What follows from results together: throughput at a design's clock, for its area.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/run/results.h"

namespace pineda::studies {

/// A frame in a technology.
struct Throughput {
  std::string scene, design, memory, technology;
  double cycles = 0;
  double fmax_mhz = 0;
  double triangles_per_second = 0;
  double samples_per_second = 0;             // covered ones, hidden or not
  std::optional<double> area_mm2;            // with area
  std::optional<double> read_mb_per_second;  // 10^6 bytes; with bandwidth
  std::optional<double> written_mb_per_second;
  std::optional<double> depth_hit_rate, color_hit_rate;  // of the tile caches, behind which DRAM is
};

/// Of each frame with cycles in each technology with timing, in the order of the rows.
std::vector<Throughput> throughputs(const std::vector<Row>& rows);

/// A figure of a row, if it has it.
std::optional<double> figure(const Row& row, const std::string& name);

}  // namespace pineda::studies
