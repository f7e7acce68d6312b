#include "model/spec/design_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "model/spec/fixed.h"

namespace pineda::spec {
namespace {

/// A key and the parameter it sets; `is_log2`: the key is in px, the parameter its logarithm.
struct Key {
  const char* name;
  int Design::*parameter;
  bool is_log2 = false;
};

constexpr Key kKeys[] = {
    {"subpixel_bits", &Design::subpixel_bits},
    {"guard_bits", &Design::guard_bits},
    {"depth_bits", &Design::depth_bits},
    {"attributes", &Design::attributes},
    {"flat_attributes", &Design::flat_attributes},
    {"attribute_bits", &Design::attribute_bits},
    {"inverse_w_bits", &Design::inverse_w_bits},
    {"reciprocal_lut_bits", &Design::reciprocal_lut_bits},
    {"reciprocal_newton_steps", &Design::reciprocal_newton_steps},
    {"reciprocal_bits", &Design::reciprocal_bits},
    {"gradient_fraction_bits", &Design::gradient_fraction_bits},
    {"tile_fraction_bits", &Design::tile_fraction_bits},
    {"tile_px", &Design::tile_log2, true},
    {"stamp_width_px", &Design::stamp_width_log2, true},
    {"stamp_height_px", &Design::stamp_height_log2, true},
    {"hierarchical_z_bits", &Design::hierarchical_z_bits},
    {"hierarchical_z_tiles", &Design::hierarchical_z_tiles},
    {"hierarchical_z_delay_cycles", &Design::hierarchical_z_delay_cycles},
    {"prim_fifo_depth", &Design::prim_fifo_depth},
    {"tile_fifo_depth", &Design::tile_fifo_depth},
    {"stamp_fifo_depth", &Design::stamp_fifo_depth},
    {"depth_latency_cycles", &Design::depth_latency_cycles},
    {"max_depth_latency_cycles", &Design::max_depth_latency_cycles},
};

constexpr ReciprocalScheme kSchemes[] = {ReciprocalScheme::kNewton, ReciprocalScheme::kQuadratic,
                                         ReciprocalScheme::kRestoring2,
                                         ReciprocalScheme::kRestoring4, ReciprocalScheme::kNone};

struct Switch {
  const char* name;
  bool Design::*parameter;
};

constexpr Switch kSwitches[] = {{"depth_test", &Design::depth_test},
                                {"perspective", &Design::perspective},
                                {"hierarchical_z", &Design::hierarchical_z}};

constexpr SetupStyle kStyles[] = {SetupStyle::kStepped, SetupStyle::kPipelined,
                                  SetupStyle::kSerial};

/// Names of designs that were read: a Design only points to its own.
const char* kept(const std::string& text) {
  static std::deque<std::string> all;
  return all.emplace_back(text).c_str();
}

// What a message takes over from a file: in one line, printable, and not without end.
std::string printable(std::string text) {
  constexpr size_t kLongest = 1200;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

[[noreturn]] void refuse(const std::string& path, const toml::source_region& where,
                         const std::string& expected) {
  throw DesignFileError(
      fmt::format("{}:{}: expected {}", path, where.begin.line, printable(expected)));
}

std::string text_of(const std::string& path, const toml::node& node, const char* key) {
  const auto text = node.value_exact<std::string>();
  if (!text || text->empty()) refuse(path, node.source(), fmt::format("{} to be a text", key));
  return *text;
}

int number_of(const std::string& path, const toml::node& node, const Key& key) {
  const auto number = node.value_exact<int64_t>();
  if (!number || *number < -1 || *number > 1'000'000) {
    refuse(path, node.source(), fmt::format("{} to be a whole number up to 1000000", key.name));
  }
  const auto value = static_cast<uint64_t>(*number);
  if (!key.is_log2) return static_cast<int>(*number);
  if (*number < 1 || (value & (value - 1)) != 0) {
    refuse(path, node.source(), fmt::format("{} to be a power of two, got {}", key.name, *number));
  }
  return ceil_log2(value);
}

/// The one of `all` that the text names.
template <class Choice, size_t Count>
Choice choice_of(const std::string& path, const toml::node& node, const char* key,
                 const Choice (&all)[Count], const char* (*name_of)(Choice)) {
  const std::string name = text_of(path, node, key);
  std::string known;
  for (const Choice choice : all) {
    if (name == name_of(choice)) return choice;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", name_of(choice));
  }
  refuse(path, node.source(), fmt::format("{} to be one of {}, got {}", key, known, name));
}

Design base_of(const std::string& path, const toml::table& table) {
  const toml::node* node = table.get("base");
  if (node == nullptr) return kHighTile;
  const std::string name = text_of(path, *node, "base");
  if (const Design* design = find_design(name); design != nullptr) return *design;
  refuse(path, node->source(), fmt::format("base to be a named design, got {}", name));
}

/// Sets what a key says. Those of base, name and summary are taken elsewhere.
void set(const std::string& path, const std::string& name, const toml::node& node, Design* d) {
  if (name == "base" || name == "name" || name == "summary") return;
  if (name == "reciprocal_scheme") {
    d->reciprocal_scheme = choice_of(path, node, name.c_str(), kSchemes, reciprocal_scheme_name);
    return;
  }
  if (name == "setup_style") {
    d->setup_style = choice_of(path, node, name.c_str(), kStyles, setup_style_name);
    return;
  }
  for (const Switch& key : kSwitches) {
    if (name != key.name) continue;
    const auto value = node.value_exact<bool>();
    if (!value) refuse(path, node.source(), fmt::format("{} to be true or false", key.name));
    d->*key.parameter = *value;
    return;
  }
  for (const Key& key : kKeys) {
    if (name != key.name) continue;
    d->*key.parameter = number_of(path, node, key);
    return;
  }
  refuse(path, node.source(),
         fmt::format("a parameter of a design (see pineda designs), got {}", name));
}

/// The line of the key that a reason begins with, or the first.
uint32_t line_of(const toml::table& table, const std::string& reason) {
  for (const auto& [key, node] : table) {
    if (reason.rfind(std::string(key.str()) + " ", 0) == 0) return node.source().begin.line;
  }
  return 1;
}

}  // namespace

Design parse_design(const std::string& text, const std::string& path) {
  toml::table table;
  try {
    table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw DesignFileError(fmt::format("{}:{}: expected TOML: {}", path, error.source().begin.line,
                                      printable(std::string(error.description()))));
  }
  Design design = base_of(path, table);
  const toml::node* name = table.get("name");
  design.name = kept(name != nullptr ? text_of(path, *name, "name")
                                     : std::filesystem::path(path).stem().string());
  const toml::node* summary = table.get("summary");
  design.summary =
      kept(summary != nullptr ? text_of(path, *summary, "summary") : fmt::format("from {}", path));
  for (const auto& [key, node] : table) set(path, std::string(key.str()), node, &design);
  if (const std::string reason = invalid_reason(design); !reason.empty()) {
    throw DesignFileError(fmt::format("{}:{}: expected a design that can be built: {}", path,
                                      line_of(table, reason), reason));
  }
  return design;
}

Design read_design(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw DesignFileError(fmt::format("{}: expected a design file, cannot read it", path));
  return parse_design(text.str(), path);
}

namespace {

std::string quoted(const char* text) { return (std::ostringstream() << toml::value(text)).str(); }

std::string head(const Design& d) {
  return fmt::format("name = {}\nsummary = {}\n", quoted(d.name), quoted(d.summary));
}

}  // namespace

std::vector<Parameter> parameters(const Design& d) {
  std::vector<Parameter> all{
      {"reciprocal_scheme", quoted(reciprocal_scheme_name(d.reciprocal_scheme))},
      {"setup_style", quoted(setup_style_name(d.setup_style))}};
  for (const Switch& key : kSwitches)
    all.push_back({key.name, d.*key.parameter ? "true" : "false"});
  for (const Key& key : kKeys) {
    const int value = key.is_log2 ? 1 << d.*key.parameter : d.*key.parameter;
    all.push_back({key.name, std::to_string(value)});
  }
  return all;
}

std::string design_toml(const Design& d) {
  std::string text = head(d);
  for (const auto& p : parameters(d)) text += fmt::format("{} = {}\n", p.name, p.value);
  return text;
}

std::string design_toml(const Design& d, const Design& base) {
  std::string text = fmt::format("base = {}\n", quoted(base.name)) + head(d);
  const auto of_base = parameters(base);
  size_t i = 0;
  for (const auto& p : parameters(d)) {
    if (p.value != of_base[i++].value) text += fmt::format("{} = {}\n", p.name, p.value);
  }
  return text;
}

}  // namespace pineda::spec
