// The test plan names what exists, and leaves no point of the coverage table out.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "studies/vectors/timed_coverage.h"

namespace pineda::vectors {
namespace {

using Json = nlohmann::json;
using Names = std::set<std::string>;

Json plan() {
  std::ifstream file(PINEDA_VECTORS "/testplan.hjson");
  return Json::parse(file, nullptr, true, true);
}

/// The lines that a shell's command writes.
std::vector<std::string> lines_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::vector<std::string> lines(1);
  for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe.get())) != EOF;) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += static_cast<char>(c);
    }
  }
  return lines;
}

/// "Suite/Case.Name/Parameter" and "Case.Name<Type" are instances of "Case.Name".
std::string without_parameters(const std::string& name) {
  const size_t dot = name.find('.');
  if (dot == std::string::npos) return name;
  const size_t slash = name.rfind('/', dot);
  const size_t end = name.find_first_of("/<", dot);
  const size_t begin = slash == std::string::npos ? 0 : slash + 1;
  return name.substr(begin, end == std::string::npos ? end : end - begin);
}

/// What ctest knows, as `ctest -N` lists it: "  Test #12: NAME". A program that is not built has one,
/// PROGRAM_NOT_BUILT.
struct Ctest {
  Names names, not_built;
  bool has(const std::string& name) const { return names.count(name) > 0; }
};

Ctest ctest() {
  Ctest all;
  for (const std::string& line : lines_of("ctest --test-dir '" PINEDA_BUILD "' -N 2>&1")) {
    const size_t at = line.find(": ");
    if (line.rfind("  Test ", 0) != 0 || at == std::string::npos) continue;
    const std::string name = line.substr(at + 2);
    all.names.insert(name);
    all.names.insert(without_parameters(name));
    // A typed test: "Suite/Type.Name".
    const size_t slash = name.find('/'), dot = name.find('.');
    if (slash != std::string::npos && dot != std::string::npos && slash < dot) {
      all.names.insert(name.substr(0, slash) + name.substr(dot));
    }
    if (name.find("_NOT_BUILT") != std::string::npos) all.not_built.insert(name);
  }
  return all;
}

Names points_of_every_design() {
  Names names;
  std::vector<spec::Design> designs = spec::designs();
  designs.push_back(spec::kHighTile);  // no named one has it
  designs.back().hierarchical_z = true;
  for (const auto& point : points<SeenTimedFrame>()) names.insert(point.name);
  for (const spec::Design& design : designs) {
    const auto contract = spec::contract(design);
    for (const auto& row : kUnitNames) {
      for (const PointHits& point : Coverage(row.value, contract).points())
        names.insert(point.name);
    }
  }
  return names;
}

TEST(Testplan, HasTheFormOfATestplan) {
  const Json json = plan();
  EXPECT_TRUE(json.at("name").is_string());
  Names names;
  for (const Json& point : json.at("testpoints")) {
    const std::string name = point.at("name");
    EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    EXPECT_GT(point.at("desc").get<std::string>().size(), 20u) << name;
    EXPECT_EQ(Names({"V1", "V2", "V3"}).count(point.at("stage").get<std::string>()), 1u) << name;
    EXPECT_FALSE(point.at("tests").empty()) << name;
  }
  EXPECT_GT(names.size(), 20u);
}

TEST(Testplan, NamesPointsThatExistAndEachOne) {
  const Names exist = points_of_every_design();
  EXPECT_GT(exist.size(), 50u);
  Names named;
  const Json testplan = plan();
  for (const Json& point : testplan.at("testpoints")) {
    for (const std::string name : point.at("coverage")) {
      named.insert(name);
      EXPECT_EQ(exist.count(name), 1u)
          << point.at("name") << ": " << name << " is no point of the coverage table";
    }
  }
  for (const std::string& name : exist) {
    EXPECT_EQ(named.count(name), 1u) << name << " belongs to no testpoint";
  }
}

TEST(Testplan, NamesTestsThatExist) {
  const Ctest known = ctest();
  ASSERT_GT(known.names.size(), 20u) << "ctest lists nothing";
  if (!known.not_built.empty()) {
    GTEST_SKIP() << known.not_built.size() << " test programs are not built, "
                 << *known.not_built.begin() << " the first";
  }
  EXPECT_FALSE(known.has("Testplan.NamesNothing"));
  const Json testplan = plan();
  for (const Json& point : testplan.at("testpoints")) {
    for (const std::string name : point.at("tests")) {
      EXPECT_TRUE(known.has(name)) << point.at("name") << ": " << name << " is no test";
    }
  }
}

TEST(Testplan, InstancesAreThoseOfTheirTest) {
  EXPECT_EQ(without_parameters("Cli/Seeing.Draws/3"), "Seeing.Draws");
  EXPECT_EQ(without_parameters("LevelOne.HitsEveryReachableBin/tiny"),
            "LevelOne.HitsEveryReachableBin");
  EXPECT_EQ(without_parameters("ReciprocalRtl.Corners<ReciprocalRtl/rom."),
            "ReciprocalRtl.Corners");
  EXPECT_EQ(without_parameters("core_mutants_die"), "core_mutants_die");
}

}  // namespace
}  // namespace pineda::vectors
