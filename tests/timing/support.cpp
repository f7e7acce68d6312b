#include "tests/timing/support.h"

#include <algorithm>
#include <random>

#include "model/spec/random.h"

namespace pineda::test {

namespace {

class Random : public spec::RandomFrom<std::mt19937_64> {
 public:
  using RandomFrom::RandomFrom;
  int32_t near(int64_t center, int64_t radius) {
    return static_cast<int32_t>(between(center - radius, center + radius));
  }
};

void randomize_values(Random* random, spec::Triangle* t) {
  const int64_t far = ((int64_t{1} << spec::kHighTile.depth_bits) - 1)
                      << spec::kDepthInputFractionBits;
  for (spec::Vertex& v : t->v) {
    v.z = random->between(0, far);
    for (size_t a = 0; a < static_cast<size_t>(spec::kHighTile.attributes); ++a) {
      v.attr[a] = static_cast<int32_t>(random->between(0, 255));
    }
  }
}

// Places the corners within `reach` subpixels of a point of the frame.
void scatter(Random* random, const spec::FrameState& frame, int64_t reach, spec::Triangle* t) {
  const int64_t x = random->between(0, frame.width * kPx);
  const int64_t y = random->between(0, frame.height * kPx);
  for (spec::Vertex& v : t->v) {
    v.x = random->near(x, reach);
    v.y = random->near(y, reach);
  }
}

void needle(Random* random, const spec::FrameState& frame, spec::Triangle* t) {
  scatter(random, frame, 200 * kPx, t);
  t->v[1].x = random->near(t->v[0].x, 2 * kPx);
  t->v[1].y = random->near(t->v[0].y, 2 * kPx);
}

spec::Triangle random_triangle(Random* random, const spec::FrameState& frame, Kind kind) {
  spec::Triangle t;
  switch (kind) {
    case Kind::kSmall:
      scatter(random, frame, 3 * kPx, &t);
      break;
    case Kind::kMedium:
      scatter(random, frame, 20 * kPx, &t);
      break;
    case Kind::kHuge:
      scatter(random, frame, 16000 * kPx, &t);
      break;
    case Kind::kNeedles:
      needle(random, frame, &t);
      break;
    case Kind::kOneStamp:
      scatter(random, {8, 4}, 2 * kPx, &t);
      break;
    case Kind::kOneStack:
      t = flat_triangle(-1, -1, 2 * frame.width + 2, -1, -1, 2 * frame.height + 2);
      break;
    case Kind::kMixed:
      return random_triangle(random, frame, kKinds[random->between(0, 5)]);
  }
  randomize_values(random, &t);
  return t;
}

// The raster state that units look at besides size, cull and the common depth functions.
void randomize_state(Random* random, spec::FrameState* frame) {
  if (random->between(0, 2) == 0)
    frame->depth = static_cast<spec::DepthFunc>(random->between(0, 8));
  frame->depth_write = random->between(0, 3) != 0;
  if (random->between(0, 3) == 0) {
    frame->scissor_x0 = static_cast<int>(random->between(0, frame->width / 2));
    frame->scissor_y1 = static_cast<int>(random->between(frame->height / 2, frame->height));
  }
  if (random->between(0, 1) == 0)
    frame->bias_slope = static_cast<int32_t>(random->between(-600, 600));
  if (random->between(0, 2) == 0)
    frame->clear_depth = static_cast<double>(random->between(0, 4)) / 4;
}

// Converts from the formats of the default design to those of another; 1/w in any ratio.
void fit(Random* random, const spec::Contract& contract, spec::Triangle* t) {
  const spec::Design& d = contract.design;
  const int finer = spec::kHighTile.subpixel_bits - d.subpixel_bits;
  const int32_t limit = 1 << (d.guard_bits + d.subpixel_bits);
  for (spec::Vertex& v : t->v) {
    v.x = std::clamp(v.x >> finer, -limit, limit - 1);
    v.y = std::clamp(v.y >> finer, -limit, limit - 1);
    v.z >>= spec::kHighTile.depth_bits - d.depth_bits;
    if (!d.perspective) continue;
    const int64_t half = int64_t{1} << (d.inverse_w_bits - 1);
    v.inverse_w = static_cast<int32_t>(random->between(half, 2 * half - 1));
    v.inverse_w_shift = &v == &t->v[0] ? 0 : static_cast<int32_t>(random->between(0, 20));
  }
}

}  // namespace

timing::Pull pull_from(const Scene& scene) {
  return [&scene, i = size_t{0}](spec::Triangle* t) mutable {
    if (i == scene.triangles.size()) return false;
    *t = scene.triangles[i++];
    return true;
  };
}

spec::Triangle flat_triangle(int x0, int y0, int x1, int y1, int x2, int y2, int64_t z) {
  spec::Triangle t;
  const std::array<std::array<int, 2>, 3> corners{{{x0, y0}, {x1, y1}, {x2, y2}}};
  for (size_t i = 0; i < 3; ++i) {
    t.v[i].x = corners[i][0] * kPx;
    t.v[i].y = corners[i][1] * kPx;
    t.v[i].z = z << spec::kDepthInputFractionBits;
  }
  return t;
}

const char* kind_name(Kind kind) {
  static constexpr const char* kNames[] = {"Small",    "Medium",   "Huge", "Needles",
                                           "OneStamp", "OneStack", "Mixed"};
  return kNames[static_cast<int>(kind)];
}

Scene random_scene(Kind kind, uint64_t seed, int triangles, const spec::Contract& contract) {
  Random random(seed);
  Scene scene;
  scene.frame.width = static_cast<int>(random.between(1, 150));
  scene.frame.height = static_cast<int>(random.between(1, 90));
  // Mostly no culling: a scene of dropped triangles says little.
  scene.frame.cull = static_cast<spec::Cull>(std::max<int64_t>(random.between(-2, 2), 0));
  scene.frame.depth = static_cast<spec::DepthFunc>(random.between(0, 2));
  for (int i = 0; i < triangles; ++i) {
    scene.triangles.push_back(random_triangle(&random, scene.frame, kind));
    scene.triangles.back().id = static_cast<uint32_t>(i);
  }
  randomize_state(&random, &scene.frame);
  for (spec::Triangle& t : scene.triangles) fit(&random, contract, &t);
  return scene;
}

std::string difference(const Record& expected, const Record& got, bool with_cycles,
                       const spec::Contract& contract) {
  for (const std::string& text : {difference(expected.prims, got.prims, with_cycles, contract),
                                  difference(expected.stamps, got.stamps, with_cycles, contract),
                                  difference(expected.depths, got.depths, with_cycles, contract),
                                  difference(expected.colors, got.colors, with_cycles, contract)}) {
    if (!text.empty()) return text;
  }
  return {};
}

}  // namespace pineda::test
