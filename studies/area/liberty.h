// Liberty files: the cells that a netlist is made of.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pineda::studies {

/// A cell or a macro of a library.
struct LibertyCell {
  double area_um2 = 0;
  int flip_flops = 0;     // bits that it stores at an edge of a clock
  bool is_latch = false;  // transparent, or described by a state table
};

/// A library of cells, as far as an area study reads it itself.
///
/// Source   Liberty User Guides and Reference Manual, 2017.06: groups and attributes.
class Liberty {
 public:
  /// Reads a file, plain or compressed by gzip.
  ///
  /// Errors   AreaError with the file and, where there is one, the line: it cannot be read, it is no
  ///          Liberty file, it has no cell with an area, or no units.
  static Liberty read(const std::string& file);

  const std::map<std::string, LibertyCell>& cells() const { return cells_; }
  double time_unit_ps() const { return time_unit_ps_; }
  double capacitance_unit_ff() const { return capacitance_unit_ff_; }

  /// The file's text with only the cells that `keep` accepts, without the tables of power, which no
  /// area study needs and which are most of some files.
  std::string text(const std::function<bool(const std::string& cell)>& keep) const;

 private:
  friend class LibertyReader;
  struct Part {  // of the text
    size_t first, end;
    std::string cell;  // empty: a table of power
  };

  std::string text_;
  std::map<std::string, LibertyCell> cells_;
  std::vector<Part> parts_;  // that may be left out, in the order of the text; none inside another
  double time_unit_ps_ = 0;
  double capacitance_unit_ff_ = 0;
};

}  // namespace pineda::studies
