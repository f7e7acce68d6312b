// The hard frames that every command is tried on.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "tests/cli/scene_file.h"

namespace pineda::test {

struct Frame {
  std::string name;
  Scene scene;
};
inline std::ostream& operator<<(std::ostream& to, const Frame& frame) { return to << frame.name; }

/// A mesh over the whole frame and beyond its borders, of triangles in any winding and vertex
/// order: nodes every `spacing` steps of `step_px`, moved by up to a fifth of that.
Scene mesh(int width, int height, int spacing, float step_px, uint64_t seed);

/// Random triangles over one another.
Scene pile(int width, int height, int triangles, uint64_t seed);

/// Triangles of a doubled area of 1 or 2 units of 2^-16 px^2 on pixel centres: each covers one
/// sample or none.
Scene slivers(int count, uint64_t seed);

/// Classes of hard triangles, each meant for a frame of its own.
std::vector<Scene> lone_needles();  // 100 to 8000 px long, 1/16 to 2 px wide
std::vector<Scene> lone_slivers();  // two units of doubled area or one, on a sample
std::vector<Scene> lone_giants();   // corners anywhere in the guard band, an edge in the frame
std::vector<Scene> lone_midgets();  // within one or two pixels

/// All frames by name, with every cull and depth function among them.
const std::vector<Frame>& frames();
/// The scene of that name in frames().
Scene frame(const std::string& name);

}  // namespace pineda::test
