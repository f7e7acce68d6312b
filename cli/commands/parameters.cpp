// pineda study parameters: what each parameter of a design costs and buys on a scene.
#include "studies/numerics/parameters.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/output.h"

namespace pineda::cli {
namespace {

struct ParametersOptions : Options {
  std::vector<std::string> parameters;
};

std::string kilobits(int64_t bits) {
  return fmt::format("{:.1f}", 1e-3 * static_cast<double>(bits));
}

/// Measured and bound, if there is one; "-" where the design has no such value.
std::string error_text(bool has, double measured, double bound) {
  if (!has) return "-";
  return bound > 0 ? fmt::format("{:.4g} ({:.4g})", measured, bound)
                   : fmt::format("{:.4g}", measured);
}

void print_point(const Output& output, const studies::ParameterPoint& p) {
  const spec::Design& d = p.design;
  output.line("  {}{:<23}{:>8}{:>8}{:>8}{:>8}{:>8}{:>9}  {:<18}{:<18}{:>10}", p.is_base ? '*' : ' ',
              p.value, kilobits(p.cost.setup), kilobits(p.cost.reciprocal),
              kilobits(p.cost.interpolation), kilobits(p.cost.buffers), kilobits(p.cost.memory),
              kilobits(p.cost.total()),
              error_text(d.depth_test, p.judgement.max_depth_ulp, p.bounds.depth_ulp),
              error_text(spec::channels(d) > 0, p.judgement.max_color_lsb, p.bounds.attribute_lsb),
              grouped(static_cast<uint64_t>(p.cycles)));
}

Json point_json(const studies::ParameterPoint& p) {
  return {
      {"parameter", p.parameter},
      {"value", p.value},
      {"is_base", p.is_base},
      {"cost_bits",
       {{"setup", p.cost.setup},
        {"reciprocal", p.cost.reciprocal},
        {"interpolation", p.cost.interpolation},
        {"buffers", p.cost.buffers},
        {"memory", p.cost.memory},
        {"total", p.cost.total()}}},
      {"missing", p.judgement.missing},
      {"extra", p.judgement.extra},
      {"other_winner", p.judgement.other_winner},
      {"depth", {{"max_ulp", p.judgement.max_depth_ulp}, {"bound_ulp", p.bounds.depth_ulp}}},
      {"color", {{"max_lsb", p.judgement.max_color_lsb}, {"bound_lsb", p.bounds.attribute_lsb}}},
      {"cycles", p.cycles}};
}

int run(const ParametersOptions& options) {
  const spec::Contract base = contract_of(options);
  require_of(options, base.design, spec::no_cycles_reason);
  const Output output(options);
  Progress progress(options);
  const scene::Scene scene = open(options, base, true);
  studies::ParameterOptions study;
  study.base = base.design;
  study.parameters = options.parameters;
  study.progress = [&](const std::string& parameter, uint64_t triangles) {
    progress.update(parameter.c_str(), triangles);
  };
  std::vector<studies::ParameterPoint> points;
  try {
    points = studies::study_parameters(scene, study);
  } catch (const std::invalid_argument& unknown) {
    std::string known;
    for (const auto& p : studies::parameter_points(base.design, scene.frame)) {
      if (known.find(p.parameter) == std::string::npos) {
        known += (known.empty() ? "" : ", ") + p.parameter;
      }
    }
    throw UsageError(
        fmt::format("--parameter: expected one of {}, got '{}'", known, unknown.what()));
  }
  progress.clear();
  print_notes(output, scene);

  output.line("{}: {}x{}, base {} (*); cost in kbit, errors measured (bound)", scene.name,
              scene.frame.width, scene.frame.height, base.design.name);
  output.line("{:<26}{:>8}{:>8}{:>8}{:>8}{:>8}{:>9}  {:<18}{:<18}{:>10}", "", "setup", "recip.",
              "interp.", "buffers", "memory", "total", "depth ulp", "colour LSB", "cycles");
  Json json = header_json(scene, base);
  json["points"] = Json::array();
  bool holds = true;
  std::string parameter;
  for (const auto& p : points) {
    if (p.parameter != parameter) output.line("{}", parameter = p.parameter);
    print_point(output, p);
    json["points"].push_back(point_json(p));
    holds &= p.judgement.missing + p.judgement.extra == 0;
  }
  output.line("Colours are compared with interpolated, perspective-correct ones, flat ones too.");
  output.line("{}", holds ? "It holds: every point covers exactly what it should."
                          : "IT DOES NOT HOLD: a point's coverage is wrong.");
  json["holds"] = holds;
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace

void add_parameters_study(CLI::App* study, int* exit_code) {
  auto options = std::make_shared<ParametersOptions>();
  auto* command = study->add_subcommand(
      "parameters", "What each parameter costs and buys: one at a time, on a scene");
  add_scene_options(command, options.get());
  command->get_option("--design")->description("Base that all other parameters are taken from");
  command->add_option("--parameter", options->parameters, "Only these, NAME,NAME..")
      ->delimiter(',')
      ->type_name("NAME");
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
