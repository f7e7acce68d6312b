#include "studies/area/rtlil.h"

#include <cctype>
#include <cstdlib>
#include <sstream>
#include <unordered_map>

namespace pineda::studies {
namespace {

bool starts_with(const std::string& text, const char* prefix) { return text.rfind(prefix, 0) == 0; }

// A name made up by Yosys: $SOMETHING$NUMBER.
bool is_numbered(const std::string& word) {
  if (word.empty() || word[0] != '$') return false;
  const size_t last = word.rfind('$');
  if (last == 0 || last + 1 == word.size()) return false;
  for (size_t i = last + 1; i < word.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(word[i])) == 0) return false;
  }
  return true;
}

}  // namespace

std::vector<RtlilModule> parse_rtlil(const std::string& text) {
  std::vector<RtlilModule> modules;
  std::istringstream lines(text);
  bool is_inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (starts_with(line, "module ")) {
      modules.push_back({line.substr(7), "", {}, {}});
      is_inside = true;
    }
    if (!is_inside) continue;
    RtlilModule& module = modules.back();
    module.text += line + "\n";
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (starts_with(line, "  cell ")) {
      RtlilCell cell;
      words >> cell.type >> cell.name;
      module.cells.push_back(cell);
    } else if (starts_with(line, "    parameter ") && !module.cells.empty()) {
      std::string name, value;
      words >> name;
      if (name == "signed") words >> name;
      words >> value;
      char* end = nullptr;
      const long number = std::strtol(value.c_str(), &end, 10);
      if (end != value.c_str() && *end == '\0')
        module.cells.back().parameter[name.substr(1)] = number;
    } else if (starts_with(line, "  wire ") && (line.find(" input ") != std::string::npos ||
                                                line.find(" output ") != std::string::npos)) {
      module.ports.push_back(line);
    }
    if (line == "end") is_inside = false;
  }
  return modules;
}

std::string renumbered(const std::string& text) {
  std::unordered_map<std::string, std::string> names;
  std::string result;
  for (size_t at = 0; at < text.size();) {
    if (text[at] != '$') {
      result += text[at++];
      continue;
    }
    size_t end = at;
    while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) == 0) ++end;
    const std::string word = text.substr(at, end - at);
    if (is_numbered(word)) {
      const auto [place, is_new] = names.try_emplace(word);
      if (is_new) place->second = "$n$" + std::to_string(names.size());
      result += place->second;
    } else {
      result += word;
    }
    at = end;
  }
  return result;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string black_box(const RtlilModule& module) {
  std::string text = "attribute \\blackbox 1\nmodule " + module.name + "\n";
  for (const std::string& port : module.ports) text += port + "\n";
  return text + "end\n";
}

}  // namespace pineda::studies
