// What a scene uses of a rasterizer: its ranges, its values, how often its triangles overlap.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/core/setup.h"
#include "model/scene/scene.h"

namespace pineda::studies {

/// How a colour component varies over a scene: the greatest kind that any triangle shows.
enum class Variation { kConstant, kFlat, kVaries };

/// "constant everywhere", "constant in a triangle", "varying in a triangle".
const char* variation_name(Variation variation);

struct SceneUse {
  uint64_t triangles = 0;                             // snapped, so without those that hold a NaN
  std::array<uint64_t, core::kDropCauses> dropped{};  // by core::Drop; kNone: drawn

  // Of drawn triangles, snapped
  double x_low_px = 0, x_high_px = 0, y_low_px = 0, y_high_px = 0;
  double widest_px = 0, tallest_px = 0, largest_area_px2 = 0;  // may be of different triangles
  double farthest_px = 0;  // greatest width + height: bounds a sample's distance from the anchor
  int guard_bits = 0;      // the least that hold every position, dropped ones too, and the frame

  double depth_low = 1, depth_high = 0;  // of vertices, 0 to 1
  // The least nonzero difference between a new and a stored depth that a depth test compared, as a
  // share of the depth range; 0 where nothing was compared. Differences below 2^-64 of the range
  // count as zero.
  double least_gap = 0;
  uint64_t compared = 0;  // with a sample of another triangle
  uint64_t equal = 0;     // of those

  std::array<Variation, 4> color{};
  std::array<int, 4> color_value{};    // of what is constant
  uint64_t perspective_triangles = 0;  // drawn, with unequal w and unequal colours

  uint64_t samples = 0;  // covered, hidden ones included
  uint64_t covered = 0;  // samples of the frame that a triangle covers
  uint64_t most_hits = 0;

  /// Bits that a depth code needs to tell the least gap apart: 2^-bits <= gap.
  int gap_bits() const;
  double mean_hits() const {
    return covered == 0 ? 0 : static_cast<double>(samples) / static_cast<double>(covered);
  }
};

/// Which triangle is seen at each sample of the frame: its number + 1 in the order in which the
/// scene is drawn, 0 for none.
using Winners = std::vector<uint32_t>;

/// One pass over the scene in exact arithmetic. `*winners`: what is visible with exact depths.
///
/// In       a scene that can be rewound and was opened for `base`; a depth bias is in base's codes.
SceneUse scene_use(const scene::Scene& scene, const spec::Contract& base, Winners* winners);

}  // namespace pineda::studies
