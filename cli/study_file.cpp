#include "cli/study_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>

#include "cli/options.h"
#include "cli/study_scenes.h"
#include "model/files/data_folder.h"
#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "model/spec/parameters.h"
#include "studies/area/technology.h"
#include "studies/run/memory_parameters.h"

namespace pineda::cli {
namespace {

namespace fs = std::filesystem;
using studies::Measure;

std::string written(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Hash of a file of a scene, and of the buffers that a glTF file names.
std::string hash_of(const fs::path& file) {
  const std::string bytes = bytes_of(file);
  uint64_t hash = spec::text_hash(bytes);
  if (file.extension() == ".gltf") {
    const std::regex uri("\"uri\"\\s*:\\s*\"([^\"]*)\"");
    for (std::sregex_iterator it(bytes.begin(), bytes.end(), uri), end; it != end; ++it) {
      const fs::path buffer = file.parent_path() / (*it)[1].str();
      std::error_code error;
      if (fs::is_regular_file(buffer, error)) hash = spec::text_hash(bytes_of(buffer), hash);
    }
  }
  return fmt::format("{:016x}", hash);
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), folder_(fs::path(path).parent_path()) {}

  StudyFile read() {
    std::ifstream file(path_);
    if (!file) throw StudyFileError(path_ + ": expected a study, cannot read it");
    try {
      table_ = toml::parse(file, path_);
    } catch (const toml::parse_error& error) {
      throw StudyFileError(fmt::format("{}:{}: expected TOML: {}", path_, error.source().begin.line,
                                       error.description()));
    }
    know(table_, {"name", "scenes", "scene", "designs", "design", "memories", "memory",
                  "technologies", "technology", "measures", "clock_ps"});
    study_.name = table_.contains("name") ? text(*table_.get("name"), "name")
                                          : fs::path(path_).stem().string();
    read_measures();
    for (const toml::node* node : list("scenes")) {
      const std::string scene = text(*node, "a scene");
      add_scene({scene, scene, {}, {}}, *node);
    }
    for (const toml::table* table : tables("scene")) add_scene(*table);
    for (const toml::node* node : list("designs")) add_designs(text(*node, "a design"), *node);
    for (const toml::table* table : tables("design")) add_designs(*table);
    for (const toml::node* node : list("memories")) add_memory(text(*node, "a memory"), *node);
    for (const toml::table* table : tables("memory")) add_memory(*table);
    for (const toml::node* node : list("technologies"))
      add_technology(text(*node, "a technology"), "", *node);
    for (const toml::table* table : tables("technology")) add_technology(*table);
    if (const toml::node* clock = table_.get("clock_ps")) {
      study_.clock_ps = number(*clock, "clock_ps", 1, 1'000'000'000);
    }
    complete();
    check_designs();
    return {std::move(study_), left_out_, reason_};
  }

 private:
  [[noreturn]] void refuse(const toml::node& node, const std::string& expected) const {
    throw StudyFileError(
        fmt::format("{}:{}: expected {}", path_, node.source().begin.line, expected));
  }

  void know(const toml::table& table, const std::vector<std::string>& keys) const {
    for (const auto& [key, node] : table) {
      if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
      refuse(node, fmt::format("one of {}, got '{}'", fmt::join(keys, ", "), key.str()));
    }
  }

  std::string text(const toml::node& node, const std::string& what) const {
    const auto value = node.value_exact<std::string>();
    if (!value || value->empty()) refuse(node, what + " to be a text");
    return *value;
  }

  int number(const toml::node& node, const std::string& what, int64_t low, int64_t high) const {
    const auto value = node.value_exact<int64_t>();
    if (!value || *value < low || *value > high) {
      refuse(node, fmt::format("{} to be a whole number from {} to {}", what, low, high));
    }
    return static_cast<int>(*value);
  }

  std::vector<const toml::node*> list(const char* key) const {
    std::vector<const toml::node*> nodes;
    const toml::node* node = table_.get(key);
    if (node == nullptr) return nodes;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->empty())
      refuse(*node, fmt::format("{} to be a list, not empty", key));
    for (const toml::node& one : *array) nodes.push_back(&one);
    return nodes;
  }

  std::vector<const toml::table*> tables(const char* key) const {
    std::vector<const toml::table*> result;
    const toml::node* node = table_.get(key);
    if (node == nullptr) return result;
    const toml::array* array = node->as_array();
    if (array == nullptr) refuse(*node, fmt::format("[[{}]], a table in a list", key));
    for (const toml::node& one : *array) {
      if (!one.is_table()) refuse(one, fmt::format("[[{}]], a table in a list", key));
      result.push_back(one.as_table());
    }
    return result;
  }

  void read_measures() {
    for (const toml::node* node : list("measures")) {
      const std::string word = text(*node, "a measure");
      const auto measure = spec::named<Measure>(word);
      if (!measure) {
        refuse(*node, fmt::format("one of {}, got '{}'", spec::words_of<Measure>(), word));
      }
      study_.measures.push_back(*measure);
    }
    if (study_.measures.empty()) study_.measures = {Measure::kCycles, Measure::kError};
  }

  // ---- Scenes

  /// A scene as the file asks for it.
  struct AskedScene {
    std::string name, scene;
    Options options;
    std::string options_text;  // the same, as the file has them
  };

  void add_scene(AskedScene asked, const toml::node& node) {
    const std::string& scene = asked.scene;
    Options& options = asked.options;
    options.scene = scene;
    std::string content = scene;
    if (scene == "bunny") {
      content += " " + there(kBunnyFile, node);
      options.scene = kBunnyFile;
      if (options.size.empty()) options.size = "1920x1080";
    } else if (fs::path(scene).has_extension()) {
      content = there(folder_ / scene, node);
      options.scene = (folder_ / scene).string();
    } else {
      know_built_in(scene, node);
    }
    for (const studies::StudyScene& other : study_.scenes) {
      if (other.name == asked.name) {
        refuse(node, fmt::format("another name, '{}' is there twice", asked.name));
      }
    }
    study_.scenes.push_back({asked.name, content + " " + asked.options_text,
                             [options](const spec::Contract& contract, bool multi_pass) {
                               return open(options, contract, multi_pass);
                             }});
  }

  std::string there(const fs::path& file, const toml::node& node) const {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      refuse(node, fmt::format("a scene, there is no file {}", file.string()));
    }
    return hash_of(file);
  }

