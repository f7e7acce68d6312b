// What a simulation counted of the RTL's source: blocks that ran, bits that changed.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pineda::vectors {

/// The file of the package, which each design generates.
inline constexpr const char* kPackageFile = "pineda_pkg.sv";

/// A block of lines that runs as one, or a bit of a signal. Instances of a module are one: a block is hit
/// where it ran in any of them, a bit where it rose and fell in one of them.
struct CodePoint {
  std::string file;  // in rtl/; the package is that of the design
  int line = 0;
  int column = 0;
  bool is_bit = false;
  std::string
      name;  // of a bit, "prim.e[0][3]"; else what runs the block: block, if, else, elsif, case
  bool is_hit = false;
};

/// "e[0][3]" as "e[0]" and 3; a signal of one bit as its name and -1.
std::pair<std::string, int> split_bit(const std::string& name);

/// The counts of several simulations, added.
///
/// In       files of RtlUnit::write_coverage, all of one design.
/// Errors   Refused: a file that is no such one.
class CodeCounts {
 public:
  void add(const std::string& file);

  /// By file, line and column.
  std::vector<CodePoint> points() const;
  /// As Verilator's verilator_coverage reads them; the package of the design lies in the file `package`.
  std::string text(const std::string& package) const;

 private:
  struct Record {
    CodePoint point;
    uint64_t count = 0;
  };
  std::map<std::string, Record> records_;  // by their text: an instance each
};

}  // namespace pineda::vectors
