#include "model/scene/hard/cases.h"

#include "model/scene/hard/draw.h"

namespace pineda::scene {

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> all = [] {
    std::vector<HardCase> cases;
    for (const auto& part : {hard::coverage_cases(), hard::limit_cases(), hard::value_cases(),
                             hard::perspective_cases(), hard::state_cases()}) {
      cases.insert(cases.end(), part.begin(), part.end());
    }
    return cases;
  }();
  return all;
}

const HardCase* find_hard_case(const std::string& name) {
  for (const HardCase& hard_case : hard_cases()) {
    if (name == hard_case.name) return &hard_case;
  }
  return nullptr;
}

}  // namespace pineda::scene
