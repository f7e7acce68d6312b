// Hard cases of perspective: attributes of triangles whose vertices' w differ greatly.
#include "model/scene/hard/draw.h"

namespace pineda::scene::hard {
namespace {

constexpr spec::FrameState kFrame = frame(64, 48);

// A triangle of the frame's size, a needle, one around the whole frame, one of a few pixels, or a
// sliver through a sample.
Corners shape(Drawing& d, int kind) {
  const Point sample = d.center_in_box({8, 8}, {55, 39});
  switch (kind) {
    case 0:
    case 1:
      return figures::within(d, {0, 0}, {64 * kPx, 48 * kPx});
    case 2: {
      const Point along = d.near({0, 0}, 800 * kPx);
      return {sample - along, sample + along, sample + along + d.near({0, 0}, kPx)};
    }
    case 3: {
      const Point a = d.in_box({-900 * kPx, -900 * kPx}, {-300 * kPx, -100 * kPx});
      const Point b = d.in_box({400 * kPx, -900 * kPx}, {900 * kPx, -100 * kPx});
      return {a, b, d.in_box({-300 * kPx, 300 * kPx}, {300 * kPx, 900 * kPx})};
    }
    case 4:
      return figures::around(d, sample, 3 * kPx);
    default: {
      const Point along = d.near({0, 0}, 40 * kPx);
      return {sample + along, sample - along + Point{2, 0}, sample - along - Point{2, 0}};
    }
  }
}

// Triangles whose greatest w is `Ratio` times the least one, at any scale; the third w is close to
// the least, random, or close to the greatest. Every fourth triangle spans the whole range of each
// colour.
template <int Ratio>
std::vector<ScreenTriangle> ratio() {
  Drawing d(30 + Ratio);
  for (int i = 0; i < 30; ++i) {
    const auto p = shape(d, i % 6);
    std::array<ScreenVertex, 3> v;
    for (size_t k = 0; k < 3; ++k) v[k] = d.vertex(p[k]);
    const float scale = d.random().uniform(.01f, 100);
    const int kind = d.random().between(0, 2);
    v[0].w = scale;
    v[1].w = scale * (kind == 0   ? d.random().uniform(1, 2)
                      : kind == 1 ? d.random().uniform(1, Ratio)
                                  : d.random().uniform(.5f, 1) * Ratio);
    v[2].w = scale * Ratio;
    if (i % 4 == 0) {
      v[0].rgba = {0, 255, 0, 255};
      v[1].rgba = {255, 0, 128, 0};
      v[2].rgba = {255, 0, 255, 0};
    }
    d.add_shuffled(v);
  }
  return d.triangles();
}

// Triangles with one vertex just beyond the near plane, beside the frame, and two far away, whose w
// is 10 to 1000 times greater. Nothing is clipped.
Mesh before_near_plane() {
  spec::Random random(40);
  Mesh mesh;
  const auto add = [&](double distance, float reach) {
    const double x = static_cast<double>(random.uniform(-reach, reach));
    const double y = static_cast<double>(random.uniform(-reach, reach));
    mesh.position.push_back({x * distance, y * distance, -distance});
    mesh.normal.push_back({0, 0, 1});
    const uint64_t bits = random.bits();
    mesh.color.push_back({static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
                          static_cast<uint8_t>(bits >> 16), 255});
  };
  for (uint32_t i = 0; i < 24; ++i) {
    add(.1 * (1 + .001 * static_cast<double>(random.uniform(0, 1))), 4);
    add(static_cast<double>(random.uniform(1, 100)), .6f);
    add(static_cast<double>(random.uniform(1, 100)), .6f);
    mesh.triangle.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

std::vector<ScreenTriangle> near_plane_vertex() {
  return seen_mesh(before_near_plane(), {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60}, kFrame);
}

}  // namespace

std::vector<HardCase> perspective_cases() {
  constexpr const char* kRight = "with perspective within the bounds, whatever the ratio";
  return {
      {"perspective_ratio_4", "W up to 4 times another of the triangle, in six shapes", kRight,
       kFrame, ratio<4>},
      {"perspective_ratio_64", "W up to 64 times another", kRight, kFrame, ratio<64>},
      {"perspective_ratio_1e3", "W up to 1000 times another", kRight, kFrame, ratio<1000>},
      {"perspective_ratio_1e6", "W up to 10^6 times another", kRight, kFrame, ratio<1000000>},
      {"near_plane_vertex", "one vertex just before the near plane, the others far away",
       "with perspective within the bounds; nothing is cut", kFrame, near_plane_vertex},
  };
}

}  // namespace pineda::scene::hard
