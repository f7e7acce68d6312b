// The committed vectors, and files that are named, on the model: prints the first case that differs and exits with
// 1. scripts/core-mutants links it with mutants of core.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "vectors/grammar/file.h"

namespace pineda::vectors {
namespace {

template <class Case>
bool holds(const std::string& file) {
  Reader<Case> reader(file);
  const spec::Contract& contract = reader.header().contract;
  for (Case c; reader.next(&c);) {
    const auto text = difference(contract, c, run_model(contract, c));
    if (!text) continue;
    std::printf("%s: %s\n", contract.design.name, text->c_str());
    return false;
  }
  return true;
}

bool holds_as_its_unit(const std::string& file) {
  switch (read_header(file).unit) {
    case Unit::kSetup:
      return holds<SetupCase>(file);
    case Unit::kTraversal:
      return holds<TraversalCase>(file);
    case Unit::kInterpZtest:
      return holds<InterpZtestCase>(file);
    case Unit::kFrame:
      break;
  }
  return holds<FrameCase>(file);
}

}  // namespace
}  // namespace pineda::vectors

int main(int count, char** arguments) {
  std::vector<std::string> files;
  for (const char* unit : {"setup", "traversal", "interp_ztest", "frame"}) {
    const auto folder = std::filesystem::path(PINEDA_VECTORS) / unit;
    std::set<std::string> committed;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      committed.insert(entry.path().string());
    }
    files.insert(files.end(), committed.begin(), committed.end());
  }
  files.insert(files.end(), arguments + 1, arguments + count);
  return std::all_of(files.begin(), files.end(), pineda::vectors::holds_as_its_unit) ? 0 : 1;
}
