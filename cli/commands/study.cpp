// pineda study: sweeps that need no scene.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/output.h"
#include "studies/numerics/bound_search.h"
#include "studies/numerics/design_points.h"
#include "studies/numerics/reciprocals.h"

namespace pineda::cli {
namespace {

struct StudyOptions : Options {
  int triangles = 2000;
  bool exhaustive = false;
  int steps = 6000;
};

/// Ours beside the prototype's.
std::string pair(const std::string& ours, const std::string& prototype) {
  return fmt::format("{:>8} {:<8}", ours, "(" + prototype + ")");
}
std::string pair(double ours, double prototype) {
  return pair(fmt::format("{:.3g}", ours), fmt::format("{:.3g}", prototype));
}
std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

void print_point(const Output& output, const studies::DesignPoint& p,
                 const studies::PrototypePoint& was) {
  const spec::Design& d = p.design;
  const bool none = d.reciprocal_scheme == spec::ReciprocalScheme::kNone;
  const auto bounds = spec::error_bounds(d);
  const std::string products =
      none
          ? pair("-", "-")
          : pair(fmt::format("{:.1f}k", 1e-3 * static_cast<double>(studies::setup_product_bits(d))),
                 fmt::format("{:.1f}k", 1e-3 * was.products));
  const std::string adder = none ? pair("-", "82")
                                 : pair(fmt::format("{}", spec::widths(d).depth_tile_plane),
                                        fmt::format("{}", was.z_adder_bits));
  output.line("{:<10}{:>6}  {} {} {} {} {}  {:>7.4g} {:>7.4g}", d.name,
              none ? "-" : fmt::format("{}", spec::reciprocal_cycles(d)), products, adder,
              pair(p.max_depth_ulp, was.max_depth_ulp), pair(p.max_color_lsb, was.max_color_lsb),
              pair(percent(p.coplanar), percent(was.coplanar)), bounds.depth_ulp,
              bounds.attribute_lsb);
}

/// Why the two columns differ.
constexpr const char* kDifferences[] = {
    "In brackets: a prototype in software that the points were chosen by, on other random "
    "triangles.",
    "  recip.       cycles of the reciprocal; ours takes one more to align the area",
    "  products     ours counts eight products for area and edges and moves the reference by whole",
    "               coordinates; the prototype's figures are those of three products, of S "
    "fraction",
    "               bits for the reference, and of Newton steps in k bits in place of k+2",
    "  depth, u8    the largest of what was drawn: they grow with --triangles towards the bounds,",
    "               which a directed search comes near (docs/accuracy.md)",
    "  coplanar     planes of whole codes a px at any height of 2^-8 code: high_tile rounds to "
    "2^-8",
    "               in each tile and so meets them; others miss where the height is near a half",
};

Json point_json(const studies::DesignPoint& p, const studies::PrototypePoint& was) {
  const auto bounds = spec::error_bounds(p.design);
  return {{"samples", p.samples},
          {"wrong_samples", p.wrong_samples},
          {"reciprocal_cycles", spec::reciprocal_cycles(p.design)},
          {"product_bits", studies::setup_product_bits(p.design)},
          {"z_adder_bits", spec::widths(p.design).depth_tile_plane},
          {"depth", {{"max_ulp", p.max_depth_ulp}, {"bound_ulp", bounds.depth_ulp}}},
          {"color", {{"max_lsb", p.max_color_lsb}, {"bound_lsb", bounds.attribute_lsb}}},
          {"coplanar", p.coplanar},
          {"broken", p.broken},
          {"prototype",
           {{"product_bits", was.products},
            {"z_adder_bits", was.z_adder_bits},
            {"max_ulp", was.max_depth_ulp},
            {"max_lsb", was.max_color_lsb},
            {"coplanar", was.coplanar}}}};
}

int design_points(const StudyOptions& options) {
  const Output output(options);
  Progress progress(options);
  studies::DesignPointOptions study;
  for (const auto& was : studies::prototype_points()) {
    study.designs.push_back(*spec::find_design(was.name));
  }
  study.triangles = options.triangles;
  study.seed = options.seed;
  study.progress = [&](const char* what, uint64_t done) { progress.update(what, done); };
  std::vector<studies::DesignPoint> points;
  const double seconds = seconds_of([&] { points = studies::study_design_points(study); });
  progress.clear();

  Json json{{"triangles_per_class", options.triangles}, {"seconds", seconds}};
  bool holds = true;
  output.line("{} random triangles of each of six classes, {} covered samples a design\n",
              grouped(static_cast<uint64_t>(options.triangles)), grouped(points.front().samples));
  output.line("{:<10}{:>6}  {:^17} {:^17} {:^17} {:^17} {:^17}  {:>7} {:>7}", "design", "recip.",
              "products, bits", "z adder, bits", "depth max, ulp", "u8 max, LSB", "coplanar differ",
              "bound z", "u8");
  for (const auto& point : points) {
    for (const auto& was : studies::prototype_points()) {
      if (std::string(was.name) != point.design.name) continue;
      print_point(output, point, was);
      json["designs"][was.name] = point_json(point, was);
    }
    holds = holds && point.broken.empty();
    for (const auto& line : point.broken) output.line("  {}: {}", point.design.name, line);
  }
  output.line("");
  for (const char* line : kDifferences) output.line("{}", line);
  output.line("\n{}", holds ? "It holds: 0 samples missing or too many, errors within the bounds."
                            : "IT DOES NOT HOLD.");
  json["holds"] = holds;
  output.json(json);
  return holds ? kHolds : kMismatch;
}

/// What a search finds, as a share of its bound.
std::string share(double found, double bound) {
  return fmt::format("{:>9.4g} {:>9.4g} {:>5.0f} %", found, bound, 100 * found / bound);
}

int bounds(const StudyOptions& options) {
  constexpr int kStarts = 24;
  const Output output(options);
  Progress progress(options);
  Json json{{"starts", kStarts}, {"steps", options.steps}};
  bool holds = true;
  output.line("Largest error before the final rounding, and what is proven of it\n");
  output.line("{:<12}{:^28}{:^28}", "", "depth, ulp", "u8 colour, LSB");
  output.line("{:<12}{:>9} {:>9}{:>8}  {:>9} {:>9}{:>8}", "design", "found", "bound", "", "found",
              "bound", "");
  for (const spec::Design& d : spec::designs()) {
    if (d.reciprocal_scheme == spec::ReciprocalScheme::kNone) continue;
    progress.update(d.name, 0);
    const auto bound = spec::error_bounds_before_rounding(d);
    const auto search = [&](studies::Value value) {
      return studies::search_worst(spec::contract(d), value, kStarts, options.steps, options.seed)
          .error;
    };
    const double depth = search(studies::Value::kDepth);
    const double color = search(studies::Value::kColor);
    holds = holds && depth <= bound.depth_ulp && color <= bound.attribute_lsb;
    progress.clear();
    output.line("{:<12}{}  {}", d.name, share(depth, bound.depth_ulp),
                share(color, bound.attribute_lsb));
    json["designs"][d.name] = {
        {"depth", {{"found_ulp", depth}, {"bound_ulp", bound.depth_ulp}}},
        {"color", {{"found_lsb", color}, {"bound_lsb", bound.attribute_lsb}}}};
  }
  output.line("\n{}", holds ? "It holds: no bound is exceeded." : "IT DOES NOT HOLD.");
  json["holds"] = holds;
  output.json(json);
  return holds ? kHolds : kMismatch;
}

int reciprocals(const StudyOptions& options) {
  const Output output(options);
  const int64_t most = int64_t{1} << (options.exhaustive ? 40 : 24);
  Json json;
  bool holds = true;
  output.line("{:<20}{:>4}{:>10}{:>8}{:>11}{:>12}{:>9}   {}", "scheme", "k", "ROM bits", "cycles",
              "good bits", "prototype", "bound", "searched");
  for (const auto& row : studies::reciprocal_rows()) {
    const spec::Design& d = row.design;
    const auto worst = studies::reciprocal_error(d, most);
    const double bound = spec::reciprocal_error_bound(d);
    holds = holds && worst.error <= bound;
    output.line("{:<20}{:>4}{:>10}{:>8}{:>11.2f}{:>12.1f}{:>9.2f}   {}", row.name,
                d.reciprocal_bits,
                grouped(static_cast<uint64_t>(spec::reciprocal_rom_size_bits(d))),
                spec::reciprocal_cycles(d), worst.good_bits(), row.prototype_good_bits,
                -std::log2(bound), worst.exhaustive ? "every mantissa" : "cells' ends and a grid");
    json["schemes"][row.name] = {{"k", d.reciprocal_bits},
                                 {"rom_bits", spec::reciprocal_rom_size_bits(d)},
                                 {"cycles", spec::reciprocal_cycles(d)},
                                 {"good_bits", worst.good_bits()},
                                 {"worst_area2", worst.area2},
                                 {"bound_bits", -std::log2(bound)},
                                 {"exhaustive", worst.exhaustive}};
  }
  output.line("{}",
              holds ? "It holds: no reciprocal is worse than its bound." : "IT DOES NOT HOLD.");
  json["holds"] = holds;
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace

void add_study(CLI::App* program, int* exit_code) {
  auto* study = program->add_subcommand("study", "Sweeps over designs");
  study->allow_extras();
  // Runs before any study: refuses extra arguments, and says what was expected.
  study->parse_complete_callback([study] {
    const auto rest = study->remaining(true);
    const bool chosen = !study->get_subcommands().empty();
    if (chosen && rest.empty()) return;
    throw UsageError(fmt::format(
        "study: expected {}{} (see pineda study --help)",
        chosen ? "no more arguments"
               : "area, netlist, parameters, cycles, design-points, bounds or reciprocals",
        rest.empty() ? "" : ", got '" + rest.front() + "'"));
  });

  add_area_study(study, exit_code);
  add_netlist_study(study, exit_code);
  add_parameters_study(study, exit_code);
  add_cycles_study(study, exit_code);
  add_run_study(study, exit_code);

  auto point_options = std::make_shared<StudyOptions>();
  point_options->seed = 1;
  auto* points = study->add_subcommand(
      "design-points", "Every design point on random triangles: errors, bounds, cost");
  add_output_options(points, point_options.get());
  points->add_option("--triangles", point_options->triangles, "Of each of the six classes")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
  points->add_option("--seed", point_options->seed, "Of the random triangles")
      ->type_name("N")
      ->capture_default_str();
  points->callback([point_options, exit_code] { *exit_code = design_points(*point_options); });

  auto bound_options = std::make_shared<StudyOptions>();
  bound_options->seed = 71;
  auto* bound = study->add_subcommand(
      "bounds", "A directed search for the worst triangles, against the derived bounds");
  add_output_options(bound, bound_options.get());
  bound->add_option("--steps", bound_options->steps, "Of each of 24 climbs")
      ->check(CLI::Range(1, 100'000'000))
      ->type_name("N")
      ->capture_default_str();
  bound->add_option("--seed", bound_options->seed, "Of the search")
      ->type_name("N")
      ->capture_default_str();
  bound->callback([bound_options, exit_code] { *exit_code = bounds(*bound_options); });

  auto options = std::make_shared<StudyOptions>();
  auto* reciprocal = study->add_subcommand(
      "reciprocals", "Every scheme of the reciprocal: ROM, cycles, good bits");
  add_output_options(reciprocal, options.get());
  reciprocal->add_flag("--exhaustive", options->exhaustive,
                       "Try every mantissa of every scheme, also of those with 2^33 (minutes)");
  reciprocal->callback([options, exit_code] { *exit_code = reciprocals(*options); });
}

}  // namespace pineda::cli
