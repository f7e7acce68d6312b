#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/scene.h"
#include "model/spec/clear_depth.h"

namespace pineda::scene {
namespace {

// What the scene states and the design has no part for.
void add_missing_parts(const spec::Design& d, const spec::FrameState& frame,
                       std::vector<std::string>* lines) {
  if (!d.depth_test && frame.depth != spec::DepthFunc::kOff) {
    lines->push_back(fmt::format(
        "design {} has no depth: what is drawn last is in front, and no depth is written", d.name));
  }
  const int drawn = std::min(spec::channels(d), 4);
  const int smooth = std::min(d.attributes, 4);
  if (drawn < 4) {
    lines->push_back(fmt::format("design {} draws {} of the colour's 4 channels", d.name,
                                 drawn == 0 ? "none" : "the first " + std::to_string(drawn)));
  }
  if (smooth < drawn && frame.shade == spec::Shade::kSmooth) {
    lines->push_back(
        fmt::format("design {} shades {}flat: a triangle has the colour of its first vertex",
                    d.name, smooth == 0 ? "" : fmt::format("{} channels ", drawn - smooth)));
  }
}

// Depth functions that no sample of a freshly cleared frame passes, or only those at an end of the
// range: a word, for nobody draws so on purpose.
void add_impassable(const spec::Design& d, const spec::FrameState& frame,
                    std::vector<std::string>* lines) {
  using spec::DepthFunc;
  if (!d.depth_test) return;
  const uint32_t cleared = spec::cleared_depth(d, frame);
  const bool is_nearest = cleared == 0;
  const bool is_farthest = cleared == spec::depth_code(1, d.depth_bits);
  const char* text = nullptr;
  if (frame.depth == DepthFunc::kNever) text = "no sample passes";
  if (frame.depth == DepthFunc::kGreater && is_farthest) {
    text =
        "nothing is greater than what depth is cleared to; cleardepth 0 or --clear-depth 0 clears "
        "it to the nearest";
  }
  if (frame.depth == DepthFunc::kGequal && is_farthest) {
    text =
        "only samples at the far end are not less than what depth is cleared to; cleardepth 0 or "
        "--clear-depth 0 clears it to the nearest";
  }
  if (frame.depth == DepthFunc::kLess && is_nearest) {
    text =
        "nothing is less than what depth is cleared to; cleardepth 1 or --clear-depth 1 clears it "
        "to the farthest";
  }
  if (frame.depth == DepthFunc::kLequal && is_nearest) {
    text =
        "only samples at the near end are not greater than what depth is cleared to; cleardepth 1 "
        "or --clear-depth 1 clears it to the farthest";
  }
  if (text != nullptr) lines->push_back(fmt::format("depth {}: {}", name_of(frame.depth), text));
}

}  // namespace

std::vector<std::string> notes(const spec::Design& design, const spec::FrameState& frame,
                               const Counters& c) {
  std::vector<std::string> lines;
  const auto note = [&](uint64_t count, const char* text) {
    if (count > 0) lines.push_back(fmt::format("{} {}", count, text));
  };
  note(c.nan_dropped, "triangles dropped: a coordinate is not a number or cannot be projected");
  note(c.saturated, "coordinates outside the guard band, saturated");
  note(c.z_clamped, "depths outside [0, 1], clamped");
  note(c.denormals, "denormal coordinates taken as 0");
  note(c.clipped, "triangles cut at the near plane or the guard band");
  note(c.clipped_away, "triangles behind the near plane or outside the guard band");
  if (!design.perspective && design.attributes > 0 && frame.shade == spec::Shade::kSmooth) {
    note(c.perspective, "vertices with W other than 1: this design interpolates colours affinely");
  }
  if (!design.perspective && c.affine_colors > 0) {
    lines.push_back(fmt::format(
        "{} triangles whose colours lie up to {:.0f} LSB from perspective-correct ones: "
        "this design interpolates colours affinely",
        c.affine_colors, std::ceil(c.affine_lsb)));
  }
  if (c.rounded_slope > 0) {
    lines.push_back(fmt::format(
        "the depth bias's slope factor is taken as {}, the nearest multiple of 1/256",
        std::ldexp(static_cast<double>(frame.bias_slope), -spec::kBiasFactorFractionBits)));
  }
  add_impassable(design, frame, &lines);
  add_missing_parts(design, frame, &lines);
  return lines;
}

std::vector<std::string> notes(const Scene& scene) {
  return notes(scene.source->contract().design, scene.frame, scene.source->counters());
}

}  // namespace pineda::scene
