#include "studies/needs/needs.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "model/spec/design_file.h"
#include "studies/needs/shrink.h"

namespace pineda::studies {
namespace {

using spec::Design;

/// Looks for the smallest design; remembers what it has judged.
class Search {
 public:
  Search(const scene::Scene& scene, const NeedsOptions& options)
      : scene_(scene), options_(options) {
    needs_.limits = {options.depth_ulp, options.color_lsb, 0};
  }

  Needs run();

 private:
  void start();
  std::string refused(const Design& design) const;
  const SceneJudgement& judge(const Design& design, bool in_full);
  bool holds(const Design& design) { return judge(design, false).holds(needs_.limits); }
  std::vector<Design> smaller(const ShrinkableParameter& parameter, const Design& design) const;
  Design least(const ShrinkableParameter& parameter, const Design& design);
  Design closed(Design design);
  Design named(const Design& design) const;
  Need need(const ShrinkableParameter& parameter);

  const scene::Scene& scene_;
  const NeedsOptions& options_;
  Needs needs_;
  Winners winners_;
  TruthCache truths_;
  std::map<std::string, SceneJudgement> judged_;
};

/// Why a design cannot be the answer, before it is judged.
std::string Search::refused(const Design& d) const {
  const SceneUse& use = needs_.use;
  if (d.guard_bits < use.guard_bits) {
    return fmt::format("positions or the frame beyond {} px", 1 << d.guard_bits);
  }
  if (scene_.frame.has_bias() && d.depth_test && d.depth_bits != options_.base.depth_bits) {
    return fmt::format("the depth bias is in codes of {} bits", options_.base.depth_bits);
  }
  return spec::invalid_reason(d);
}

const SceneJudgement& Search::judge(const Design& d, bool in_full) {
  const std::string key = spec::design_toml(d);
  if (const auto known = judged_.find(key);
      known != judged_.end() && (known->second.finished || !in_full)) {
    return known->second;
  }
  ++needs_.judged_designs;
  const auto progress = [this](uint64_t triangles) {
    if (options_.progress) options_.progress(needs_.judged_designs, triangles);
  };
  const SceneJudgeOptions options{needs_.limits, !in_full, progress};
  return judged_[key] =
             judge_scene(scene_, d, options_.base.guard_bits, winners_, options, &truths_);
}

void Search::start() {
  needs_.start = needs_.design = options_.base;
  needs_.of_start = judge(needs_.start, true);
  const bool is_color = needs_.of_start.max_color_lsb > options_.color_lsb;
  if (is_color && needs_.use.perspective_triangles > 0 && !needs_.start.perspective) {
    Design d = options_.base;
    d.perspective = true;
    if (spec::invalid_reason(d).empty()) {
      needs_.start = d;
      needs_.of_start = judge(d, true);
    }
  }
  needs_.limits.other_winner = needs_.of_start.other_winner;
  needs_.found = needs_.of_start.holds(needs_.limits);
  judged_.clear();  // these were judged with other limits
}

/// The designs with smaller values of a parameter that are cheaper and possible.
std::vector<Design> Search::smaller(const ShrinkableParameter& parameter, const Design& d) const {
  std::vector<Design> all;
  const int64_t cost = design_cost(d).total();
  for (const Design& other : parameter.smaller(d)) {
    if (!refused(other).empty() || design_cost(other).total() >= cost) break;
    all.push_back(other);
  }
  return all;
}

/// Bisects for the least value that holds, given that all larger ones hold; `design` holds.
Design Search::least(const ShrinkableParameter& parameter, const Design& design) {
  std::vector<Design> chain = smaller(parameter, design);
  chain.insert(chain.begin(), design);
  size_t holding = 0;
  size_t failing = chain.size();
  // Tries the next smaller value first: most parameters are flags or cannot shrink.
  for (size_t middle = 1; holding + 1 < failing; middle = (holding + failing) / 2) {
    (holds(chain[middle]) ? holding : failing) = middle;
  }
  return chain[holding];
}

/// Shrinks parameters one at a time until none can be made smaller alone.
Design Search::closed(Design design) {
  for (bool moved = true; moved;) {
    moved = false;
    for (const auto& parameter : shrinkable_parameters()) {
      for (const Design& d : smaller(parameter, design)) {
        if (!holds(d)) break;
        design = d;
        moved = true;
      }
    }
  }
  return design;
}

Design Search::named(const Design& design) const {
  const std::string name = scene_.name + "_needs";
  const std::string summary =
      fmt::format("what {} needs at {}x{}: depth within {} ulp, colour within {} LSB", scene_.name,
                  scene_.frame.width, scene_.frame.height, options_.depth_ulp, options_.color_lsb);
  Design d = design;
  d.name = name.c_str();
  d.summary = summary.c_str();
  return spec::parse_design(spec::design_toml(d), name);
}

Need Search::need(const ShrinkableParameter& parameter) {
  const Design& d = needs_.design;
  Need need{parameter.name, parameter.text(options_.base), parameter.text(d), 0, {}, {}};
  Design back = d;
  parameter.copy(options_.base, &back);
  need.saved_bits = design_cost(back).total() - needs_.cost.total();
  const auto all = parameter.smaller(d);
  if (need.value == "-" || all.empty()) return need;
  need.next = parameter.text(all[0]);
  need.forbids = refused(all[0]);
  if (need.forbids.empty()) need.forbids = judge(all[0], true).broken(needs_.limits);
  if (need.forbids.empty()) need.forbids = "nothing: it would save no bit";
  return need;
}

Needs Search::run() {
  needs_.use = scene_use(scene_, spec::contract(options_.base), &winners_);
  needs_.base_cost = design_cost(options_.base);
  start();
  needs_.judgement = needs_.of_start;
  if (needs_.found) {
    Design d = needs_.start;
    for (const char* name :
         {"guard_bits", "depth_test", "attributes", "perspective", "depth_bits"}) {
      d = least(shrinkable_parameter(name), d);
    }
    // Reciprocal and fractions share one error budget, so both orders of shrinking are tried.
    Design reciprocal_first = d;
    for (const char* name :
         {"reciprocal", "inverse_w_bits", "tile_fraction_bits", "gradient_fraction_bits"}) {
      reciprocal_first = least(shrinkable_parameter(name), reciprocal_first);
    }
    Design fractions_first = d;
    for (const char* name :
         {"tile_fraction_bits", "gradient_fraction_bits", "inverse_w_bits", "reciprocal"}) {
      fractions_first = least(shrinkable_parameter(name), fractions_first);
    }
    reciprocal_first = closed(reciprocal_first);
    fractions_first = closed(fractions_first);
    const bool other = design_cost(reciprocal_first).total() < design_cost(fractions_first).total();
    needs_.design = other ? reciprocal_first : fractions_first;
    needs_.judgement = judge(needs_.design, true);
  }
  needs_.cost = design_cost(needs_.design);
  for (const auto& parameter : shrinkable_parameters()) {
    if (needs_.found) needs_.parameters.push_back(need(parameter));
  }
  if (needs_.found) needs_.design = named(needs_.design);
  return needs_;
}

}  // namespace

Needs find_needs(const scene::Scene& scene, const NeedsOptions& options) {
  return Search(scene, options).run();
}

}  // namespace pineda::studies
