// What a design's RTL takes of an FPGA.
#pragma once

#include <string>
#include <vector>

#include "model/spec/widths.h"
#include "studies/area/tool_runs.h"

namespace pineda::studies {

/// What raster_top is made of, by Yosys' synth_FAMILY, before placement.
struct FpgaCells {
  std::string family;  // ice40, ecp5, xilinx
  long luts = 0;       // of up to 4 inputs (ice40, ecp5) or 6 (xilinx)
  long carries = 0;    // carry cells
  long flip_flops = 0;
  long dsps = 0;  // multiplier blocks
  long block_rams = 0;
  long distributed = 0;  // memories made of LUTs, in their cells
};

/// The families that are known, in the order of the documentation.
std::vector<std::string> fpga_families();

/// Synthesizes a design for each of the families; results are kept like those of study_area().
///
/// Errors   AreaError: a family is not known, a tool is missing or fails.
std::vector<FpgaCells> study_fpga(const spec::Contract& contract,
                                  const std::vector<std::string>& families, const ToolRuns& runs);

}  // namespace pineda::studies
