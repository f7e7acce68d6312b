// pineda walk: one triangle through every stage, with its bits.
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "cli/output.h"
#include "model/core/frame.h"
#include "model/spec/difference.h"

namespace pineda::cli {
namespace {

struct WalkOptions : Options {
  uint64_t triangle = 0;
  int stamp = 0;
};

/// Prints each field of a struct: name, format, bits and the real number they stand for; *json gets
/// them under the struct's name.
template <class T>
void show(const Output& output, const spec::Contract& c, const char* title, const T& value,
          Json* json) {
  output.line("\n{}", title);
  Json& fields = (*json)[spec::struct_name<T>()];
  for (const auto& f : spec::fields<T>(c)) {
    const std::string format = spec::format_name(f.is_signed, f.bits, f.fraction_bits, "");
    for (int i = 0; i < f.count; ++i) {
      const std::string name = f.count == 1 ? f.name : fmt::format("{}[{}]", f.name, i);
      const int64_t code = f.get(c, value, i);
      output.line("  {:<12}{:<10}{}", name, format,
                  spec::value_text(f.bits, f.fraction_bits, f.unit, code));
      fields[name] = {{"format", format},
                      {"code", code},
                      {"value", std::ldexp(static_cast<double>(code), -f.fraction_bits)},
                      {"unit", f.unit}};
    }
  }
}

/// Follows one stamp of the triangle to its writes.
struct WalkSink {
  const Output& output;
  const spec::Contract& contract;
  int wanted;
  Json* json;
  int seen = 0;
  bool found = false;

  void prim(const spec::SetupPrim& prim) {
    show(output, contract, "SetupPrim: edges and planes at the first sample of its first tile",
         prim, json);
  }
  void stamp(const spec::Stamp& stamp) {
    found = seen++ == wanted;
    if (!found) return;
    show(output, contract, "Stamp: coverage, and planes at its tile's first sample", stamp, json);
  }
  void fragment(const spec::Stamp&, const spec::Fragment&) {}
  void depth(const spec::DepthWrite& write) {
    if (found) show(output, contract, "DepthWrite: the samples that pass", write, json);
  }
  void color(const spec::ColorWrite& write) {
    if (found) show(output, contract, "ColorWrite", write, json);
  }
};

int run(const WalkOptions& options) {
  const spec::Contract contract = contract_of(options);
  const Output output(options);
  const scene::Scene scene = open(options, contract, false);
  spec::Triangle triangle;
  bool more = scene.source->next(&triangle);
  while (more && triangle.id < options.triangle) more = scene.source->next(&triangle);
  if (!more || triangle.id != options.triangle) {
    throw UsageError(
        fmt::format("--triangle: {} has no triangle {} to draw", scene.name, options.triangle));
  }
  Json json = header_json(scene, contract);
  show(output, contract, "Triangle: snapped vertices", triangle, &json);
  core::Renderer renderer(contract, scene.frame);
  WalkSink sink{output, contract, options.stamp, &json};
  const core::Drop drop = renderer.draw(triangle, sink);
  if (drop != core::Drop::kNone) {
    output.line("\nDropped by setup: {}.", core::drop_name(drop));
    json["dropped"] = core::drop_name(drop);
    output.json(json);
    return kHolds;
  }
  const auto& c = renderer.counters();
  output.line("\nOf {} tiles {} are rejected and {} accepted whole; {} stamps cover {} samples.",
              c.tiles_tested, c.tiles_rejected, c.tiles_accepted, c.stamps, c.fragments);
  if (options.stamp >= sink.seen) {
    throw UsageError(fmt::format("--stamp: the triangle has stamps 0 to {}", sink.seen - 1));
  }
  json["counters"] = counters_json(c);
  output.json(json);
  return kHolds;
}

}  // namespace

void add_walk(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<WalkOptions>();
  auto* command =
      program->add_subcommand("walk", "One triangle through every stage, with its actual bits");
  add_scene_options(command, options.get());
  command->add_option("--triangle", options->triangle, "Number of the triangle in the scene")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--stamp", options->stamp, "Which of its stamps to follow")
      ->check(CLI::Range(0, 1 << 28))
      ->type_name("N")
      ->capture_default_str();
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
