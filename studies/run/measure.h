// Does a task of a study.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/run/tasks.h"

namespace pineda::studies {

/// The rows of a task with their figures. SystemC elaborates once a process: of the tasks that depend
/// on a frame, a process does one.
///
/// In       `made_by`: the program's version, for the rows.
/// Errors   of the scene, the design, the tools: what they throw, in one line.
std::vector<Row> measured(const Study& study, const Task& task, const std::string& made_by,
                          const std::function<void(const std::string&)>& say);

}  // namespace pineda::studies
