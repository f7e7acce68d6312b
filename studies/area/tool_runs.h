// Runs of synthesis and timing tools, whose results are kept.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pineda::studies {

/// One run of a tool.
struct ToolRun {
  std::string tool;  // yosys or sta
  /// Reads files of the cache by the names that ToolRuns gave them, and writes to kOut/NAME.
  std::string script;
  std::string what;  // "mapping of stamp_walker", for messages
};

/// Where a script's results go.
inline constexpr const char* kOut = "@OUT@";

/// A text as one word of the shell.
std::string quoted(const std::string& text);
/// What a file holds. Throws AreaError where it cannot be read.
std::string text_of(const std::filesystem::path& file);
/// The first line that a shell's command writes to its standard output.
std::string first_line_of(const std::string& command);

/// Runs tools, as many at once as there are processors, and keeps each result in a folder of the
/// cache that is named by the tool, its version and the script. What a script reads has names made
/// from content, so a result is found again exactly as long as nothing that it depends on changes.
class ToolRuns {
 public:
  /// `tools`: those that runs will need. `say` hears before something runs that takes its time.
  ///
  /// Errors   AreaError: a tool is missing, with what to install; the cache cannot be written.
  ToolRuns(std::filesystem::path cache, const std::vector<std::string>& tools,
           std::function<void(const std::string&)> say);

  /// Puts a text into the cache; its name there.
  std::string keep(const std::string& text, const std::string& ending) const;

  /// The folders of the results, in the order of the runs; what is not there yet is run.
  ///
  /// Errors   AreaError: a run failed; its log is kept and named. Those that ended well stay.
  std::vector<std::filesystem::path> run(const std::vector<ToolRun>& runs) const;

  /// As a script names a file of the cache.
  std::string name_of(const std::filesystem::path& file) const;
  std::filesystem::path file(const std::string& name) const { return cache_ / name; }
  /// "Yosys 0.23", "OpenSTA 2.0.17".
  std::vector<std::string> versions() const;

 private:
  std::string key_of(const ToolRun& run) const;

  std::filesystem::path cache_;
  std::function<void(const std::string&)> say_;
  std::map<std::string, std::string> version_;  // by tool
};

/// Those of all area studies: in the folder `area` of the cache of plug-ins.
ToolRuns area_tool_runs(std::function<void(const std::string&)> say);

}  // namespace pineda::studies
