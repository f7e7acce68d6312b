#include "model/spec/design_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <utility>

#include "model/spec/fixed.h"
#include "model/spec/parameters.h"

namespace pineda::spec {
namespace {

/// Keeps a text until the program ends, once: a Design only points to its name and summary. Threads may
/// read designs at the same time.
const char* kept(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> all;
  const std::lock_guard<std::mutex> lock(mutex);
  return all.insert(text).first->c_str();
}

// Text from a file as a message may quote it: one line, printable, of limited length.
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

/// Sets one parameter of a design from the value of its TOML node.
class Setter {
 public:
  Setter(const std::string& path, const toml::node& node, const char* key, Design* design)
      : path_(path), node_(node), key_(key), design_(*design) {}

  void operator()(const Number& number) const {
    const auto value = node_.value_exact<int64_t>();
    if (!value || *value < -1 || *value > 1'000'000) fail("a whole number up to 1000000");
    const auto bits = static_cast<uint64_t>(*value);
    if (number.is_log2 && (*value < 1 || (bits & (bits - 1)) != 0)) {
      fail(fmt::format("a power of two, got {}", *value));
    }
    design_.*number.member = number.is_log2 ? ceil_log2(bits) : static_cast<int>(*value);
  }
  void operator()(bool Design::*member) const {
    const auto value = node_.value_exact<bool>();
    if (!value) fail("true or false");
    design_.*member = *value;
  }
  template <class Choice>
  void operator()(Choice Design::*member) const {
    const std::string word = text_of(path_, node_, key_);
    const auto value = named<Choice>(word);
    if (!value) fail(fmt::format("one of {}, got {}", words_of<Choice>(), word));
    design_.*member = *value;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    refuse(path_, node_.source(), fmt::format("{} to be {}", key_, expected));
  }

  const std::string& path_;
  const toml::node& node_;
  const char* key_;
  Design& design_;
};

Design base_of(const std::string& path, const toml::table& table) {
  const toml::node* node = table.get("base");
  if (node == nullptr) return kHighTile;
  const std::string name = text_of(path, *node, "base");
  if (const Design* design = find_design(name); design != nullptr) return *design;
  refuse(path, node->source(), fmt::format("base to be a named design, got {}", name));
}

/// Sets the parameter with this key. The keys base, name and summary are handled elsewhere.
void set(const std::string& path, const std::string& name, const toml::node& node, Design* d) {
  if (name == "base" || name == "name" || name == "summary") return;
  for (const Parameter& p : kParameters) {
    if (name == p.key) return std::visit(Setter(path, node, p.key, d), p.member);
  }
  refuse(path, node.source(),
         fmt::format("a parameter of a design (see pineda designs), got {}", name));
}

/// The line of the key that `reason` begins with; 1 if there is none.
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
    table = toml::parse(text);
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

std::vector<Setting> differences(const Design& design, const Design& base) {
  std::vector<Setting> all;
  for (const Parameter& p : kParameters) {
    std::string value = file_value(p, design);
    if (value != file_value(p, base)) all.push_back({p.key, std::move(value)});
  }
  return all;
}

std::string design_toml(const Design& d) {
  std::string text = head(d);
  for (const Parameter& p : kParameters) text += fmt::format("{} = {}\n", p.key, file_value(p, d));
  return text;
}

std::string design_toml(const Design& d, const Design& base) {
  std::string text = fmt::format("base = {}\n", quoted(base.name)) + head(d);
  for (const Setting& s : differences(d, base)) text += fmt::format("{} = {}\n", s.key, s.value);
  return text;
}

}  // namespace pineda::spec
