#include "studies/area/slowest_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "studies/area/area_error.h"

namespace pineda::studies {
namespace {

std::string script_of(const Synthesis& synthesis, const Technology& technology,
                      const std::string& netlist, const std::string& top, int period_ps) {
  const Liberty& library = technology.liberty;
  return fmt::format(
      "read_liberty {0}\nread_verilog {1}\nlink_design {2}\n"
      "create_clock -name clk -period {3} [get_ports clk_i]\n"
      "set_false_path -from [get_ports rst_ni]\n"
      "set_input_delay 0 -clock clk [all_inputs]\nset_output_delay 0 -clock clk [all_outputs]\n"
      "set_driving_cell -lib_cell {4} [all_inputs]\nset_load {5} [all_outputs]\n"
      "report_checks -path_delay max -format full -digits 6 -group_count 1000 > {6}/paths.txt\n"
      "set inputs {{}}\n"
      "foreach port [all_inputs] {{\n"
      "  if {{[lsearch {{clk_i rst_ni}} [get_property $port full_name]] < 0}} {{lappend inputs "
      "$port}}\n"
      "}}\n"
      "report_checks -path_delay max -format full -digits 6 -from $inputs -to [all_outputs]"
      " > {6}/through.txt\n",
      synthesis.liberty(), netlist, top, period_ps / library.time_unit_ps(),
      technology.driving_cell, technology.load_ff / library.capacitance_unit_ff(), kOut);
}

/// Reads the report of OpenSTA line by line.
class ReportReader {
 public:
  ReportReader(const std::map<std::string, std::string>& instances, const Technology& technology,
               double period_ps)
      : instances_(instances), technology_(technology), period_ps_(period_ps) {}

  std::vector<TimingPath> run(std::istream& report) {
    for (std::string line; std::getline(report, line);) take(line);
    std::stable_sort(paths_.begin(), paths_.end(),
                     [](const TimingPath& a, const TimingPath& b) { return a.ps > b.ps; });
    return paths_;
  }

 private:
  double ps(double units) const { return units * technology_.liberty.time_unit_ps(); }

  void take(const std::string& line) {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second >> third;
    if (first == "Startpoint:") {
      paths_.emplace_back();
      paths_.back().from = second;
    }
    if (paths_.empty()) return;
    TimingPath& path = paths_.back();
    if (first == "Endpoint:") path.to = second;
    if (second == "slack") path.ps = period_ps_ - ps(std::strtod(first.c_str(), nullptr));
    if (line.find("library setup time") != std::string::npos) {
      path.fixed_ps += std::fabs(ps(std::strtod(first.c_str(), nullptr)));
    }
    if (third == "^" || third == "v")
      take_point(&path, ps(std::strtod(first.c_str(), nullptr)), &words);
  }

  // "DELAY TIME ^ INSTANCE/PIN (CELL)"
  void take_point(TimingPath* path, double delay, std::istringstream* words) {
    std::string pin, cell;
    *words >> pin >> cell;
    if (cell.size() < 2) return;
    cell = cell.substr(1, cell.size() - 2);
    const auto known = technology_.liberty.cells().find(cell);
    const bool is_logic =
        known != technology_.liberty.cells().end() && known->second.flip_flops == 0;
    if (!is_logic) {
      path->fixed_ps += delay;
      return;
    }
    const auto& [instance, module] = instance_of(pin);
    if (path->parts.empty() || path->parts.back().instance != instance) {
      path->parts.push_back({instance, module, 0, 0});
    }
    path->parts.back().ps += delay;
    ++path->parts.back().cells;
  }

  // The innermost instance on the way to a pin, and its module.
  const std::pair<const std::string, std::string>& instance_of(const std::string& pin) const {
    std::string path = pin.substr(0, pin.rfind('/'));
    while (true) {
      const size_t dot = path.rfind('.');
      path = dot == std::string::npos ? "" : path.substr(0, dot);
      const auto place = instances_.find(path);
      if (place != instances_.end()) return *place;
    }
  }

  const std::map<std::string, std::string>& instances_;
  const Technology& technology_;
  double period_ps_;
  std::vector<TimingPath> paths_;
};

}  // namespace

int TimingPath::levels() const {
  int cells = 0;
  for (const PathPart& part : parts) cells += part.cells;
  return cells;
}

std::vector<NetlistTiming> netlist_timings(const Synthesis& synthesis, const Technology& technology,
                                           const ToolRuns& runs,
                                           const std::vector<std::string>& tops, int period_ps) {
  const auto netlists = synthesis.flat_netlists(tops);
  std::vector<ToolRun> all;
  for (size_t i = 0; i < tops.size(); ++i) {
    all.push_back({"sta", script_of(synthesis, technology, netlists[i], tops[i], period_ps),
                   fmt::format("timing {} at {} ps", tops[i], period_ps)});
  }
  const auto folders = runs.run(all);
  std::vector<NetlistTiming> result;
  for (size_t i = 0; i < tops.size(); ++i) {
    const auto instances = synthesis.instances(tops[i]);
    const auto read = [&](const char* file) {
      std::ifstream report(folders[i] / file);
      return ReportReader(instances, technology, period_ps).run(report);
    };
    auto paths = read("paths.txt");
    if (paths.empty()) throw AreaError(fmt::format("{}: expected a path, there is none", tops[i]));
    const auto fast = std::find_if(paths.begin() + 1, paths.end(),
                                   [&](const TimingPath& path) { return path.ps <= period_ps; });
    paths.erase(fast, paths.end());
    const auto through = read("through.txt");
    result.push_back({std::move(paths), through.empty() ? TimingPath{} : through.front()});
  }
  return result;
}

}  // namespace pineda::studies
