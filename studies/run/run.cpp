#include "studies/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "studies/run/children.h"
#include "studies/run/measure.h"
#include "studies/run/tasks.h"

namespace pineda::studies {
namespace {

// Rows with figures on their way through a pipe: one line for who made it, then one for each figure.
std::string text_of(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    text += fmt::format("{}\t{}\t{}\n", row.key, row.figures.size(), row.made_by);
    for (const Figure& f : row.figures) text += fmt::format("{}\t{}\n", f.value, f.name);
  }
  return text;
}

std::vector<Row> rows_of(const std::string& text, std::vector<Row> rows) {
  std::istringstream lines(text);
  for (Row& row : rows) {
    size_t figures = 0;
    lines >> row.key >> figures;
    lines.get();
    std::getline(lines, row.made_by);
    for (size_t i = 0; i < figures; ++i) {
      Figure figure;
      lines >> figure.value >> figure.name;
      row.figures.push_back(figure);
    }
    if (!lines) throw std::logic_error("a study's rows were cut");
  }
  return rows;
}

std::string described(const Task& task) {
  std::vector<std::string> measures;
  for (const Row& r : task.rows) measures.push_back(r.measure);
  return fmt::format("{}: {}", place_of(task.rows.front()), fmt::join(measures, ", "));
}

}  // namespace

RunReport run_study(const Study& study, const RunOptions& options, Results* results) {
  RunReport report;
  std::vector<Task> tasks;
  const std::vector<Task> all = tasks_of(study);
  for (size_t i = options.shard.number; i < all.size(); i += options.shard.of)
    tasks.push_back(all[i]);
  const auto count = [](const std::vector<Task>& of) {
    size_t rows = 0;
    for (const Task& task : of) rows += task.rows.size();
    return rows;
  };
  report.rows = count(tasks);
  tasks = missing(std::move(tasks), results->keys());
  const size_t to_do = count(tasks);
  report.there = report.rows - to_do;
  size_t ended = 0;

  const auto run = [&](DependsOn on, size_t jobs) {
    std::vector<const Task*> some;
    for (const Task& task : tasks) {
      if (task.on == on) some.push_back(&task);
    }
    const auto ends = [&](const Task& task) {
      ended += task.rows.size();
      if (options.progress) options.progress(ended, to_do);
    };
    const auto begins = [&](size_t i) {
      const auto& rows = some[i]->rows;
      const bool is_there = std::all_of(rows.begin(), rows.end(),
                                        [&](const Row& row) { return results->has(row.key); });
      if (is_there) ends(*some[i]);  // by another program, meanwhile
      return !is_there;
    };
    const auto work = [&](size_t i) {
      return text_of(measured(study, *some[i], options.made_by, options.say));
    };
    in_children(some.size(), jobs, begins, work, [&](size_t i, const Answer& answer) {
      const Task& task = *some[i];
      if (answer.failure.empty()) {
        report.added += results->add(rows_of(answer.text, task.rows));
      } else {
        report.failures.push_back({described(task), answer.failure});
      }
      ends(task);
    });
  };
  run(DependsOn::kTechnology, 1);
  run(DependsOn::kScene, options.jobs);
  run(DependsOn::kFrame, options.jobs);
  run(DependsOn::kMachine, 1);
  return report;
}

bool is_whole(const Study& study, const Results& results) {
  return missing(tasks_of(study), results.keys()).empty();
}

std::vector<Row> rows_of(const Study& study, const std::vector<Row>& rows) {
  std::map<std::string, const Row*> there;
  for (const Row& row : rows) there[row.key] = &row;
  std::vector<Row> own;
  for (const Task& task : tasks_of(study)) {
    for (const Row& row : task.rows) {
      const auto found = there.find(row.key);
      if (found == there.end()) continue;
      own.push_back(row);
      own.back().figures = found->second->figures;
      own.back().made_by = found->second->made_by;
    }
  }
  return own;
}

}  // namespace pineda::studies
