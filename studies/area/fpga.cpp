#include "studies/area/fpga.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/area/area_error.h"
#include "studies/area/synthesis.h"

namespace pineda::studies {
namespace {

/// A kind of cell of a family: those whose names begin so.
struct Cells {
  const char* prefix;
  long FpgaCells::*count;
};

struct Family {
  const char* name;
  const char* command;
  std::vector<Cells> cells;
};

const std::vector<Family>& families() {
  using F = FpgaCells;
  static const std::vector<Family> all{
      {"ice40",
       "synth_ice40 -dsp",
       {{"SB_LUT4", &F::luts},
        {"SB_CARRY", &F::carries},
        {"SB_DFF", &F::flip_flops},
        {"SB_MAC16", &F::dsps},
        {"SB_RAM40_4K", &F::block_rams}}},
      {"ecp5",
       "synth_ecp5",
       {{"LUT4", &F::luts},
        {"CCU2C", &F::carries},
        {"TRELLIS_FF", &F::flip_flops},
        {"MULT18X18D", &F::dsps},
        {"DP16KD", &F::block_rams},
        {"TRELLIS_DPR16X4", &F::distributed}}},
      {"xilinx",
       "synth_xilinx -family xc7",
       {{"LUT", &F::luts},
        {"INV", &F::luts},
        {"CARRY4", &F::carries},
        {"FD", &F::flip_flops},
        {"DSP48E1", &F::dsps},
        {"RAMB", &F::block_rams},
        {"RAM", &F::distributed}}},
  };
  return all;
}

const Family& family_of(const std::string& name) {
  for (const Family& family : families()) {
    if (name == family.name) return family;
  }
  throw AreaError(fmt::format("FPGA family '{}': it is not known", name));
}

FpgaCells count(const Family& family, const std::filesystem::path& stat) {
  FpgaCells cells;
  cells.family = family.name;
  std::ifstream stream(stat);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (json.is_discarded()) {
    throw AreaError(fmt::format("{}: expected what Yosys' `stat -json` writes", stat.string()));
  }
  const auto& by_type = json.at("design").at("num_cells_by_type");
  for (const auto& [type, number] : by_type.items()) {
    const auto is_of = [&name = type](const Cells& c) { return name.rfind(c.prefix, 0) == 0; };
    const auto kind = std::find_if(family.cells.begin(), family.cells.end(), is_of);
    if (kind != family.cells.end()) cells.*kind->count += number.get<long>();
  }
  return cells;
}

}  // namespace

std::vector<std::string> fpga_families() {
  std::vector<std::string> names;
  for (const Family& family : families()) names.emplace_back(family.name);
  return names;
}

std::vector<FpgaCells> study_fpga(const spec::Contract& contract,
                                  const std::vector<std::string>& names, const ToolRuns& runs) {
  const std::string sources = runs.keep(sources_of(contract), ".sv");
  std::vector<ToolRun> all;
  for (const std::string& name : names) {
    // Multiplier blocks take `*`; Booth digits would be made of LUTs.
    all.push_back({"yosys",
                   fmt::format("read_verilog -sv -DSYNTHESIS -DPINEDA_DSP {}\n{} -top {}\n"
                               "tee -q -o {}/stat.json stat -json\n",
                               sources, family_of(name).command, kTop, kOut),
                   fmt::format("synthesis of {} for {}", contract.design.name, name)});
  }
  const auto folders = runs.run(all);
  std::vector<FpgaCells> cells;
  for (size_t i = 0; i < names.size(); ++i) {
    cells.push_back(count(family_of(names[i]), folders[i] / "stat.json"));
  }
  return cells;
}

}  // namespace pineda::studies
