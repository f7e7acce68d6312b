// The hard cases of rasterization as small scenes with a name and a right answer each. Opened as
// `hard/NAME`; tests/hard holds core and RTL to the answers.
#pragma once

#include <string>
#include <vector>

#include "model/scene/screen.h"

namespace pineda::scene {

/// One case: what is drawn, and what must come of it.
struct HardCase {
  const char* name;
  const char* summary;
  const char* right_answer;
  spec::FrameState frame;
  /// The same triangles on every call; id = place in the list, but pieces of one that clipping cut
  /// share theirs.
  std::vector<ScreenTriangle> (*make)();
};

/// All of them, in a fixed order: coverage, limits of the formats, values and order,
/// perspective, raster state.
const std::vector<HardCase>& hard_cases();

/// The named case (without "hard/"), or nullptr.
const HardCase* find_hard_case(const std::string& name);

}  // namespace pineda::scene
