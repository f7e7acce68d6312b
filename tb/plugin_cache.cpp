#include "tb/plugin_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "model/files/data_folder.h"
#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "tb/rtl.h"
#include "tb/work_folder.h"

namespace pineda::tb {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// A kind of plug-in: who builds it.
struct Kind {
  std::string name;            // NAME.mk, NAME.cpp and NAME.h in tb/
  std::string compiler;        // empty: that of make
  std::string what;            // "the RTL"
  std::string tag = {};        // of its files in the cache, behind the design's name
  std::string variables = {};  // further ones of make
  std::string verilog = {};    // in place of the RTL
};

/// Everything that a plug-in is made from, so that no stale one is ever taken.
std::string key_of(const spec::Contract& contract, const Kind& kind) {
  const fs::path source = files::data_folder();
  std::vector<fs::path> files{source / "tb/plugin.map", source / "model/spec/pack.h"};
  for (const char* ending : {".mk", ".cpp", ".h"})
    files.push_back(source / "tb" / (kind.name + ending));
  for (const auto& entry : fs::recursive_directory_iterator(source / "rtl")) {
    // The committed package is not used: each design generates its own.
    if (entry.is_regular_file() && entry.path().filename() != "pineda_pkg.sv") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::string text = spec::package_text(contract) + environment("CXXFLAGS") + environment("UNITS") +
                     kind.compiler + kind.variables + kind.verilog;
  for (const auto& file : files) text += file.lexically_relative(source).string() + read(file);
  return fmt::format("{}{}_{:016x}", contract.design.name, kind.tag, spec::text_hash(text));
}

void require_tools(const spec::Contract& contract, const Kind& kind) {
  const std::string compiler = kind.compiler.empty() ? "g++" : kind.compiler;
  for (const std::string& tool : {std::string("verilator"), std::string("make"), compiler}) {
    if (on_path(tool)) continue;
    throw PluginError(
        fmt::format("no RTL of design '{}' is built yet, and {} is missing to build it; pineda "
                    "render and pineda time serve without",
                    contract.design.name, tool));
  }
  const fs::path source = files::data_folder();
  if (!fs::exists(source / "tb" / (kind.name + ".mk"))) {
    throw PluginError(
        fmt::format("no RTL of design '{}' is built yet, and its sources are not in {}",
                    contract.design.name, source.string()));
  }
}

}  // namespace

bool on_path(const std::string& tool) {
  std::istringstream path(environment("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    if (access((fs::path(folder) / tool).c_str(), X_OK) == 0) return true;
  }
  return false;
}

fs::path built_file(const std::string& name) {
  const fs::path own = files::own_folder();
  for (const fs::path& folder : {own / "lib", own / "bin", own, own.parent_path() / "lib",
                                 own.parent_path() / "lib/pineda"}) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return {};
}

std::string plugin_cache_folder() {
  if (const std::string own = environment("PINEDA_CACHE"); !own.empty()) return own;
  if (const std::string xdg = environment("XDG_CACHE_HOME"); !xdg.empty()) return xdg + "/pineda";
  return environment("HOME") + "/.cache/pineda";
}

namespace {

std::string cached(const spec::Contract& contract, const Kind& kind,
                   const std::function<void(const std::string&)>& say) {
  const fs::path cache = fs::absolute(plugin_cache_folder());
  require_tools(contract, kind);
  const std::string key = key_of(contract, kind);
  const fs::path result = cache / (key + ".so");
  const fs::path log = cache / (key + ".log");
  sweep_work_folders(cache);
  if (fs::exists(result)) return result.string();
  if (cache.string().find_first_of(" \t'\"$#%:") != std::string::npos) {
    throw PluginError(
        fmt::format("{}: expected a cache folder whose name make can take "
                    "($PINEDA_CACHE)",
                    cache.string()));
  }
  const WorkFolder folder(cache, key);
  const fs::path& work = folder.path();
  if (say) {
    say(fmt::format("building {} of design '{}' once, into {}: one to three minutes", kind.what,
                    contract.design.name, cache.string()));
  }
  std::ofstream(work / "design.toml") << spec::design_toml(contract.design);
  const fs::path emit = built_file("emit_package");
  const std::string compiler = kind.compiler.empty() ? "" : "CXX=" + kind.compiler;
  std::string variables = kind.variables;
  if (!kind.verilog.empty()) {
    std::ofstream(work / "mutants.v") << kind.verilog;
    variables += fmt::format(" RTL_SOURCES={}/mutants.v LINT=", work.string());
  }
  const std::string command = fmt::format(
      "exec make -s -j{0} -f '{1}/tb/{4}.mk' DESIGN={2}/design.toml EMIT='{3}' WORK={2}/objects "
      "OUT={2}/plugin.so {5} {6} < /dev/null > {2}/log 2>&1",
      std::max(1u, std::thread::hardware_concurrency()), files::data_folder().string(),
      work.string(), emit.string(), kind.name, compiler, variables);
  std::error_code ignored;
  if (!folder.run(command) || !fs::exists(work / "plugin.so")) {
    fs::rename(work / "log", log, ignored);
    throw PluginError(fmt::format("the RTL of design '{}' could not be built: see {}",
                                  contract.design.name, log.string()));
  }
  fs::rename(work / "plugin.so", result);
  fs::remove(log, ignored);
  return result.string();
}

}  // namespace

std::string cached_plugin(const spec::Contract& contract,
                          const std::function<void(const std::string&)>& say) {
  return cached(contract, {"plugin", "", "the RTL", "", ""}, say);
}

std::string cached_bench_plugin(const spec::Contract& contract, const std::string& compiler,
                                const std::function<void(const std::string&)>& say) {
  return cached(contract, {"bench_plugin", compiler, "the bare RTL (" + compiler + ")"}, say);
}

std::string cached_coverage_plugin(const spec::Contract& contract, const std::string& module,
                                   const std::function<void(const std::string&)>& say) {
  // Cases are few: quick to compile matters more than quick to run.
  return cached(contract,
                {"plugin", "", module + " with counters", "_" + module,
                 "COVERAGE=1 CXXFLAGS=-O1 UNITS=" + module},
                say);
}

std::string cached_mutants_plugin(const spec::Contract& contract, const std::string& unit,
                                  const std::string& verilog,
                                  const std::function<void(const std::string&)>& say) {
  return cached(contract,
                {"plugin", "", "the mutants of " + unit, "_mutants_" + unit,
                 fmt::format("UNITS={}_unit VERILATOR_WARNINGS='-Wno-fatal -Wno-lint' "
                             "CXXFLAGS='-O0 -DPINEDA_MUTANTS'",
                             unit),
                 verilog},
                say);
}

}  // namespace pineda::tb
