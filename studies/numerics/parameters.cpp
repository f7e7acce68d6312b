#include "studies/numerics/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "studies/cycles/model_cycles.h"

namespace pineda::studies {
namespace {

using spec::Design;
using spec::ReciprocalScheme;
using spec::SetupStyle;

constexpr const char* kReciprocal = "reciprocal";

std::string reciprocal_text(const Design& d) {
  const spec::Scheme& scheme = spec::scheme_of(d);
  const std::string lut = fmt::format("LUT{}", d.reciprocal_lut_bits);
  const std::string what = scheme.has_newton_steps
                               ? fmt::format("{} + {}N", lut, d.reciprocal_newton_steps)
                           : scheme.has_rom ? fmt::format("{} {}", scheme.word, lut)
                                            : scheme.word;
  return fmt::format("{}, k{}", what, d.reciprocal_bits);
}

/// Collects the designs that differ from a base in one parameter.
class Points {
 public:
  Points(const Design& base, const spec::FrameState& frame) : base_(base), frame_(frame) {}

  std::vector<ParameterPoint> take() { return std::move(points_); }

  /// Adds a point for each value of a numeric parameter.
  void numbers(int Design::*member, std::initializer_list<int> values) {
    const spec::Parameter& p = spec::parameter(member);
    for (const int value : values) {
      Design d = base_;
      d.*member = value;
      add(p.key, spec::file_value(p, d), d, value == base_.*member);
    }
  }
  void switches(const char* parameter, bool Design::*member) {
    for (const bool value : {false, true}) {
      Design d = base_;
      d.*member = value;
      add(parameter, value ? "true" : "false", d, value == base_.*member);
    }
  }
  void attributes() {
    for (const int value : {0, 1, 2, 3, 4, 8, 16}) {
      Design d = base_;
      d.attributes = value;
      // Colours that are not interpolated become flat, so that there are four channels at least.
      d.flat_attributes = std::max(0, 4 - value);
      add("attributes", fmt::format("{}", value), d, value == base_.attributes);
    }
  }
  void reciprocals() {
    const auto scheme = [&](ReciprocalScheme s, int lut_bits, int steps, int k) {
      Design d = base_;
      d.reciprocal_scheme = s;
      d.reciprocal_lut_bits = lut_bits;
      d.reciprocal_newton_steps = steps;
      d.reciprocal_bits = k;
      const std::string text = reciprocal_text(d);
      add(kReciprocal, text, d, text == reciprocal_text(base_));
    };
    scheme(ReciprocalScheme::kNewton, 12, 0, 26);
    scheme(ReciprocalScheme::kNewton, 12, 1, 26);
    scheme(ReciprocalScheme::kQuadratic, 7, 0, 26);
    scheme(ReciprocalScheme::kNewton, 7, 2, 30);
    scheme(ReciprocalScheme::kNewton, 8, 2, 32);
    scheme(ReciprocalScheme::kRestoring2, 0, 0, 28);
    scheme(ReciprocalScheme::kRestoring4, 0, 0, 28);
  }
  void styles() {
    // By rising speed.
    for (const SetupStyle style :
         {SetupStyle::kSerial, SetupStyle::kStepped, SetupStyle::kPipelined}) {
      Design d = base_;
      d.setup_style = style;
      add("setup_style", spec::name_of(style), d, style == base_.setup_style);
    }
  }
  void stamps() {
    for (const auto& [width, height] : {std::pair{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}}) {
      Design d = base_;
      d.stamp_width_log2 = width;
      d.stamp_height_log2 = height;
      add("stamp_px", fmt::format("{}x{}", 1 << width, 1 << height), d,
          width == base_.stamp_width_log2 && height == base_.stamp_height_log2);
    }
  }

 private:
  void add(const char* parameter, const std::string& value, const Design& design, bool is_base) {
    if (!spec::invalid_reason(design).empty() || !spec::no_cycles_reason(design).empty()) return;
    if (std::max(frame_.width, frame_.height) > 1 << design.guard_bits) return;
    ParameterPoint point;
    point.parameter = parameter;
    point.value = value;
    point.is_base = is_base;
    point.design = design;
    point.cost = design_cost(design);
    point.bounds = spec::error_bounds(design);
    points_.push_back(point);
  }

  const Design& base_;
  const spec::FrameState& frame_;
  std::vector<ParameterPoint> points_;
};

int64_t cycles_of(const scene::Scene& scene, const Design& design) {
  const spec::Contract contract = spec::contract(design);
  scene::SnappedSource source(contract, std::make_unique<scene::Unsnapped>(scene.source.get()));
  source.rewind();
  std::vector<spec::Triangle> triangles;
  for (spec::Triangle t; source.next(&t);) triangles.push_back(t);
  return model_cycles(contract, scene.frame, triangles);
}

}  // namespace

std::vector<ParameterPoint> parameter_points(const Design& base, const spec::FrameState& frame) {
  Points points(base, frame);
  points.numbers(&Design::subpixel_bits, {4, 6, 8, 10, 12});
  points.numbers(&Design::guard_bits, {9, 10, 11, 12, 13, 14});
  points.switches("depth_test", &Design::depth_test);
  points.numbers(&Design::depth_bits, {16, 20, 24, 32});
  points.attributes();
  points.numbers(&Design::attribute_bits, {4, 8, 12, 16});
  points.switches("perspective", &Design::perspective);
  points.reciprocals();
  points.numbers(&Design::gradient_fraction_bits, {10, 12, 14, 16, 18, 20});
  points.numbers(&Design::tile_fraction_bits, {4, 6, 8, 10, 14, 18});
  points.styles();
  points.numbers(&Design::tile_log2, {2, 3, 4, 5});
  points.stamps();
  points.numbers(&Design::tested_stamps_log2, {0, 1, 2});
  points.switches("hierarchical_z", &Design::hierarchical_z);
  points.numbers(&Design::prim_fifo_depth, {0, 1, 2, 4, 16});
  points.numbers(&Design::tile_fifo_depth, {0, 1, 2, 4, 16});
  points.numbers(&Design::stamp_fifo_depth, {1, 2, 4, 16});
  points.numbers(&Design::plane_slots, {2, 4, 6, 8, 16});
  points.numbers(&Design::depth_latency_cycles, {1, 4, 8, 16});
  points.numbers(&Design::max_depth_latency_cycles, {8, 16, 32, 64});
  return points.take();
}

std::vector<ParameterPoint> study_parameters(const scene::Scene& scene,
                                             const ParameterOptions& options) {
  std::vector<ParameterPoint> points = parameter_points(options.base, scene.frame);
  const auto asked = [&](const std::string& parameter) {
    const auto& names = options.parameters;
    return names.empty() || std::find(names.begin(), names.end(), parameter) != names.end();
  };
  for (const std::string& name : options.parameters) {
    const bool known = std::any_of(points.begin(), points.end(),
                                   [&](const ParameterPoint& p) { return p.parameter == name; });
    if (!known) throw std::invalid_argument(name);
  }
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const ParameterPoint& p) { return !asked(p.parameter); }),
               points.end());
  Winners winners;
  scene_use(scene, spec::contract(options.base), &winners);
  for (ParameterPoint& p : points) {
    SceneJudgeOptions judge;
    if (options.progress) {
      judge.progress = [&](uint64_t triangles) { options.progress(p.parameter, triangles); };
    }
    p.judgement = judge_scene(scene, p.design, options.base.guard_bits, winners, judge);
    p.cycles = cycles_of(scene, p.design);
  }
  return points;
}

}  // namespace pineda::studies
