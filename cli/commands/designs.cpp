// pineda designs: the design points and their parameters.
#include <memory>

#include "cli/output.h"
#include "model/spec/bounds.h"

namespace pineda::cli {
namespace {

Json design_json(const spec::Design& d) {
  const spec::Widths w = spec::widths(d);
  const spec::ErrorBounds bounds = spec::error_bounds(d);
  Json json{{"summary", d.summary},
            {"subpixel_bits", d.subpixel_bits},
            {"guard_bits", d.guard_bits},
            {"depth_test", d.depth_test},
            {"attributes", d.attributes},
            {"flat_attributes", d.flat_attributes},
            {"attribute_bits", d.attribute_bits},
            {"perspective", d.perspective},
            {"setup_style", spec::setup_style_name(d.setup_style)},
            {"setup_interval_cycles", w.setup_interval_cycles},
            {"setup_latency_cycles", w.setup_latency_cycles},
            {"tile_px", 1 << d.tile_log2},
            {"stamp_width_px", 1 << d.stamp_width_log2},
            {"stamp_height_px", 1 << d.stamp_height_log2},
            {"prim_fifo_depth", d.prim_fifo_depth},
            {"tile_fifo_depth", d.tile_fifo_depth},
            {"stamp_fifo_depth", d.stamp_fifo_depth},
            {"has_rtl", spec::no_rtl_reason(d).empty()}};
  // What a design does not have is not said.
  if (spec::has_reciprocal(d) || d.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    json["reciprocal_scheme"] = spec::reciprocal_scheme_name(d.reciprocal_scheme);
  }
  if (spec::has_reciprocal(d)) {
    json.update({{"reciprocal_lut_bits", d.reciprocal_lut_bits},
                 {"reciprocal_newton_steps", d.reciprocal_newton_steps},
                 {"reciprocal_bits", d.reciprocal_bits},
                 {"reciprocal_cycles", spec::reciprocal_cycles(d)},
                 {"gradient_fraction_bits", d.gradient_fraction_bits},
                 {"tile_fraction_bits", d.tile_fraction_bits}});
  }
  if (d.depth_test) {
    json.update({{"depth_bits", d.depth_bits},
                 {"depth_latency_cycles", d.depth_latency_cycles},
                 {"max_depth_latency_cycles", d.max_depth_latency_cycles},
                 {"inflight_stamps", w.inflight_stamps},
                 {"hierarchical_z", d.hierarchical_z},
                 {"depth_bound_ulp", bounds.depth_ulp}});
  }
  if (d.attributes > 0) json["color_bound_lsb"] = bounds.attribute_lsb;
  if (d.perspective) json["inverse_w_bits"] = d.inverse_w_bits;
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
