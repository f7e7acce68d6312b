// pineda study area --tables: what designs are as hardware, side by side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/output.h"
#include "model/spec/widths.h"
#include "studies/area/area.h"

namespace pineda::cli {

/// What a design makes of a scene at its fastest clock.
struct Throughput {
  std::string scene;
  int64_t cycles = 0;
  double triangles_per_second = 0;
  double pixels_per_second = 0;  // covered samples
};

struct AreaRow {
  spec::Contract contract;
  studies::AreaStudy area;
  std::vector<Throughput> scenes;

  double square_mm() const { return 1e-6 * area.area_um2; }
};

/// Prints tables in Markdown, a row a design: area by unit, flip-flops, bits in memories and clock; if
/// there are scenes, Mtri/s and Gpix/s on each, and both per mm^2.
void print_area_tables(const Output& output, const std::vector<AreaRow>& rows);

}  // namespace pineda::cli
