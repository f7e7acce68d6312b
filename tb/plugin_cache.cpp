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

#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "tb/rtl.h"

namespace pineda::tb {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = PINEDA_SOURCE_DIR;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool on_path(const std::string& tool) {
  std::istringstream path(environment("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    if (access((fs::path(folder) / tool).c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Everything that a plug-in is made from, so that no stale one is ever taken.
std::string key_of(const spec::Contract& contract) {
  std::vector<fs::path> files{kSource / "tb/plugin.mk", kSource / "tb/plugin.cpp",
                              kSource / "tb/plugin.h", kSource / "tb/plugin.map"};
  for (const char* folder : {"rtl", "rtl/lib", "rtl/lint"}) {
    for (const auto& entry : fs::directory_iterator(kSource / folder)) {
      // The committed package is not used: each design generates its own.
      if (entry.is_regular_file() && entry.path().filename() != "pineda_pkg.sv") {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  std::string text = spec::package_text(contract) + environment("CXXFLAGS");
  for (const auto& file : files) text += file.string() + read(file);
  return fmt::format("{}_{:016x}", contract.design.name, spec::text_hash(text));
}

void require_tools(const spec::Contract& contract) {
  for (const char* tool : {"verilator", "make", "g++"}) {
    if (on_path(tool)) continue;
    throw PluginError(
        fmt::format("no RTL of design '{}' is built yet, and {} is missing to build it; pineda "
                    "render and pineda time serve without",
                    contract.design.name, tool));
  }
  if (!fs::exists(kSource / "tb/plugin.mk")) {
    throw PluginError(
        fmt::format("no RTL of design '{}' is built yet, and its sources are not in {}",
                    contract.design.name, kSource.string()));
  }
}

/// A folder of its own beside the result.
fs::path make_work_folder(const fs::path& cache, const std::string& key) {
  std::error_code error;
  fs::create_directories(cache, error);
  std::string name = (cache / (key + ".XXXXXX")).string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw PluginError(fmt::format(
        "{}: expected a folder to keep the RTL of designs in ($PINEDA_CACHE)", cache.string()));
  }
  return name;
}

}  // namespace

std::string plugin_cache_folder() {
  if (const std::string own = environment("PINEDA_CACHE"); !own.empty()) return own;
  if (const std::string xdg = environment("XDG_CACHE_HOME"); !xdg.empty()) return xdg + "/pineda";
  return environment("HOME") + "/.cache/pineda";
}

std::string cached_plugin(const spec::Contract& contract,
                          const std::function<void(const std::string&)>& say) {
  const fs::path cache = fs::absolute(plugin_cache_folder());
  require_tools(contract);
  const std::string key = key_of(contract);
  const fs::path result = cache / (key + ".so");
  if (fs::exists(result)) return result.string();
  if (cache.string().find_first_of(" \t'\"$#%:") != std::string::npos) {
    throw PluginError(
        fmt::format("{}: expected a cache folder whose name make can take "
                    "($PINEDA_CACHE)",
                    cache.string()));
  }
  const fs::path work = make_work_folder(cache, key);
  if (say) {
    say(fmt::format("building the RTL of design '{}' once, into {}: one to three minutes",
                    contract.design.name, cache.string()));
  }
  std::ofstream(work / "design.toml") << spec::design_toml(contract.design);
  const fs::path emit = fs::read_symlink("/proc/self/exe").parent_path() / "bin/emit_package";
  const std::string command = fmt::format(
      "make -s -j{0} -f '{1}/tb/plugin.mk' DESIGN={2}/design.toml EMIT='{3}' WORK={2}/objects "
      "OUT={2}/plugin.so > {2}/log 2>&1",
      std::max(1u, std::thread::hardware_concurrency()), kSource.string(), work.string(),
      emit.string());
  if (std::system(command.c_str()) != 0 || !fs::exists(work / "plugin.so")) {
    throw PluginError(fmt::format("the RTL of design '{}' could not be built: see {}",
                                  contract.design.name, (work / "log").string()));
  }
  fs::rename(work / "plugin.so", result);
  std::error_code ignored;
  fs::remove_all(work, ignored);
  return result.string();
}

}  // namespace pineda::tb
