// A process with its library of cells, as an area study takes it.
#pragma once

#include <string>
#include <vector>

#include "studies/area/liberty.h"

namespace pineda::studies {

/// A memory that the process offers beside its cells.
struct Macro {
  std::string liberty;  // its file, in the folder of the cells' unless the path is absolute
  int words = 0;
  int bits = 0;   // of a word
  int ports = 1;  // 1: reads or writes in a cycle; 2: both
  double area_um2 = 0;
};

/// What a TOML file of studies/area/technologies, or a user's, says.
struct Technology {
  std::string file;          // the TOML file
  std::string name;          // its name without the ending
  std::string process;       // in words
  std::string liberty_file;  // that was read
  std::string models_file;   // the cells in Verilog; may be empty
  Liberty liberty;
  std::string driving_cell;             // drives each input
  double load_ff = 0;                   // at each output
  int first_clock_ps = 0;               // asked for first
  std::vector<std::string> flip_flops;  // those that netlists may have
  std::vector<std::string> not_used;    // other cells that they may not have
  std::vector<Macro> macros;

  /// May a netlist have this cell? No latches, no other flip-flops.
  bool allows(const std::string& cell) const;
};

/// The least area of macros for a memory of `words` words, `bits` in all, that is read and written in
/// one cycle, um^2; infinite if there are none. Macros of one port take two banks.
double macro_area(const std::vector<Macro>& macros, int words, long bits);

/// The technologies known by name.
std::vector<std::string> technology_names();

/// A technology by its name or from FILE.toml, with its cells.
///
/// In       liberty: the file of the cells; empty: where the technology says.
/// Errors   AreaError: file, line and what was expected; no such name; no library given or found; a
///          cell named that the library does not have. Macros whose files are missing are left out.
Technology read_technology(const std::string& name_or_file, const std::string& liberty);

}  // namespace pineda::studies
