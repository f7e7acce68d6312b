// pineda scenes: what is built in.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/output.h"

namespace pineda::cli {
namespace {

uint64_t count_triangles(scene::TriangleSource* source) {
  spec::Triangle triangle;
  while (source->next(&triangle)) {
  }
  return source->counters().triangles;
}

int run(const Options& options) {
  const Output output(options);
  const spec::Contract contract = spec::contract(spec::kHighTile);
  Json json;
  for (const auto& built_in : scene::built_in_scenes()) {
    const scene::Scene scene = scene::open_scene(contract, built_in.name, {});
    const uint64_t triangles = count_triangles(scene.source.get());
    Json& entry = json["scenes"][built_in.name];
    entry = {{"summary", built_in.summary},
             {"width", scene.frame.width},
             {"height", scene.frame.height},
             {"triangles", triangles}};
    const auto size = fmt::format("{}x{}", scene.frame.width, scene.frame.height);
    output.line("{:<28}{:>8}{:>7} triangles  {}", built_in.name, size, grouped(triangles),
                built_in.summary);
    if (built_in.right_answer.empty()) continue;
    entry["right_answer"] = built_in.right_answer;
    output.line("    right: {}", built_in.right_answer);
  }
  output.json(json);
  return kHolds;
}

}  // namespace

void add_scenes(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<Options>();
  auto* command = program->add_subcommand("scenes", "The built-in scenes, hard cases among them");
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
