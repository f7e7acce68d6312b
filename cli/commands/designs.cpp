// pineda designs: the design points and their parameters.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/output.h"
#include "model/spec/bounds.h"

namespace pineda::cli {
namespace {

/// The design's parameters, then what follows from them. Parts that it lacks are left out.
Json design_json(const spec::Design& d) {
  Json json{{"summary", d.summary}};
  for (const spec::Parameter& p : spec::kParameters) {
    if (!spec::is_listed(p, d)) continue;
    std::visit([&](const auto& value) { json[p.key] = value; }, spec::value_of(p, d));
  }
  const spec::Widths w = spec::widths(d);
  const spec::ErrorBounds bounds = spec::error_bounds(d);
  json["setup_interval_cycles"] = w.setup_interval_cycles;
  json["setup_latency_cycles"] = w.setup_latency_cycles;
  if (spec::has_reciprocal(d)) json["reciprocal_cycles"] = spec::reciprocal_cycles(d);
  if (d.depth_test) {
    json["inflight_stamps"] = w.inflight_stamps;
    json["depth_bound_ulp"] = bounds.depth_ulp;
  }
  if (d.attributes > 0) json["color_bound_lsb"] = bounds.attribute_lsb;
  json["has_rtl"] = spec::no_rtl_reason(d).empty();
  return json;
}

int run(const Options& options) {
  const Output output(options);
  Json json;
  for (const auto& design : spec::designs()) {
    const Json parameters = design_json(design);
    json["designs"][design.name] = parameters;
    output.line("{}: {}", design.name, design.summary);
    const std::string no_rtl = spec::no_rtl_reason(design);
    if (!no_rtl.empty()) output.line("  {:<26}{}", "no RTL", no_rtl);
    for (const auto& [key, value] : parameters.items()) {
      if (key == "summary") continue;
      output.line("  {:<26}{}", key,
                  value.is_number_float() ? fmt::format("{:.4f}", value.get<double>())
                  : value.is_string()     ? value.get<std::string>()
                                          : value.dump());
    }
  }
  output.json(json);
  return kHolds;
}

}  // namespace

void add_designs(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<Options>();
  auto* command = program->add_subcommand("designs", "The design points and their parameters");
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
