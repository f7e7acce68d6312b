// The small scenes that vectors are made from: hard cases by name and random ones by size.
#pragma once

#include <functional>

#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// Triangles of one frame, in order, and when the ports stall.
struct Scene {
  std::string name;  // "sliver.3": class and number
  spec::FrameState frame;
  std::vector<spec::Triangle> triangles;
  PortStalls ports;
  std::optional<uint64_t> reset_cycle;
};

/// Generator levels: 1 is small enough for every run of the tests, 2 is eight times that.
inline constexpr int kMaxLevel = 2;

/// Calls visit(scene) for all scenes of a level, until it returns false. The same for the same design,
/// level and seed; each scene draws from its own random numbers, so a new class changes no other.
void for_each_scene(const spec::Contract& contract, int level, uint64_t seed,
                    const std::function<bool(const Scene&)>& visit);

/// Scenes without end, none of which is in a level, in which everything is drawn evenly over its kinds
/// and its length in bits.
void for_each_further_scene(const spec::Contract& contract, uint64_t seed,
                            const std::function<bool(const Scene&)>& visit);

std::vector<Scene> scenes(const spec::Contract& contract, int level, uint64_t seed);

}  // namespace pineda::vectors
