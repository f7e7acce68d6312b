#include "tests/cli/frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace pineda::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kSubpixel = 0x1p-8f;

/// The greatest common divisor, with a*x + b*y equal to it.
int bezout(int a, int b, int* x, int* y) {
  if (b == 0) {
    *x = 1;
    *y = 0;
    return a;
  }
  const int divisor = bezout(b, a % b, y, x);
  *y -= a / b * *x;
  return divisor;
}

/// With cross(d, w) = 1, the corners p+d, p-d+e1*w, p+e2*w span |e1 - 2*e2| units of doubled area.
Triangle sliver(Random* random, int width, int height) {
  int dx = 0, dy = 0, wx = 0, wy = 0;
  do {
    dx = random->between(1, 20000);
    dy = random->between(1, 20000);
  } while (bezout(dx, dy, &wy, &wx) != 1);
  wx = -wx;
  if (random->between(0, 1) == 1) {  // mirrored in y
    dy = -dy;
    wy = -wy;
  }
  const bool is_one_unit = random->between(0, 1) == 1;
  const int e1 = is_one_unit ? 1 - 2 * random->between(0, 1) : 0;
  const int e2 = is_one_unit ? 0 : 1 - 2 * random->between(0, 1);
  const int x = 256 * random->between(0, width - 1) + 128;
  const int y = 256 * random->between(0, height - 1) + 128;
  const auto corner = [&](int corner_x, int corner_y) {
    return random->vertex(static_cast<float>(corner_x) * kSubpixel,
                          static_cast<float>(corner_y) * kSubpixel);
  };
  return random->any_order({corner(x + dx, y + dy), corner(x - dx + e1 * wx, y - dy + e1 * wy),
                            corner(x + e2 * wx, y + e2 * wy)});
}

/// Corners on the guard band's own: -2^14, the greatest coordinate inside, and 0.
Scene guard_band() {
  constexpr float kLow = -16384;
  constexpr float kHigh = 16384 - kSubpixel;
  Random random(31);
  Scene scene{67, 45, Cull::kNone, Depth::kLess, {}};
  const std::array<float, 3> values{kLow, 0, kHigh};
  for (int i = 0; i < 24; ++i) {
    const auto corner = [&] {
      const float y = values[static_cast<size_t>(random.between(0, 2))];
      return random.vertex(values[static_cast<size_t>(random.between(0, 2))], y);
    };
    scene.triangles.push_back({corner(), corner(), corner()});
  }
  scene.triangles.push_back(
      {random.vertex(kLow, kLow), random.vertex(kHigh, kLow), random.vertex(kLow, kHigh)});
  return scene;
}

/// Coordinates outside the guard band: by a hair, far, at any float, and infinite.
Scene beyond_the_guard_band() {
  Random random(32);
  Scene scene{67, 45, Cull::kNone, Depth::kLequal, {}};
  const std::array<float, 12> values{
      16384, -16384 - 0x1p-7f, 16777216, -16777216, 1e9f,      -1e9f,
      3e38f, -3e38f,           32768,    -32768,    kInfinity, -kInfinity};
  for (int i = 0; i < 40; ++i) {
    const auto value = [&] { return values[static_cast<size_t>(random.between(0, 11))]; };
    const float inside_y = random.uniform(0.f, 45.f);
    const Vertex inside = random.vertex(random.uniform(0.f, 67.f), inside_y);
    const float beside_y = random.uniform(0.f, 45.f);
    const Vertex beside = random.vertex(value(), beside_y);
    const float far_y = value();
    scene.triangles.push_back({inside, beside, random.vertex(value(), far_y)});
  }
  return scene;
}

/// Edges through the one sample of a frame of one pixel, from every side, and around it.
Scene one_pixel() {
  Random random(33);
  Scene scene{1, 1, Cull::kNone, Depth::kLequal, {}};
  const std::array<float, 5> values{-1, 0, .5, 1, 2};
  for (int i = 0; i < 60; ++i) {
    const auto corner = [&] {
      const float y = values[static_cast<size_t>(random.between(0, 4))];
      return random.vertex(values[static_cast<size_t>(random.between(0, 4))], y);
    };
    scene.triangles.push_back({corner(), corner(), corner()});
  }
  return scene;
}

