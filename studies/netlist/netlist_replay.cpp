#include "studies/netlist/netlist_replay.h"

#include <fmt/format.h>

#include <fstream>

#include "model/files/data_folder.h"
#include "model/spec/package.h"
#include "studies/area/area.h"
#include "studies/area/area_error.h"
#include "tb/plugin_cache.h"
#include "tb/work_folder.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

fs::path bench() { return files::data_folder() / "studies/netlist/netlist_bench.sv"; }

void write(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw AreaError(fmt::format("{}: expected to write it, cannot", file.string()));
}

/// Compiles and simulates in a folder UNIT: `vectors` gives `out`; what the tools say goes to `log`.
std::string command_of(const NetlistTask& task, const std::string& cells, uint64_t seed) {
  std::string parameters;
  for (const std::string& parameter : task.vectors->parameters()) {
    parameters += fmt::format(" -Pnetlist_bench.{}", parameter);
  }
  const auto absolute = [](const fs::path& file) { return quoted(fs::absolute(file).string()); };
  return fmt::format(
      "(cd {0} && iverilog -g2012 -Ttyp -I. -s netlist_bench{1} -o bench {2} {3} {4} && "
      "vvp -n bench +vectors=vectors +seed={5} > out) > {0}/log 2>&1 &\n",
      task.vectors->unit(), parameters, absolute(bench()), absolute(cells), absolute(task.netlist),
      seed);
}

/// The first line of a log that tells of an error; the last one if none does.
std::string error_of(const fs::path& log) {
  std::ifstream lines(log);
  std::string last = "it was ended";
  for (std::string line; std::getline(lines, line);) {
    last = line;
    if (line.find("error") != std::string::npos) break;
  }
  return last;
}

}  // namespace

std::string icarus_version() {
  if (!tb::on_path("iverilog")) throw AreaError("expected iverilog on the path: install iverilog");
  return first_line_of("iverilog -V 2> /dev/null");
}

std::vector<fs::path> unit_netlists(const spec::Contract& contract, const Technology& technology,
                                    int clock_ps, const std::vector<std::string>& units,
                                    const ToolRuns& runs) {
  Synthesis synthesis(contract, technology, AreaOptions().least_memory_bits, runs);
  std::map<std::string, int> delays;
  for (const std::string& unit : units) delays.merge(first_delays(synthesis, unit, clock_ps));
  synthesis.map(delays);
  std::vector<fs::path> files;
  for (const std::string& name : synthesis.flat_netlists(units)) files.push_back(runs.file(name));
  return files;
}

std::vector<Replay> replay_netlists(const std::vector<NetlistTask>& tasks, const std::string& cells,
                                    uint64_t seed, const fs::path& cache) {
  tb::sweep_work_folders(cache);
  std::string script;
  for (const NetlistTask& task : tasks) script += command_of(task, cells, seed);
  const tb::WorkFolder folder(cache, fmt::format("netlist_{:016x}", spec::text_hash(script)));
  for (const NetlistTask& task : tasks) {
    const fs::path own = folder.path() / task.vectors->unit();
    fs::create_directory(own);
    write(own / "unit.svh", task.vectors->instance());
    write(own / "vectors", task.vectors->text());
  }
  write(folder.path() / "run.sh", script + "wait\n");
  folder.run(fmt::format("cd {} && exec sh run.sh", quoted(folder.path().string())));
  std::vector<Replay> replays;
  for (const NetlistTask& task : tasks) {
    const fs::path own = folder.path() / task.vectors->unit();
    std::ifstream written(own / "out");
    replays.push_back(task.vectors->compare(written));
    if (replays.back().is_complete) continue;
    throw AreaError(
        fmt::format("{}: Icarus failed: {}", task.netlist.string(), error_of(own / "log")));
  }
  return replays;
}

}  // namespace pineda::studies