  void know_built_in(const std::string& scene, const toml::node& node) const {
    for (const scene::BuiltIn& one : scene::built_in_scenes()) {
      if (one.name == scene) return;
    }
    refuse(node, fmt::format("a scene's file, bunny, or one that `pineda scenes` lists, got '{}'",
                             scene));
  }

  // Options of a scene as commands have them, with _ for -.
  void add_scene(const toml::table& table) {
    Options o;
    const std::map<std::string, std::function<void(const toml::node&)>> readers{
        {"size", [&](const toml::node& n) { o.size = text(n, "size"); }},
        {"tessellate",
         [&](const toml::node& n) { o.tessellate = number(n, "tessellate", 1, 1000); }},
        {"seed",
         [&](const toml::node& n) {
           o.seed = static_cast<uint64_t>(number(n, "seed", 0, 1'000'000'000));
         }},
        {"cull", [&](const toml::node& n) { o.cull = word<spec::Cull>(n, "cull"); }},
        {"depth", [&](const toml::node& n) { o.depth = word<spec::DepthFunc>(n, "depth"); }},
        {"depth_write", [&](const toml::node& n) { o.depth_write = word<bool>(n, "depth_write"); }},
        {"shade", [&](const toml::node& n) { o.shade = word<spec::Shade>(n, "shade"); }},
        {"scissor", [&](const toml::node& n) { o.scissor = text(n, "scissor"); }},
        {"depth_bias", [&](const toml::node& n) { o.depth_bias = text(n, "depth_bias"); }},
        {"clear_depth", [&](const toml::node& n) { o.clear_depth = written(n); }},
        {"reverse_z", [&](const toml::node& n) { o.reverse_z = truth(n, "reverse_z"); }},
        {"eye", [&](const toml::node& n) { o.eye = vector(n, "eye"); }},
        {"look_at", [&](const toml::node& n) { o.look_at = vector(n, "look_at"); }},
        {"fov", [&](const toml::node& n) { o.fov_deg = real(n, "fov"); }},
        {"camera", [&](const toml::node& n) { o.camera = number(n, "camera", 0, 1'000'000); }},
    };
    std::vector<std::string> keys{"name", "scene"};
    for (const auto& [key, reader] : readers) keys.push_back(key);
    know(table, keys);
    const toml::node* scene = table.get("scene");
    if (scene == nullptr) refuse(table, "scene = a file or a built-in scene");
    std::string options_text;
    for (const auto& [key, reader] : readers) {
      const toml::node* node = table.get(key);
      if (node == nullptr) continue;
      reader(*node);
      options_text += fmt::format("{}={} ", key, written(*node));
    }
    const std::string place = text(*scene, "scene");
    const toml::node* name = table.get("name");
    add_scene({name != nullptr ? text(*name, "name") : place, place, o, options_text}, table);
  }

  template <class Choice>
  std::string word(const toml::node& node, const std::string& what) const {
    const std::string word = text(node, what);
    if (!spec::named<Choice>(word)) {
      refuse(node,
             fmt::format("{} to be one of {}, got '{}'", what, spec::words_of<Choice>(), word));
    }
    return word;
  }
  bool truth(const toml::node& node, const std::string& what) const {
    const auto value = node.value_exact<bool>();
    if (!value) refuse(node, what + " to be true or false");
    return *value;
  }
  double real(const toml::node& node, const std::string& what) const {
    const auto value = node.value<double>();
    if (!value) refuse(node, what + " to be a number");
    return *value;
  }
  std::vector<double> vector(const toml::node& node, const std::string& what) const {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 3)
      refuse(node, what + " to be a list of three numbers");
    std::vector<double> result;
    for (const toml::node& one : *array) result.push_back(real(one, what));
    return result;
  }

  // ---- Designs

  void add_design(const spec::Design& design, const toml::node& node) {
    for (const spec::Design& other : study_.designs) {
      if (std::string(other.name) == design.name) {
        refuse(node, fmt::format("another name, '{}' is there twice", design.name));
      }
    }
    study_.designs.push_back(design);
    design_nodes_.push_back(&node);
  }

  void add_designs(const std::string& name, const toml::node& node) {
    if (name == "all") {
      for (const spec::Design& design : spec::designs()) {
        if (spec::no_rtl_reason(design).empty()) add_design(design, node);
      }
    } else if (const auto* design = spec::find_design(name)) {
      add_design(*design, node);
    } else if (fs::path(name).extension() == ".toml") {
      add_design(spec::read_design((folder_ / name).string()), node);
    } else {
      refuse(node, fmt::format("a named design, all, or a file .toml, got '{}'", name));
    }
  }

  /// A parameter and the values that it takes, as a design file writes them.
  struct Axis {
    std::string key;
    std::vector<std::string> values;
    uint32_t line;
  };

  Axis axis_of(const std::string& key, const toml::node& node) const {
    Axis axis{key, {}, node.source().begin.line};
    const auto add = [&](const toml::node& one) {
      const auto range = one.value_exact<std::string>();
      if (range && range->find("..") != std::string::npos) {
        for (const int value : range_of(*range, one)) axis.values.push_back(std::to_string(value));
      } else {
        axis.values.push_back(written(one));
      }
    };
    if (const toml::array* array = node.as_array()) {
      if (array->empty()) refuse(node, key + " to have a value, the list is empty");
      for (const toml::node& one : *array) add(one);
    } else {
      add(node);
    }
    return axis;
  }

  /// "4..12" or "4..12:2".
  std::vector<int> range_of(const std::string& text, const toml::node& node) const {
    static const std::regex kForm("(-?[0-9]{1,7})\\.\\.(-?[0-9]{1,7})(:([0-9]{1,7}))?");
    std::smatch parts;
    if (!std::regex_match(text, parts, kForm)) {
      refuse(node, fmt::format("a range as '4..12' or '4..12:2', got '{}'", text));
    }
    const int first = std::stoi(parts[1]), last = std::stoi(parts[2]);
    const int step = parts[4].matched ? std::stoi(parts[4]) : 1;
    if (first > last || step == 0)
      refuse(node, fmt::format("a range that is not empty, got '{}'", text));
    std::vector<int> values;
    for (int value = first; value <= last; value += step) values.push_back(value);
    return values;
  }

  void add_designs(const toml::table& table) {
    std::vector<Axis> axes;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (name == "name" || name == "base") continue;
      const bool known = std::any_of(std::begin(spec::kParameters), std::end(spec::kParameters),
                                     [&](const spec::Parameter& p) { return name == p.key; });
      if (!known) {
        refuse(node,
               fmt::format("base, name or a parameter of a design (see pineda designs), got '{}'",
                           name));
      }
      axes.push_back(axis_of(name, node));
    }
    // The table's keys come by name; the file's order is what its writer sees.
    std::stable_sort(axes.begin(), axes.end(),
                     [](const Axis& a, const Axis& b) { return a.line < b.line; });
    const std::string base =
        table.contains("base") ? text(*table.get("base"), "base") : "high_tile";
    if (spec::find_design(base) == nullptr) refuse(*table.get("base"), "base to be a named design");
    const std::string name = table.contains("name") ? text(*table.get("name"), "name") : "";
    std::vector<size_t> at(axes.size(), 0);
    size_t added = 0;
    for (bool more = true; more;) {
      added += add_combination(table, base, name, axes, at) ? 1 : 0;
      more = false;
      for (size_t i = axes.size(); i-- > 0 && !more;) {
        at[i] = (at[i] + 1) % axes[i].values.size();
        more = at[i] != 0;
      }
    }
    if (added == 0) refuse(table, "a design that can be built: " + reason_);
  }

