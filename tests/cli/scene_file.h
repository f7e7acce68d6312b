// Scenes of triangles and the files that hold them, written from the formats' description alone.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "model/spec/random.h"

namespace pineda::test {

/// Values of .tri lines and .ptrb vertices. The numbers of an enumerator are those of .ptrb.
enum class Cull { kNone, kBack, kFront };
enum class Depth { kLess, kLequal, kOff };

struct Vertex {
  float x = 0;
  float y = 0;
  float z = .5f;
  std::array<uint8_t, 4> rgba{};
  float w = 1;
};
using Triangle = std::array<Vertex, 3>;

struct Scene {
  int width = 64;
  int height = 48;
  Cull cull = Cull::kNone;
  Depth depth = Depth::kLess;
  std::vector<Triangle> triangles;
  std::string state = {};  // further state lines of a .tri file
};

std::string tri_text(const Scene& scene);
/// With_w: each vertex has its W.
std::string ptrb_bytes(const Scene& scene, bool with_w = false);

/// Draws vertices too.
class Random : public spec::RandomFrom<std::mt19937_64> {
 public:
  using RandomFrom::RandomFrom;
  Vertex vertex(float x, float y) {
    Vertex v{x, y, uniform(0, 1), {}};
    for (auto& channel : v.rgba) channel = static_cast<uint8_t>(between(0, 255));
    return v;
  }
  /// The same triangle from another corner, wound either way.
  Triangle any_order(Triangle t);
};

}  // namespace pineda::test
