#include "studies/run/tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "studies/area/synthesis.h"
#include "studies/run/memory_parameters.h"

namespace pineda::studies {
namespace {

// The parameters alone: a design's name and summary say nothing of what it does.
std::string parameters_of(spec::Design design) {
  design.name = design.summary = "";
  return spec::design_toml(design);
}

std::string hardware_of(const spec::Design& design) {
  std::string text = parameters_of(design);
  if (spec::no_rtl_reason(design).empty()) {
    text += fmt::format("{:016x}", spec::text_hash(code_of(sources_of(spec::contract(design)))));
  }
  return text;
}

std::string technology_name(const Study& study, const StudyTechnology& technology) {
  return study.clock_ps == 0 ? technology.name
                             : fmt::format("{}, {} ps", technology.name, study.clock_ps);
}

/// Makes the tasks of one study.
class Tasks {
 public:
  explicit Tasks(const Study& study) : study_(study) {
    for (const spec::Design& design : study.designs) hardware_.push_back(hardware_of(design));
  }

  std::vector<Task> all() {
    for (size_t d = 0; d < study_.designs.size(); ++d) {
      for (size_t t = 0; t < study_.technologies.size(); ++t) {
        const StudyTechnology& technology = study_.technologies[t];
        Task task{DependsOn::kTechnology, 0, d, 0, t, {}};
        add(std::move(task), "", technology_name(study_, technology),
            fmt::format("{} {}", technology.content, study_.clock_ps));
      }
    }
    for (size_t s = 0; s < study_.scenes.size(); ++s) {
      const StudyScene& scene = study_.scenes[s];
      for (size_t d = 0; d < study_.designs.size(); ++d) {
        add({DependsOn::kScene, s, d, 0, 0, {}}, scene.name, "", scene.content);
        for (size_t m = 0; m < study_.memories.size(); ++m) {
          const StudyMemory& memory = study_.memories[m];
          for (const DependsOn on : {DependsOn::kFrame, DependsOn::kMachine}) {
            add({on, s, d, m, 0, {}}, scene.name, memory.name,
                scene.content + "\n" + parameters_of(memory));
          }
        }
      }
    }
    return std::move(tasks_);
  }

 private:
  void add(Task task, const std::string& scene, const std::string& memory, const std::string& on) {
    const spec::Design& design = study_.designs[task.design];
    for (const Measure measure : study_.measures) {
      const MeasureName& name = spec::row_of(measure);
      if (name.on != task.on) continue;
      const std::string key =
          fmt::format("{} {}\n{}\n{}", name.word, name.revision, hardware_[task.design], on);
      task.rows.push_back({fmt::format("{:016x}", spec::text_hash(key)),
                           scene,
                           design.name,
                           memory,
                           name.word,
                           "",
                           {}});
    }
    if (!task.rows.empty()) tasks_.push_back(std::move(task));
  }

  const Study& study_;
  std::vector<std::string> hardware_;  // by design
  std::vector<Task> tasks_;
};

}  // namespace

bool Task::measures(Measure measure) const {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const Row& row) { return row.measure == spec::name_of(measure); });
}

std::string code_of(const std::string& verilog) {
  std::string code;
  bool is_space = false, is_text = false;
  for (size_t i = 0; i < verilog.size(); ++i) {
    if (!is_text && verilog.compare(i, 2, "//") == 0) {
      i = std::min(verilog.find('\n', i), verilog.size());
      is_space = true;
      continue;
    }
    if (!is_text && verilog.compare(i, 2, "/*") == 0) {
      i = std::min(verilog.find("*/", i + 2), verilog.size() - 1) + 1;
      is_space = true;
      continue;
    }
    const char c = verilog[i];
    if (!is_text && (c == ' ' || c == '\n' || c == '\t' || c == '\r')) {
      is_space = true;
      continue;
    }
    if (c == '"' && (i == 0 || verilog[i - 1] != '\\')) is_text = !is_text;
    if (is_space && !code.empty()) code += ' ';
    is_space = false;
    code += c;
  }
  return code;
}

std::vector<Task> tasks_of(const Study& study) { return Tasks(study).all(); }

std::vector<Task> missing(std::vector<Task> tasks, const std::set<std::string>& keys) {
  for (Task& task : tasks) {
    auto& rows = task.rows;
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [&](const Row& row) { return keys.count(row.key) != 0; }),
               rows.end());
  }
  tasks.erase(std::remove_if(tasks.begin(), tasks.end(),
                             [](const Task& task) { return task.rows.empty(); }),
              tasks.end());
  return tasks;
}

}  // namespace pineda::studies