  bool add_combination(const toml::table& table, const std::string& base,
                       const std::string& pattern, const std::vector<Axis>& axes,
                       const std::vector<size_t>& at) {
    std::string name = pattern.empty() ? base : pattern;
    std::string body;
    for (size_t i = 0; i < axes.size(); ++i) {
      const std::string& value = axes[i].values[at[i]];
      body += fmt::format("{} = {}\n", axes[i].key, value);
      std::string shown = value;
      shown.erase(
          std::remove_if(shown.begin(), shown.end(), [](char c) { return c == '\'' || c == '"'; }),
          shown.end());
      const std::string place = "{" + axes[i].key + "}";
      const size_t found = name.find(place);
      if (found != std::string::npos) {
        name.replace(found, place.size(), shown);
      } else if (pattern.empty() || axes[i].values.size() > 1) {
        name += fmt::format(" {}={}", axes[i].key, shown);
      }
    }
    try {
      add_design(
          spec::parse_design(fmt::format("base = '{}'\nname = '{}'\nsummary = 'of study {}'\n{}",
                                         base, name, study_.name, body),
                             path_),
          table);
      return true;
    } catch (const spec::DesignFileError& error) {
      const std::string what = error.what();
      const std::string cannot = "expected a design that can be built: ";
      if (const size_t found = what.find(cannot); found != std::string::npos) {
        if (left_out_++ == 0)
          reason_ = fmt::format("{}: {}", name, what.substr(found + cannot.size()));
        return false;
      }
      for (const Axis& axis : axes) {
        const std::string expected = "expected " + axis.key + " to be";
        const size_t found = what.find(expected);
        if (found == std::string::npos) continue;
        throw StudyFileError(fmt::format("{}:{}: {}", path_, axis.line, what.substr(found)));
      }
      refuse(table, what);
    }
  }

