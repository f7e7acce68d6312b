#include "studies/area/tool_runs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>
#include <utility>

#include "model/spec/package.h"
#include "studies/area/area_error.h"
#include "studies/area/rtlil.h"
#include "tb/plugin_cache.h"
#include "tb/work_folder.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

struct Tool {
  const char* name;     // of the program
  const char* package;  // of Debian
  const char* version;  // a command that prints it
  const char* options;  // to run a script
};

constexpr std::array<Tool, 2> kTools{{
    {"yosys", "yosys", "yosys -V", "yosys -q -s"},
    {"sta", "opensta", "sta -version", "sta -no_splash -exit"},
}};

const Tool& tool_named(const std::string& name) {
  return *std::find_if(kTools.begin(), kTools.end(),
                       [&](const Tool& tool) { return name == tool.name; });
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    throw AreaError(fmt::format("{}: expected a folder to keep results in ($PINEDA_CACHE)",
                                file.parent_path().string()));
  }
}

/// The line of a log that says what went wrong; the last one if none does.
std::string error_of(const fs::path& log) {
  std::ifstream lines(log);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ERROR", 0) == 0 || line.rfind("Error", 0) == 0) return line;
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream)
    throw AreaError(fmt::format("{}: expected this file, cannot read it", file.string()));
  return text.str();
}

std::string first_line_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string line;
  for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe.get())) != EOF && c != '\n';) {
    line += static_cast<char>(c);
  }
  return line;
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

ToolRuns::ToolRuns(fs::path cache, const std::vector<std::string>& tools,
                   std::function<void(const std::string&)> say)
    : cache_(std::move(cache)), say_(std::move(say)) {
  for (const std::string& name : tools) {
    const Tool& tool = tool_named(name);
    if (!tb::on_path(tool.name)) {
      throw AreaError(fmt::format("expected {} on the path: install {}", tool.name, tool.package));
    }
    version_[tool.name] = first_line_of(tool.version);
  }
  std::error_code ignored;
  fs::create_directories(cache_, ignored);
}

std::string ToolRuns::keep(const std::string& text, const std::string& ending) const {
  const std::string name = fmt::format("{:016x}{}", spec::text_hash(text), ending);
  const fs::path file = cache_ / name;
  std::error_code error;
  if (fs::exists(file) && fs::file_size(file, error) == text.size()) return name;
  // Two processes may write the same text: the last rename wins.
  const fs::path part = cache_ / fmt::format("{}.{}.part", name, getpid());
  write(part, text);
  fs::rename(part, file);
  return name;
}

std::string ToolRuns::name_of(const fs::path& file) const {
  return fs::relative(file, cache_).string();
}

std::string ToolRuns::key_of(const ToolRun& run) const {
  return fmt::format("{}_{:016x}", run.tool,
                     spec::text_hash(run.tool + "\n" + version_.at(run.tool) + "\n" + run.script));
}

std::vector<fs::path> ToolRuns::run(const std::vector<ToolRun>& runs) const {
  std::vector<fs::path> results;
  std::vector<std::pair<std::string, const ToolRun*>> missing;  // key, run
  for (const ToolRun& one : runs) {
    const std::string key = key_of(one);
    results.push_back(cache_ / key);
    const bool is_listed = std::any_of(missing.begin(), missing.end(),
                                       [&](const auto& other) { return other.first == key; });
    if (!fs::exists(results.back()) && !is_listed) missing.emplace_back(key, &one);
  }
  if (missing.empty()) return results;
  if (say_) {
    say_(missing.size() == 1
             ? missing.front().second->what
             : fmt::format("{} and {} more", missing.front().second->what, missing.size() - 1));
  }
  tb::sweep_work_folders(cache_);
  const tb::WorkFolder folder(cache_,
                              fmt::format("runs_{:016x}", spec::text_hash(missing.front().first)));
  const std::string work = fs::relative(folder.path(), cache_).string();
  std::string keys;
  for (const auto& [key, one] : missing) keys.append(" ").append(key);
  std::string make = fmt::format("all:{0}\n.PHONY: all{0}\n", keys);
  for (const auto& [key, one] : missing) {
    fs::create_directories(folder.path() / key);
    write(folder.path() / (key + ".script"),
          replaced(one->script, kOut, fmt::format("{}/{}", work, key)));
    make += fmt::format(
        "{0}:\n\t@cd .. && {1} {2}/{0}.script > {2}/{0}.log 2>&1 < /dev/null && "
        "! grep -q '^Error' {2}/{0}.log && mv {2}/{0} {0} || "
        "{{ mv {2}/{0}.log {0}.log; echo {0} >> {2}/failed; false; }}\n",
        key, tool_named(one->tool).options, work);
  }
  write(folder.path() / "Makefile", make);
  const std::string command =
      fmt::format("cd {} && exec make -s -k -j{} > make.log 2>&1", quoted(folder.path().string()),
                  std::max(1u, std::thread::hardware_concurrency()));
  if (folder.run(command)) return results;
  std::ifstream failed(folder.path() / "failed");
  std::string key;
  std::getline(failed, key);
  for (const auto& [name, one] : missing) {
    if (name != key) continue;
    const fs::path log = cache_ / (key + ".log");
    throw AreaError(fmt::format("{} failed: {} ({})", one->what, error_of(log), log.string()));
  }
  throw AreaError("make failed to run the tools: is it installed?");
}

std::vector<std::string> ToolRuns::versions() const {
  std::vector<std::string> all;
  for (const auto& [tool, version] : version_) all.push_back(version);
  return all;
}

ToolRuns area_tool_runs(std::function<void(const std::string&)> say) {
  return {fs::absolute(tb::plugin_cache_folder()) / "area", {"yosys", "sta"}, std::move(say)};
}

}  // namespace pineda::studies
