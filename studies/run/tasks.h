// What of a study is to be done, and the keys of its results.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "studies/run/results.h"

namespace pineda::studies {

/// Results that come from one piece of work: of a frame, a scene, or a design in a technology.
struct Task {
  DependsOn on = DependsOn::kFrame;
  size_t scene = 0, design = 0, memory = 0,
         technology = 0;  // places in the study, where it depends on them
  std::vector<Row> rows;  // without figures

  bool measures(Measure measure) const;
};

/// A text without its SystemVerilog comments and with one blank for every space: what changes when
/// code changes.
std::string code_of(const std::string& verilog);

/// All tasks of a study, in its order.
///
/// A key is made of the design's parameters, its RTL and package, the scene's content, the memory's
/// parameters, the technology's cells and Measure's revision: bits and cycles are the RTL's, so what
/// changes them changes it. No machine, compiler or tool makes a row stale.
std::vector<Task> tasks_of(const Study& study);

/// Those without rows that are there, and of these the rows that are missing.
std::vector<Task> missing(std::vector<Task> tasks, const std::set<std::string>& keys);

}  // namespace pineda::studies