  // ---- Memories and technologies

  void add_memory(studies::StudyMemory memory, const toml::node& node) {
    for (const studies::StudyMemory& other : study_.memories) {
      if (other.name == memory.name) {
        refuse(node, fmt::format("another name, '{}' is there twice", memory.name));
      }
    }
    study_.memories.push_back(std::move(memory));
  }

  memory::Kind kind_of(const std::string& word, const toml::node& node) const {
    const auto kind = spec::named<memory::Kind>(word);
    if (!kind)
      refuse(node, fmt::format("one of {}, got '{}'", spec::words_of<memory::Kind>(), word));
    return *kind;
  }

  void add_memory(const std::string& word, const toml::node& node) {
    studies::StudyMemory memory;
    memory.name = word;
    memory.kind = kind_of(word, node);
    add_memory(std::move(memory), node);
  }

  void add_memory(const toml::table& table) {
    studies::StudyMemory memory;
    const toml::node* kind = table.get("kind");
    if (kind == nullptr) refuse(table, "kind = " + spec::words_of<memory::Kind>());
    memory.kind = kind_of(text(*kind, "kind"), *kind);
    std::vector<std::string> keys{"name", "kind"};
    const bool has_latency = spec::row_of(memory.kind).has_latency;
    if (has_latency) keys.emplace_back("latency_cycles");
    for (const auto& p : studies::kDramParameters) {
      if (!has_latency) keys.emplace_back(p.key);
    }
    know(table, keys);
    memory.name =
        table.contains("name") ? text(*table.get("name"), "name") : spec::name_of(memory.kind);
    if (const toml::node* latency = table.get("latency_cycles")) {
      memory.latency_cycles = number(*latency, "latency_cycles", 1, spec::kMaxDepthLatencyCycles);
    }
    for (const auto& p : studies::kDramParameters) {
      if (const toml::node* node = table.get(p.key)) {
        memory.dram.*p.member = number(*node, p.key, 0, 1'000'000'000);
      }
    }
    if (const std::string reason = memory::invalid_reason(memory.dram); !reason.empty()) {
      refuse(table, "a memory that can be: " + reason);
    }
    add_memory(std::move(memory), table);
  }

  /// `name`: known, or a file. Its key is its TOML file: the cells may be missing on this machine.
  void add_technology(std::string name, const std::string& liberty, const toml::node& node) {
    const bool is_file = fs::path(name).extension() == ".toml";
    if (is_file) name = (folder_ / name).string();
    for (const studies::StudyTechnology& other : study_.technologies) {
      if (other.name == name)
        refuse(node, fmt::format("another technology, '{}' is there twice", name));
    }
    const auto names = studies::technology_names();
    if (!is_file && std::find(names.begin(), names.end(), name) == names.end()) {
      refuse(node,
             fmt::format("one of {}, or a file .toml, got '{}'", fmt::join(names, ", "), name));
    }
    const fs::path file =
        is_file ? fs::path(name)
                : files::data_folder() / "studies/area/technologies" / (name + ".toml");
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      refuse(node, fmt::format("a technology, there is no file {}", file.string()));
    }
    study_.technologies.push_back(
        {name, liberty, fmt::format("{:016x}", spec::text_hash(bytes_of(file)))});
  }

