#include "studies/score/mutants.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "model/files/data_folder.h"
#include "model/spec/package.h"
#include "studies/area/area_error.h"
#include "studies/area/rtlil.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

/// A source as it stands in the cache, under a name made from its content.
struct Source {
  std::string name;  // below rtl/
  std::vector<std::string> lines;
};
using Sources = std::map<std::string, Source>;  // by name in the cache

void keep(const std::string& name, const std::string& text, const ToolRuns& runs, Sources* sources,
          std::string* files) {
  const std::string kept = runs.keep(text, ".sv");
  Source source{name, {}};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) source.lines.push_back(line);
  (*sources)[kept] = source;
  *files += " " + kept;
}

/// Triangles have numbers of 32 bits, as in simulation.
std::string package_of(const spec::Contract& contract) {
  return replaced(spec::package_text(contract), "ID_BITS = 1;", "ID_BITS = 32;");
}

/// A place as Yosys writes it: FILE:LINE.COLUMN-LINE.COLUMN.
struct Place {
  std::string file;
  size_t line = 0;
};

Place place_of(const std::string& text) {
  const size_t colon = text.find(':');
  if (colon == std::string::npos) return {};
  return {text.substr(0, colon), std::strtoul(text.c_str() + colon + 1, nullptr, 10)};
}

/// Does a module's instance begin there? They are called u_NAME.
bool begins_instance(const std::string& line) {
  return line.find("u_") != std::string::npos && line.back() == '(';
}

/// Where the mutant stands: of its places the last that is no instance of a module.
void set_place(const std::vector<std::string>& places, const Sources& sources, Mutant* mutant) {
  for (const std::string& text : places) {
    const Place place = place_of(text);
    const auto source = sources.find(place.file);
    if (source == sources.end() || place.line - 1 >= source->second.lines.size()) continue;
    const std::string& line = source->second.lines[place.line - 1];
    const std::string& file = source->second.name;
    mutant->in_multiplier |= file.rfind("lib/multiplier", 0) == 0;
    if (begins_instance(line) && !mutant->file.empty()) continue;
    mutant->file = file;
    mutant->line = static_cast<int>(place.line);
    mutant->source = line.substr(std::min(line.find_first_not_of(' '), line.size()));
  }
}

/// The mutants of a list that `mutate -list` wrote.
std::vector<Mutant> mutants_of(const fs::path& list, const Sources& sources) {
  std::vector<Mutant> mutants;
  std::istringstream lines(text_of(list));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Mutant mutant;
    std::vector<std::string> places;
    for (std::string word; words >> word;) {
      if (word == "-ctrl") words >> word >> word >> mutant.number;
      if (word == "-mode") words >> mutant.mode;
      if (word == "-port") words >> mutant.port;
      if (word == "-portbit") words >> mutant.bit;
      if (word == "-src") places.emplace_back() = (words >> word, word);
    }
    if (mutant.number == 0) continue;
    set_place(places, sources, &mutant);
    mutants.push_back(mutant);
  }
  return mutants;
}

}  // namespace

std::string Mutant::text() const { return fmt::format("{} {}[{}]", mode, port, bit); }

MutantNetlist mutated(const spec::Contract& contract, const std::string& unit, int mutants,
                      uint64_t seed, const ToolRuns& runs) {
  MutantNetlist netlist;
  Sources sources;
  std::string files;
  keep("pineda_pkg.sv", package_of(contract), runs, &sources, &files);
  netlist.package = files.substr(1);
  std::istringstream names(text_of(files::data_folder() / "rtl/files.f"));
  for (std::string name; names >> name;) {
    if (name != "pineda_pkg.sv")
      keep(name, text_of(files::data_folder() / "rtl" / name), runs, &sources, &files);
  }
  const std::string wrapper = unit + "_with_fifo";
  const fs::path with_fifo = files::data_folder() / "studies/score" / (wrapper + ".sv");
  const bool is_wrapped = fs::exists(with_fifo);
  if (is_wrapped) keep("raster_top.sv", text_of(with_fifo), runs, &sources, &files);
  // Nets are split where they are driven in parts, or Verilator would see loops through them.
  const std::string script = fmt::format(
      "read_verilog -sv -DPINEDA_DSP{0}\nhierarchy -check -top {1}\nproc\nflatten\n{2}"
      "opt_expr -fine\nopt_clean\n"
      "mutate -list {3} -none -seed {4} -ctrl mutant_i 16 0 -o {5}/list\nscript {5}/list\n"
      "write_rtlil {5}/mutants.il\n"
      "splitnets -driver\nopt_clean\nwrite_verilog -noattr {5}/mutants.v\n",
      files, is_wrapped ? wrapper : unit + "_unit",
      is_wrapped ? fmt::format("rename {} {}_unit\n", wrapper, unit) : "", mutants + 1, seed, kOut);
  const fs::path folder = runs.run({{"yosys", script, "mutating " + unit}}).front();
  netlist.mutants = mutants_of(folder / "list", sources);
  netlist.verilog = text_of(folder / "mutants.v");
  netlist.rtlil = runs.name_of(folder / "mutants.il");
  if (netlist.mutants.size() < static_cast<size_t>(mutants)) {
    throw AreaError(fmt::format("--mutants: expected at most {} of {}, got {}",
                                netlist.mutants.size(), unit, mutants));
  }
  return netlist;
}

}  // namespace pineda::studies
