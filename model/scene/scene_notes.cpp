#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/scene/scene.h"
#include "model/spec/clear_depth.h"

namespace pineda::scene {
namespace {

// Notes on what the scene states but the design cannot draw.
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

// A note if the clear depth lets no sample pass the depth function.
void add_barred(const spec::Design& d, const spec::FrameState& frame,
                std::vector<std::string>* lines) {
  using spec::Barred;
  if (!d.depth_test) return;
  const uint32_t cleared = spec::cleared_depth(d, frame);
  const bool is_nearest = cleared == 0;
  const bool is_farthest = cleared == spec::depth_code(1, d.depth_bits);
  const auto& function = spec::row_of(frame.depth);
  const bool is_barred = function.barred == Barred::kAll ||
                         (function.barred == Barred::kClearedToNearest && is_nearest) ||
                         (function.barred == Barred::kClearedToFarthest && is_farthest);
  if (!is_barred) return;
  lines->push_back(fmt::format("depth {}: {}", function.word, function.why));
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
  add_barred(design, frame, &lines);
  add_missing_parts(design, frame, &lines);
  return lines;
}

std::vector<std::string> notes(const Scene& scene) {
  return notes(scene.source->contract().design, scene.frame, scene.source->counters());
}

}  // namespace pineda::scene