  void add_technology(const toml::table& table) {
    know(table, {"technology", "liberty"});
    const toml::node* name = table.get("technology");
    if (name == nullptr) refuse(table, "technology = a name or a file .toml");
    std::string liberty;
    if (const toml::node* node = table.get("liberty")) {
      liberty = (folder_ / text(*node, "liberty")).string();
      std::error_code error;
      if (!fs::is_regular_file(liberty, error)) {
        refuse(*node, fmt::format("cells, there is no file {}", liberty));
      }
    }
    add_technology(text(*name, "technology"), liberty, table);
  }

  // ---- The whole

  bool asks(studies::DependsOn on) const {
    return std::any_of(study_.measures.begin(), study_.measures.end(),
                       [&](Measure measure) { return spec::row_of(measure).on == on; });
  }

  void complete() {
    using studies::DependsOn;
    if (study_.designs.empty()) refuse(table_, "designs = a list of designs, or [[design]]");
    const bool needs_time = asks(DependsOn::kFrame) || asks(DependsOn::kMachine);
    if (study_.scenes.empty() && (needs_time || asks(DependsOn::kScene))) {
      refuse(table_, "scenes = a list of scenes, or [[scene]]");
    }
    if (study_.memories.empty() && needs_time)
      add_memory(spec::name_of(memory::Kind::kIdeal), table_);
    if (study_.technologies.empty() && asks(DependsOn::kTechnology)) {
      add_technology("osu018", "", table_);
    }
  }

  void check_designs() const {
    using studies::DependsOn;
    for (size_t i = 0; i < study_.designs.size(); ++i) {
      const spec::Design& design = study_.designs[i];
      std::string reason;
      if (asks(DependsOn::kFrame) || asks(DependsOn::kMachine))
        reason = spec::no_cycles_reason(design);
      if (reason.empty() && asks(DependsOn::kTechnology)) reason = spec::no_rtl_reason(design);
      if (!reason.empty()) {
        refuse(*design_nodes_[i],
               fmt::format("a design that can be measured: {}: {}", design.name, reason));
      }
    }
  }

  std::string path_;
  fs::path folder_;
  toml::table table_;
  studies::Study study_;
  std::vector<const toml::node*> design_nodes_;  // where each design stands
  size_t left_out_ = 0;
  std::string reason_;
};

}  // namespace

StudyFile read_study(const std::string& path) { return Reader(path).read(); }

}  // namespace pineda::cli
