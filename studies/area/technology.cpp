#include "studies/area/technology.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "model/files/data_folder.h"
#include "studies/area/area_error.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

fs::path folder() { return files::data_folder() / "studies/area/technologies"; }

/// Takes values from a TOML table and refuses what is not expected.
class TableReader {
 public:
  TableReader(const std::string& file, const toml::table& table) : file_(file), table_(table) {}

  std::string text(const char* key, bool is_needed = true) const {
    const toml::node* node = find(key, is_needed);
    if (node == nullptr) return {};
    const auto value = node->value_exact<std::string>();
    if (!value) refuse(*node, fmt::format("{} to be a text", key));
    return *value;
  }
  std::vector<std::string> texts(const char* key, bool is_needed) const {
    const toml::node* node = find(key, is_needed);
    if (node == nullptr) return {};
    std::vector<std::string> all;
    const toml::array* array = node->as_array();
    if (array == nullptr) refuse(*node, fmt::format("{} to be a list of texts", key));
    for (const toml::node& item : *array) {
      const auto value = item.value_exact<std::string>();
      if (!value) refuse(item, fmt::format("{} to be a list of texts", key));
      all.push_back(*value);
    }
    return all;
  }
  double number(const char* key, double low, double high) const {
    const toml::node& node = *find(key, true);
    const auto value = node.value<double>();
    if (!value || !(*value >= low && *value <= high)) {
      refuse(node, fmt::format("{} to be a number from {} to {}", key, low, high));
    }
    return *value;
  }
  int whole(const char* key, int low, int high) const {
    const toml::node& node = *find(key, true);
    const auto value = node.value_exact<int64_t>();
    if (!value || *value < low || *value > high) {
      refuse(node, fmt::format("{} to be a whole number from {} to {}", key, low, high));
    }
    return static_cast<int>(*value);
  }
  /// Refuses the keys that are not among these.
  void only(const std::vector<std::string>& keys) const {
    for (const auto& [key, node] : table_) {
      if (std::find(keys.begin(), keys.end(), std::string(key.str())) != keys.end()) continue;
      refuse(node, fmt::format("{}, got {}", fmt::join(keys, ", "), std::string(key.str())));
    }
  }
  [[noreturn]] void refuse(const toml::node& node, const std::string& expected) const {
    throw AreaError(fmt::format("{}:{}: expected {}", file_, node.source().begin.line, expected));
  }
  const toml::node* find(const char* key, bool is_needed) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr && is_needed) {
      throw AreaError(fmt::format("{}:{}: expected the key {}", file_,
                                  std::max(1u, table_.source().begin.line), key));
    }
    return node;
  }

 private:
  const std::string& file_;
  const toml::table& table_;
};

std::vector<Macro> macros_of(const std::string& file, const TableReader& reader) {
  std::vector<Macro> macros;
  const toml::node* node = reader.find("macro", false);
  if (node == nullptr) return macros;
  const toml::array* array = node->as_array();
  if (array == nullptr) reader.refuse(*node, "[[macro]]");
  for (const toml::node& item : *array) {
    if (item.as_table() == nullptr) reader.refuse(item, "[[macro]]");
    const TableReader table(file, *item.as_table());
    table.only({"liberty", "words", "bits", "ports"});
    macros.push_back({table.text("liberty"), table.whole("words", 1, 1 << 20),
                      table.whole("bits", 1, 4096), table.whole("ports", 1, 2)});
  }
  return macros;
}

void read_macros(Technology* t) {
  std::vector<Macro> found;
  for (Macro macro : t->macros) {
    const fs::path file = fs::path(t->liberty_file).parent_path() / macro.liberty;
    if (!fs::exists(file)) continue;
    const Liberty library = Liberty::read(file.string());
    macro.area_um2 = library.cells().begin()->second.area_um2;
    found.push_back(macro);
  }
  t->macros = found;
}

std::string alternatives() {
  return fmt::format("{} or FILE.toml", fmt::join(technology_names(), ", "));
}