/// Triangles whose corners and edges lie on the borders of tiles and stamps.
Scene tile_borders() {
  Random random(34);
  Scene scene{41, 27, Cull::kNone, Depth::kLequal, {}};
  for (int i = 0; i < 60; ++i) {
    const auto corner = [&] {
      const auto y = static_cast<float>(8 * random.between(-1, 4));
      const auto border = static_cast<float>(8 * random.between(-1, 6));
      return random.vertex(border + .5f * static_cast<float>(random.between(-1, 1)), y);
    };
    scene.triangles.push_back({corner(), corner(), corner()});
  }
  return scene;
}

/// One plane for all, parallel to the screen: every triangle has the same depth everywhere.
Scene level(Depth depth) {
  Scene scene = pile(64, 48, 30, 35);
  scene.depth = depth;
  for (auto& t : scene.triangles) {
    for (auto& v : t) {
      v.z = .25f;
      v.rgba = t[0].rgba;
    }
  }
  return scene;
}

/// The ends of the depth range, where a code is clamped or equals the cleared one.
Scene depth_extremes() {
  Scene scene = pile(64, 48, 30, 36);
  Random random(37);
  for (auto& t : scene.triangles) {
    for (auto& v : t) v.z = static_cast<float>(random.between(0, 1));
  }
  return scene;
}

std::vector<Frame> all_frames() {
  std::vector<Frame> all{{"JitteredMesh", mesh(200, 150, 9 * 256, kSubpixel, 21)},
                         {"HalfPixelMesh", mesh(203, 149, 10, .5f, 22)},
                         {"OddFrame", mesh(641, 479, 40 * 256, kSubpixel, 23)},
                         {"LongFrame", pile(16384, 3, 8, 24)},
                         {"TallFrame", pile(3, 1001, 20, 25)},
                         {"OnePixel", one_pixel()},
                         {"Slivers", slivers(300, 26)},
                         {"GuardBand", guard_band()},
                         {"BeyondTheGuardBand", beyond_the_guard_band()},
                         {"TileBorders", tile_borders()},
                         {"EqualDepthLess", level(Depth::kLess)},
                         {"EqualDepthLequal", level(Depth::kLequal)},
                         {"DepthExtremes", depth_extremes()},
                         {"NoTriangles", Scene{37, 21, Cull::kNone, Depth::kLess, {}}},
                         {"NoTrianglesOff", Scene{8, 8, Cull::kBack, Depth::kOff, {}}}};
  static constexpr const char* kCull[] = {"None", "Back", "Front"};
  static constexpr const char* kDepth[] = {"Less", "Lequal", "Off"};
  for (int cull = 0; cull < 3; ++cull) {
    for (int depth = 0; depth < 3; ++depth) {
      Scene scene = pile(64, 48, 40, 27);
      scene.cull = static_cast<Cull>(cull);
      scene.depth = static_cast<Depth>(depth);
      all.push_back({std::string("Cull") + kCull[cull] + "Depth" + kDepth[depth], scene});
    }
  }
  return all;
}

template <class Make>
std::vector<Scene> each_alone(int count, int width, int height, Make make) {
  std::vector<Scene> scenes;
  for (int i = 0; i < count; ++i) {
    scenes.push_back({width, height, Cull::kNone, Depth::kLess, {make()}});
  }
  return scenes;
}

}  // namespace

