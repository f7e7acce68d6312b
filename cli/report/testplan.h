// The test plan: what is to be shown, and what shows it.
#pragma once

#include <string>
#include <vector>

namespace pineda::cli {

/// One of the plan, in OpenTitan's form.
struct Testpoint {
  std::string name;
  std::string desc;
  std::string stage;                  // V1, V2, V3
  std::vector<std::string> tests;     // names of ctest
  std::vector<std::string> coverage;  // points of the coverage table
};

/// The plan of the project: a file.
std::string default_testplan();

/// Reads a plan in Hjson that is JSON with comments.
///
/// Errors   UsageError: not of that form.
std::vector<Testpoint> read_testplan(const std::string& file);

}  // namespace pineda::cli
