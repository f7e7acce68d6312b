// Mesa's llvmpipe and the quick model side by side, in one run: which draws the same frame sooner.
//
// Errors   exit 1 where the sides' counts of samples differ, 2 for bad usage or bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/rounds.h"
#include "cli/reserved_file.h"
#include "cli/simd_option.h"
#include "model/fast/level.h"
#include "model/scene/error.h"

namespace pineda::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kHolds = 0, kMismatch = 1, kBadInput = 2;
constexpr const char* kDesign = "high_tile";

struct Options {
  int rounds = 7;
  std::vector<std::string> scenes;
  std::vector<std::string> meshes;
  std::string json;
  std::string simd = fast::level_name(fast::levels().back());
};

// The scenes asked for; one whose file is not here is left out, with a line that says so.
std::vector<std::string> chosen_scenes(const Options& options) {
  const bool all = options.scenes.empty();
  std::vector<std::string> chosen;
  for (const std::string& name : all ? scene_names() : options.scenes) {
    const std::string file = file_of(name);
    if (file.empty() || std::filesystem::exists(file)) {
      chosen.push_back(name);
    } else {
      fmt::print("{} is left out: there is no {}\n", name, file);
    }
  }
  for (const std::string& file : options.meshes) {
    if (!std::ifstream(file)) throw scene::InputError(file, "expected a file to read");
  }
  chosen.insert(chosen.end(), options.meshes.begin(), options.meshes.end());
  return chosen;
}

std::string title_of(const std::string& scene) {
  return std::filesystem::path(scene).stem().string();
}

int64_t signed_difference(uint64_t theirs, uint64_t ours) {
  return static_cast<int64_t>(ours) - static_cast<int64_t>(theirs);
}

void print_head() {
  fmt::print("{:10}{:>10}{:>12}{:>6}{:>11}{:>6}{:>13}{:>11}{:>8}{:>14}\n", "scene", "triangles",
             "covered", "+-", "passed", "+-", "llvmpipe ms", "pineda ms", "ratio", "its rounds");
}

void print_row(const Row& row) {
  fmt::print(
      "{:10}{:>10}{:>12}{:>+6}{:>11}{:>+6}", row.scene, row.triangles, row.of_llvmpipe.covered,
      signed_difference(row.of_llvmpipe.covered, row.of_pineda.covered), row.of_llvmpipe.passed,
      signed_difference(row.of_llvmpipe.passed, row.of_pineda.passed));
  if (row.agrees()) {
    const std::vector<double> ratios = row.ratios();
    const auto [least, greatest] = std::minmax_element(ratios.begin(), ratios.end());
    fmt::print("{:>13.2f}{:>11.2f}{:>8.2f}{:>14}\n", median(row.llvmpipe.cpu_ms),
               median(row.pineda.cpu_ms), row.ratio(),
               fmt::format("{:.2f} - {:.2f}", *least, *greatest));
  } else {
    fmt::print("  not timed: they differ by more than {:g} of the samples\n", kToleratedShare);
  }
  std::fflush(stdout);
}

/// Of the ratios of all scenes.
struct Summary {
  double geometric_mean = 0;
  double least = 0;
};

Summary summary_of(const std::vector<Row>& rows) {
  Summary summary{0, rows.front().ratio()};
  for (const Row& row : rows) {
    summary.geometric_mean += std::log(row.ratio()) / static_cast<double>(rows.size());
    summary.least = std::min(summary.least, row.ratio());
  }
  summary.geometric_mean = std::exp(summary.geometric_mean);
  return summary;
}

Json samples_json(const Samples& samples) {
  return {{"covered", samples.covered}, {"passed", samples.passed}};
}

Json side_json(const Samples& samples, const Times& times) {
  Json json{{"samples", samples_json(samples)}};
  if (!times.cpu_ms.empty()) json["median_cpu_ms"] = median(times.cpu_ms);
  json["cpu_ms"] = times.cpu_ms;
  json["wall_ms"] = times.wall_ms;
  return json;
}

Json row_json(const Row& row) {
  Json json{{"scene", row.scene},
            {"triangles", row.triangles},
            {"agrees", row.agrees()},
            {"llvmpipe", side_json(row.of_llvmpipe, row.llvmpipe)},
            {"pineda", side_json(row.of_pineda, row.pineda)}};
  if (row.agrees()) json["ratio"] = row.ratio();
  return json;
}

int run(const Options& options) {
  const spec::Contract contract = spec::contract(*spec::find_design(kDesign));
  const std::vector<std::string> scenes = chosen_scenes(options);
  if (scenes.empty()) return kHolds;
  std::optional<cli::ReservedFile> file;
  if (!options.json.empty()) file.emplace(options.json);
  Llvmpipe llvmpipe;
  Pineda pineda(contract);
  fmt::print("{}\npineda {}, {}\n{}x{}, one thread each, medians of CPU time, rounds: {}\n\n",
             llvmpipe.name(), kDesign, options.simd, kWidth, kHeight, options.rounds);
  print_head();

  std::vector<Row> rows;
  bool agree = true;
  Json json{{"llvmpipe", llvmpipe.name()}, {"design", kDesign}, {"simd", options.simd},
            {"rounds", options.rounds},    {"width", kWidth},   {"height", kHeight},
            {"scenes", Json::array()}};
  for (const std::string& scene : scenes) {
    rows.push_back(compare(title_of(scene), triangles_of(contract, scene), options.rounds,
                           &llvmpipe, &pineda));
    print_row(rows.back());
    json["scenes"].push_back(row_json(rows.back()));
    agree = agree && rows.back().agrees();
  }
  if (agree) {
    const Summary summary = summary_of(rows);
    json["geometric_mean"] = summary.geometric_mean;
    json["least_ratio"] = summary.least;
    fmt::print("\ngeometric mean {:.2f}, least {:.2f}\n", summary.geometric_mean, summary.least);
  }
  if (file) file->keep(std::fputs((json.dump(2) + "\n").c_str(), file->file()) >= 0);
  return agree ? kHolds : kMismatch;
}

void add_options(CLI::App* program, Options* options) {
  program->add_option("--rounds", options->rounds, "Frames of each side, in turns")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  program->add_option("--scene", options->scenes, "One of the scenes; all unless given")
      ->check(CLI::IsMember(scene_names()))
      ->type_name("NAME");
  program->add_option("--mesh", options->meshes, "A mesh beside them")->type_name("FILE");
  program->add_option("--json", options->json, "Write the figures as JSON to a file")
      ->type_name("FILE");
  cli::add_simd_option(program);
}

int run(int argc, char** argv) {
  CLI::App program{
      "Draws the same triangles with Mesa's llvmpipe and with the quick model, in turns.\n"
      "Exit: 0 = both draw the same samples, 1 = they do not, 2 = bad usage or bad input.",
      "versus_llvmpipe"};
  Options options;
  add_options(&program, &options);
  try {
    program.parse(argc, argv);
    if (const auto* simd = program.get_option("--simd"); simd->count() > 0) {
      options.simd = simd->results().front();
    }
    return run(options);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "versus_llvmpipe: {} (see versus_llvmpipe --help)\n", error.what());
  }
  return kBadInput;
}

}  // namespace
}  // namespace pineda::bench

int main(int argc, char** argv) {
  try {
    return pineda::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "versus_llvmpipe: %s\n", error.what());
  }
  return 2;
}
