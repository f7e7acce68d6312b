// The hard cases of rasterization: small scenes, each with a name and a known right answer. They
// are opened as `hard/NAME`; tests/hard checks core and RTL against the answers.
#pragma once

#include <string>
#include <vector>

#include "model/scene/screen.h"

namespace pineda::scene {

/// One case: what is drawn, and what the result must be.
struct HardCase {
  const char* name;
  const char* summary;
  const char* right_answer;
  spec::FrameState frame;
  /// Gives the same triangles on every call. id = index in the list, except that the pieces of a
  /// clipped triangle share one.
  std::vector<ScreenTriangle> (*make)();
};

/// All of them, in a fixed order: coverage, limits of the formats, values and order,
/// perspective, raster state.
const std::vector<HardCase>& hard_cases();

/// The named case (without "hard/"), or nullptr.
const HardCase* find_hard_case(const std::string& name);

}  // namespace pineda::scene
