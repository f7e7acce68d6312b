// Judges a dumped frame by exact arithmetic.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "tests/cli/scene_file.h"

namespace pineda::test {

/// The documented greatest errors of high_tile, final rounding included.
inline constexpr double kDepthBoundUlp = .68;
inline constexpr double kColorBoundLsb = .66;
inline constexpr uint32_t kClearedDepth = 0xffffff;

/// hits.u16, depth.u32 and color.rgba as they lie in a --dump folder.
struct Dump {
  int width = 0;
  int height = 0;
  std::vector<uint16_t> hits;
  std::vector<uint32_t> depth;
  std::vector<std::array<uint8_t, 4>> color;

  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  uint64_t covered() const;  // sum of hits
};

/// Reads a dump; fails the test when a file has another size than the frame's.
Dump read_dump(const std::string& folder, const Scene& scene);

/// Samples of a frame that exact arithmetic contradicts, and the largest errors of the others.
struct Verdict {
  uint64_t wrong_hits = 0;    // samples covered by another number of triangles
  uint64_t wrong_depths = 0;  // samples whose depth is not that of the triangle in front
  uint64_t wrong_colors = 0;  // samples whose colour is that of no triangle that may be in front
  uint64_t covered = 0;       // by the judge: samples of triangles, hidden ones too
  double max_depth_ulp = 0;

  bool holds() const { return wrong_hits == 0 && wrong_depths == 0 && wrong_colors == 0; }
};

std::ostream& operator<<(std::ostream& to, const Verdict& verdict);

/// Judges a dump of a scene without NaN and without perspective, in any order and with any depth
/// function: the depth of a sample must be within the bound of the least exact depth there, its
/// colour within the bound of that of a triangle which may be in front, given the errors of depths.
Verdict judge(const Scene& scene, const Dump& dump);

/// How many X and Y of the scene lie outside the guard band, by exact arithmetic.
uint64_t saturated_coordinates(const Scene& scene);

}  // namespace pineda::test
