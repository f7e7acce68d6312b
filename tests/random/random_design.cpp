// random_design SEED FILE: writes one random design.
// random_design SEED SCENES FOLDER PINEDA: checks one on random scenes.
//
// Writes the design and the scenes to FOLDER/rSEED, runs `PINEDA check` on each, compares cycle
// model and RTL token by token, cycle by cycle, and prints a line. What holds is removed; what
// does not stays, with the commands that repeat it. Exit: 0 = it holds, 1 = it does not, 2 = usage.
#include <fmt/format.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <systemc>

#include "model/scene/writers.h"
#include "model/spec/design_file.h"
#include "tests/random/compare.h"

namespace pineda::test {
namespace {

struct Totals {
  uint64_t tokens = 0;
  uint64_t mismatches = 0;
  uint64_t beyond = 0;  // samples beyond a bound, too many or missing
  uint64_t cycles = 0;
  uint64_t cycles_off = 0;
  uint64_t counters = 0;
  uint64_t counters_off = 0;
  int failed = 0;  // scenes
};

struct Job {
  spec::Contract contract;
  std::string folder;
  std::string pineda;
};

void add(const nlohmann::json& json, Totals* totals) {
  for (const auto& [name, side] : json.at("sides").items()) {
    totals->tokens += side.at("compared").get<uint64_t>();
  }
  totals->mismatches += json.at("mismatches").get<uint64_t>();
  totals->beyond += json.at("beyond_bounds").get<uint64_t>() +
                    json.at("coverage").at("missing").get<uint64_t>() +
                    json.at("coverage").at("extra").get<uint64_t>();
  const auto model = json.at("cycles").at("model").get<int64_t>();
  const auto rtl = json.at("cycles").at("rtl").get<int64_t>();
  totals->cycles += static_cast<uint64_t>(rtl);
  totals->cycles_off += static_cast<uint64_t>(std::abs(model - rtl));
  totals->counters += json.at("counters_compared").get<uint64_t>();
  totals->counters_off += json.at("counters_differ").size();
}

/// Empty if `pineda check` holds and no cycle differs, else why not.
std::string check(const Job& job, const Trial& trial, Totals* totals) {
  const std::string out = job.folder + "/check.json";
  const std::string log = job.folder + "/check.log";
  std::filesystem::remove(out);
  const std::string command = fmt::format("'{}' check {} --design '{}/design.toml'", job.pineda,
                                          trial.arguments(), job.folder);
  const int status =
      std::system(fmt::format("{} --quiet --json '{}' > '{}' 2>&1", command, out, log).c_str());
  if (!std::filesystem::exists(out)) {
    std::string line;
    std::getline(std::ifstream(log), line);
    return fmt::format("{}\n    {}", command, line);
  }
  const uint64_t cycles_off = totals->cycles_off;
  add(nlohmann::json::parse(std::ifstream(out)), totals);
  if (WEXITSTATUS(status) == 0 && cycles_off == totals->cycles_off) return {};
  return command;
}

/// The same for the cycles of tokens.
std::string compare(const Job& job, const Trial& trial) {
  try {
    return model_against_rtl(job.contract, trial).difference();
  } catch (const std::exception& error) {
    return error.what();
  }
}

int run(uint64_t seed, int scenes, const std::string& folder, const std::string& pineda) {
  const spec::Design design = random_design(seed);
  const Job job{spec::contract(design), fmt::format("{}/r{}", folder, seed), pineda};
  scene::write_file(job.folder + "/design.toml", spec::design_toml(design));
  Totals totals;
  std::string failures;
  for (int i = 0; i < scenes; ++i) {
    const Trial trial = random_trial(design, seed * 1000 + static_cast<uint64_t>(i), job.folder);
    const std::string why = check(job, trial, &totals);
    const std::string difference = compare(job, trial);
    totals.failed += why.empty() && difference.empty() ? 0 : 1;
    if (!why.empty()) failures += fmt::format("  {}\n", why);
    if (!difference.empty()) failures += fmt::format("  {}: {}\n", trial.arguments(), difference);
  }
  std::cout << fmt::format(
                   "{} r{}: {} scenes, {} tokens, {} mismatches, {} beyond bounds, {} of {} cycles "
                   "off, {} of {} counters off: {}\n{}",
                   totals.failed == 0 ? "PASS" : "FAIL", seed, scenes, totals.tokens,
                   totals.mismatches, totals.beyond, totals.cycles_off, totals.cycles,
                   totals.counters_off, totals.counters, summary_of(design), failures)
            << std::flush;
  if (totals.failed == 0) std::filesystem::remove_all(job.folder);
  return totals.failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace pineda::test

// SystemC calls this from sc_elab_and_sim().
int sc_main(int argc, char** argv) {
  if (argc != 3 && argc != 5) {
    std::cerr << "usage: random_design SEED FILE, or random_design SEED SCENES FOLDER PINEDA\n";
    return 2;
  }
  const uint64_t seed = std::strtoull(argv[1], nullptr, 10);
  try {
    if (argc == 5) return pineda::test::run(seed, std::atoi(argv[2]), argv[3], argv[4]);
    const auto design = pineda::test::random_design(seed);
    pineda::scene::write_file(argv[2], pineda::spec::design_toml(design));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "random_design: " << error.what() << '\n';
    return 2;
  }
}

int main(int argc, char** argv) {
  // Its banner has no place between the lines of the designs.
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  return sc_core::sc_elab_and_sim(argc, argv);
}
