#include "cli/report/needs_report.h"

#include <algorithm>

#include "model/spec/design_file.h"

namespace pineda::cli {
namespace {

constexpr const char* kChannels[] = {"r", "g", "b", "a"};

std::string bits(int64_t count) {
  return (count < 0 ? "-" : "") + grouped(static_cast<uint64_t>(count < 0 ? -count : count));
}

std::string colors_text(const studies::SceneUse& use) {
  std::string text;
  for (const auto kind :
       {studies::Variation::kVaries, studies::Variation::kFlat, studies::Variation::kConstant}) {
    std::string names;
    for (size_t c = 0; c < 4; ++c) {
      if (use.color[c] != kind) continue;
      names += fmt::format("{}{}", names.empty() ? "" : ", ", kChannels[c]);
      if (kind == studies::Variation::kConstant) names += fmt::format(" = {}", use.color_value[c]);
    }
    if (names.empty()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", names, studies::variation_name(kind));
  }
  return text;
}

void print_use(const Output& output, const studies::SceneUse& use) {
  uint64_t dropped = 0;
  for (size_t i = 1; i < use.dropped.size(); ++i) dropped += use.dropped[i];
  output.row("triangles", fmt::format("{}, {} dropped", grouped(use.triangles), grouped(dropped)));
  output.row(
      "positions",
      fmt::format("x {:.6g} to {:.6g} px, y {:.6g} to {:.6g} px; {} guard bits with the frame",
                  use.x_low_px, use.x_high_px, use.y_low_px, use.y_high_px, use.guard_bits));
  output.row("largest triangle", fmt::format("{:.4g} px wide, {:.4g} px tall, {:.4g} px^2",
                                             use.widest_px, use.tallest_px, use.largest_area_px2));
  output.row("depth", fmt::format("{:.4g} to {:.4g}", use.depth_low, use.depth_high));
  output.row(
      "least gap",
      use.least_gap == 0
          ? fmt::format("none in {} comparisons", grouped(use.compared))
          : fmt::format("{:.3g} of the range, {} bits; {} comparisons, {} of equal depths",
                        use.least_gap, use.gap_bits(), grouped(use.compared), grouped(use.equal)));
  output.row("colours", colors_text(use));
  output.row("perspective", fmt::format("{} triangles with unequal w and colours",
                                        grouped(use.perspective_triangles)));
  output.row("overlap", fmt::format("{:.2f} triangles a covered sample, {} at most",
                                    use.mean_hits(), grouped(use.most_hits)));
}

Json use_json(const studies::SceneUse& use) {
  Json json{{"triangles", use.triangles}};
  for (size_t i = 1; i < use.dropped.size(); ++i) {
    json["dropped"][spec::name_of(static_cast<core::Drop>(i))] = use.dropped[i];
  }
  json["x_px"] = {use.x_low_px, use.x_high_px};
  json["y_px"] = {use.y_low_px, use.y_high_px};
  json["guard_bits"] = use.guard_bits;
  json["widest_px"] = use.widest_px;
  json["tallest_px"] = use.tallest_px;
  json["largest_area_px2"] = use.largest_area_px2;
  json["depth"] = {{"low", use.depth_low},       {"high", use.depth_high},
                   {"least_gap", use.least_gap}, {"gap_bits", use.gap_bits()},
                   {"compared", use.compared},   {"equal", use.equal}};
  for (size_t c = 0; c < 4; ++c) {
    Json color{{"variation", studies::variation_name(use.color[c])}};
    if (use.color[c] == studies::Variation::kConstant) color["value"] = use.color_value[c];
    json["color"][kChannels[c]] = color;
  }
  json["perspective_triangles"] = use.perspective_triangles;
  json["samples"] = use.samples;
  json["covered"] = use.covered;
  json["mean_hits"] = use.mean_hits();
  json["most_hits"] = use.most_hits;
  return json;
}

Json judgement_json(const studies::SceneJudgement& j) {
  return {{"samples", j.samples},
          {"missing", j.missing},
          {"extra", j.extra},
          {"other_winner", j.other_winner},
          {"max_depth_ulp", j.max_depth_ulp},
          {"max_color_lsb", j.max_color_lsb}};
}

Json cost_json(const studies::DesignCost& cost) {
  return {{"total", cost.total()},
          {"setup", cost.setup},
          {"reciprocal", cost.reciprocal},
          {"interpolation", cost.interpolation},
          {"buffers", cost.buffers}};
}

std::string errors_text(const studies::Needs& needs) {
  const auto& j = needs.judgement;
  const std::string color = fmt::format("colour {:.4f} LSB", j.max_color_lsb);
  if (!needs.design.depth_test) return color + "; without depth its limit is moot";
  return fmt::format("depth {:.4f} ulp, {}", j.max_depth_ulp, color);
}

void print_parameters(const Output& output, const studies::Needs& needs, const spec::Design& base) {
  output.line("  {:<24}{:<27}{:<22}{:>8}  {}", "parameter", base.name, "needs", "saved",
              "the next smaller, and what it breaks");
  for (const auto& p : needs.parameters) {
    output.line("  {:<24}{:<27}{:<22}{:>8}  {}", p.parameter, p.base, p.value, bits(p.saved_bits),
                p.next.empty() ? "-" : fmt::format("{}: {}", p.next, p.forbids));
  }
  output.line(
      "  saved: bits that the design would have more with the base's value. What stays: "
      "subpixel_bits, which\n  defines the snapped positions; tiles, stamps and FIFOs, which "
      "define the throughput.");
}

}  // namespace

Json needs_json(const studies::Needs& needs, const spec::Design& base) {
  Json json{{"base", base.name}, {"holds", needs.found}};
  json["limits"] = {{"depth_ulp", needs.limits.depth_ulp},
                    {"color_lsb", needs.limits.color_lsb},
                    {"other_winner", needs.limits.other_winner}};
  json["use"] = use_json(needs.use);
  json["base_judgement"] = judgement_json(needs.of_start);
  json["base_bits"] = cost_json(needs.base_cost);
  json["judged_designs"] = needs.judged_designs;
  if (!needs.found) return json;
  json["judgement"] = judgement_json(needs.judgement);
  json["bits"] = cost_json(needs.cost);
  for (const auto& p : needs.parameters) {
    json["parameters"][p.parameter] = {{"base", p.base},
                                       {"needs", p.value},
                                       {"saved_bits", p.saved_bits},
                                       {"next", p.next},
                                       {"forbids", p.forbids}};
  }
  json["toml"] = needs_toml(needs, base);
  return json;
}

void print_needs(const Output& output, const studies::Needs& needs, const spec::Design& base) {
  print_use(output, needs.use);
  if (!needs.found) return;
  output.line("");
  print_parameters(output, needs, base);
  output.line("");
  const auto& cost = needs.cost;
  output.row("bits",
             fmt::format("{} of {}: setup {}, reciprocal {}, interpolation {}, buffers {}",
                         bits(cost.total()), bits(needs.base_cost.total()), bits(cost.setup),
                         bits(cost.reciprocal), bits(cost.interpolation), bits(cost.buffers)));
  output.row("largest errors", errors_text(needs));
  output.row(
      "other winners",
      fmt::format("{} samples show another triangle than with exact depths, {} with the base",
                  grouped(needs.judgement.other_winner), grouped(needs.of_start.other_winner)));
}

std::string needs_toml(const studies::Needs& needs, const spec::Design& base) {
  const spec::Design* named = spec::find_design(base.name);
  const bool has_name = named != nullptr && spec::design_toml(*named) == spec::design_toml(base);
  const std::string comment = fmt::format(
      "# Judged at every sample: coverage exact, {}.\n# {} bits of {}'s {}.\n", errors_text(needs),
      bits(needs.cost.total()), base.name, bits(needs.base_cost.total()));
  return comment +
         (has_name ? spec::design_toml(needs.design, base) : spec::design_toml(needs.design));
}

}  // namespace pineda::cli