Scene mesh(int width, int height, int spacing, float step_px, uint64_t seed) {
  Random random(seed);
  Scene scene{width, height, Cull::kNone, Depth::kLess, {}};
  const float spacing_px = static_cast<float>(spacing) * step_px;
  const int columns = static_cast<int>(static_cast<float>(width) / spacing_px) + 4;
  const int rows = static_cast<int>(static_cast<float>(height) / spacing_px) + 4;
  std::vector<Vertex> nodes;
  const auto place = [&](int node) {  // the first two nodes lie outside the frame
    return static_cast<float>(spacing * (node - 1) + random.between(-spacing / 5, spacing / 5)) *
           step_px;
  };
  for (int i = 0; i < rows * columns; ++i) {
    const float x = place(i % columns);
    nodes.push_back(random.vertex(x, place(i / columns)));
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const auto at = [&](int down, int right) {
        return nodes[static_cast<size_t>((row + down) * columns + column + right)];
      };
      scene.triangles.push_back(random.any_order({at(0, 0), at(0, 1), at(1, 0)}));
      scene.triangles.push_back(random.any_order({at(0, 1), at(1, 1), at(1, 0)}));
    }
  }
  for (size_t i = scene.triangles.size() - 1; i > 0; --i) {
    std::swap(scene.triangles[i],
              scene.triangles[static_cast<size_t>(random.between(0, static_cast<int>(i)))]);
  }
  return scene;
}

Scene pile(int width, int height, int triangles, uint64_t seed) {
  Random random(seed);
  Scene scene{width, height, Cull::kNone, Depth::kLess, {}};
  const auto corner = [&] {
    const float x = random.uniform(-.3f, 1.3f) * static_cast<float>(width);
    return random.vertex(x, random.uniform(-.3f, 1.3f) * static_cast<float>(height));
  };
  for (int i = 0; i < triangles; ++i) scene.triangles.push_back({corner(), corner(), corner()});
  return scene;
}

Scene slivers(int count, uint64_t seed) {
  Random random(seed);
  Scene scene{40, 30, Cull::kNone, Depth::kLess, {}};
  for (int i = 0; i < count; ++i) scene.triangles.push_back(sliver(&random, 40, 30));
  return scene;
}

std::vector<Scene> lone_needles() {
  Random random(41);
  return each_alone(10, 320, 200, [&]() -> Triangle {
    const float angle = random.uniform(0.f, 6.2831853f);
    const float length_px = 100 * std::exp2(random.uniform(0.f, 6.3f));
    const float width_px = std::exp2(random.uniform(-4.f, 1.f));
    const float along = random.uniform(.2f, .8f) * length_px;
    const float x = random.uniform(100.f, 220.f);
    const float y = random.uniform(60.f, 140.f);
    const auto corner = [&](float forward, float aside) {
      return random.vertex(x + forward * std::cos(angle) - aside * std::sin(angle),
                           y + forward * std::sin(angle) + aside * std::cos(angle));
    };
    return random.any_order({corner(-along, -width_px / 2), corner(-along, width_px / 2),
                             corner(length_px - along, 0)});
  });
}

std::vector<Scene> lone_slivers() {
  Random random(42);
  return each_alone(20, 40, 30, [&] { return sliver(&random, 40, 30); });
}

std::vector<Scene> lone_giants() {
  Random random(43);
  return each_alone(10, 67, 45, [&]() -> Triangle {
    const auto far = [&] { return random.uniform(-16000.f, 16000.f); };
    const float x = far();
    const float y = far();
    const Vertex first = random.vertex(x, y);
    const Vertex opposite = random.vertex(67 - x, 45 - y);  // seen from the frame's middle
    const float third_y = far();
    return random.any_order({first, opposite, random.vertex(far(), third_y)});
  });
}

std::vector<Scene> lone_midgets() {
  Random random(44);
  return each_alone(20, 5, 5, [&]() -> Triangle {
    const auto corner = [&] {
      const float y = random.uniform(1.f, 4.f);
      return random.vertex(random.uniform(1.f, 4.f), y);
    };
    return {corner(), corner(), corner()};
  });
}

const std::vector<Frame>& frames() {
  static const std::vector<Frame> all = all_frames();
  return all;
}

Scene frame(const std::string& name) {
  for (const Frame& candidate : frames()) {
    if (candidate.name == name) return candidate.scene;
  }
  throw std::invalid_argument("no frame " + name);
}

}  // namespace pineda::test