void require_cell(const std::string& file, const Technology& t, const char* key,
                  const std::string& cell) {
  if (t.liberty.cells().count(cell) != 0) return;
  throw AreaError(fmt::format("{}: expected {} to be a cell of {}, it has no {}", file, key,
                              t.liberty_file, cell));
}

}  // namespace

bool Technology::allows(const std::string& cell) const {
  const LibertyCell& c = liberty.cells().at(cell);
  const auto is_in = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), cell) != list.end();
  };
  if (is_in(not_used)) return false;
  return is_in(flip_flops) || (c.flip_flops == 0 && !c.is_latch);
}

double macro_area(const std::vector<Macro>& macros, int words, long bits) {
  double least = std::numeric_limits<double>::infinity();
  for (const Macro& macro : macros) {
    const int banks = macro.ports > 1 ? 1 : 2;
    const double high = std::max(1., std::ceil(static_cast<double>(words) / banks / macro.words));
    const double wide = std::ceil(static_cast<double>(bits) / words / macro.bits);
    least = std::min(least, banks * high * wide * macro.area_um2);
  }
  return least;
}

std::vector<std::string> technology_names() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder(), none)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Technology read_technology(const std::string& name_or_file, const std::string& liberty) {
  const auto names = technology_names();
  const bool is_file = fs::path(name_or_file).extension() == ".toml";
  if (!is_file && std::find(names.begin(), names.end(), name_or_file) == names.end()) {
    throw AreaError(
        fmt::format("--technology: expected {}, got '{}'", alternatives(), name_or_file));
  }
  const std::string file = is_file ? name_or_file : (folder() / (name_or_file + ".toml")).string();
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw AreaError(fmt::format("{}: expected a technology, cannot read it", file));
  toml::table table;
  try {
    table = toml::parse(text.str(), file);
  } catch (const toml::parse_error& error) {
    throw AreaError(fmt::format("{}:{}: expected TOML: {}", file, error.source().begin.line,
                                error.description()));
  }
  const TableReader reader(file, table);
  reader.only({"process", "liberty", "models", "package", "driving_cell", "load_ff",
               "first_clock_ps", "flip_flops", "not_used", "macro"});
  Technology t;
  t.file = file;
  t.name = fs::path(file).stem().string();
  t.process = reader.text("process");
  t.driving_cell = reader.text("driving_cell");
  t.load_ff = reader.number("load_ff", 0, 1e6);
  t.first_clock_ps = reader.whole("first_clock_ps", 1, 1'000'000'000);
  t.flip_flops = reader.texts("flip_flops", true);
  t.not_used = reader.texts("not_used", false);
  t.macros = macros_of(file, reader);
  t.liberty_file = liberty.empty() ? reader.text("liberty", false) : liberty;
  if (t.liberty_file.empty()) {
    throw AreaError(
        fmt::format("--liberty: expected the Liberty file of {} (plain or gzip)", t.name));
  }
  t.models_file = reader.text("models", false);
  const std::string package = reader.text("package", false);
  if (liberty.empty() && !package.empty() && !fs::exists(t.liberty_file)) {
    throw AreaError(fmt::format("{}: expected the cells of {}: install {}, or give --liberty",
                                t.liberty_file, t.name, package));
  }
  t.liberty = Liberty::read(t.liberty_file);
  require_cell(file, t, "driving_cell", t.driving_cell);
  for (const auto& cell : t.not_used) require_cell(file, t, "not_used", cell);
  for (const auto& cell : t.flip_flops) {
    require_cell(file, t, "flip_flops", cell);
    if (t.liberty.cells().at(cell).flip_flops > 0) continue;
    throw AreaError(
        fmt::format("{}: expected flip_flops to be flip-flops, {} is none", file, cell));
  }
  if (t.flip_flops.empty()) throw AreaError(fmt::format("{}: expected a flip-flop", file));
  read_macros(&t);
  return t;
}

}  // namespace pineda::studies
