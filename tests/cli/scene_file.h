// Scenes of triangles and the files that hold them, written from the formats' description alone.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

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

/// Draws numbers; the same ones on every machine.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}
  int in(int low, int high) {  // both inclusive
    return low + static_cast<int>(engine_() % static_cast<uint64_t>(int64_t{high} - low + 1));
  }
  float in(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 40) * 0x1p-24f;
  }
  Vertex vertex(float x, float y) {
    Vertex v{x, y, in(0.f, 1.f), {}};
    for (auto& channel : v.rgba) channel = static_cast<uint8_t>(in(0, 255));
    return v;
  }
  /// The same triangle from another corner, wound either way.
  Triangle any_order(Triangle t);

 private:
  std::mt19937_64 engine_;
};

}  // namespace pineda::test
