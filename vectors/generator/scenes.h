// The small scenes that vectors are made from: hard cases by name and random ones by size.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/spec/structs.h"

namespace pineda::vectors {

/// Triangles of one frame, in order.
struct Scene {
  std::string name;  // "sliver.3": class and number
  spec::FrameState frame;
  std::vector<spec::Triangle> triangles;
};

/// Generator levels: 1 is small enough for every run of the tests, 2 is eight times that.
inline constexpr int kMaxLevel = 2;

/// All scenes of a level. The same for the same design, level and seed; each scene draws from its
/// own random numbers, so a new class changes no other.
std::vector<Scene> scenes(const spec::Contract& contract, int level, uint64_t seed);

}  // namespace pineda::vectors
