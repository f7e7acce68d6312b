// Yosys' RTLIL text, as far as a study looks into it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace pineda::studies {

/// A cell of a module: an operator, a memory, a cell of the library, or another module.
struct RtlilCell {
  std::string type;
  std::string name;
  std::map<std::string, long> parameter;  // those that are plain numbers, without the backslash
};

struct RtlilModule {
  std::string name;
  std::string text;                // from "module" to "end"
  std::vector<std::string> ports;  // the lines that declare them
  std::vector<RtlilCell> cells;
};

/// The modules of a file that write_rtlil wrote.
std::vector<RtlilModule> parse_rtlil(const std::string& text);

/// The text with the names that Yosys made up (and numbered) renumbered in the order in which they
/// come: the same module has the same text, whatever was elaborated beside it.
std::string renumbered(const std::string& text);

/// `text` with every `from` replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// The module without its content, for those that hold it.
std::string black_box(const RtlilModule& module);

}  // namespace pineda::studies
