// Hard cases of values and of order: depth, colours, the depth test, the near plane.
#include <algorithm>

#include "model/scene/hard/draw.h"

namespace pineda::scene::hard {
namespace {

using spec::DepthFunc;

constexpr spec::FrameState kNearPlaneFrame = frame(96, 64);

// Needles 100 to 8000 px long and 1/16 to 2 px wide, through the frame.
std::vector<ScreenTriangle> needles() {
  Drawing d(21);
  for (int i = 0; i < 32; ++i) {
    const int64_t length = d.random().between(100, i % 2 == 0 ? 1000 : 8000) * kPx;
    const int64_t width = d.random().between(kPx / 16, 2 * kPx);
    const int64_t across = d.random().between(-length / 2, length / 2);
    const int before = d.random().between(1, 15);  // sixteenths of the length
    const figures::Needle needle{length, across, width, d.coin()};
    const Point q = d.in_box({4 * kPx, 4 * kPx}, {60 * kPx, 44 * kPx});
    d.add_shuffled(needle.from(q - before * (needle.along() / 16)));
  }
  return d.triangles();
}

// Triangles in one plane. z = n/256 snaps exactly to n*(2^24 - 1) units of 2^-8 codes, and with
// corners on whole pixels the plane's coefficients are whole units too. The first triangle contains
// the others.
std::vector<ScreenTriangle> coplanar() {
  Drawing d(22);
  constexpr figures::WholePlane kPlane{16, 1, 2};
  const auto on_plane = [&](Point pixel) {
    ScreenVertex v = d.vertex(kPx * pixel);
    v.z = static_cast<float>(kPlane.at(pixel)) / 256;
    return v;
  };
  const auto [a, b, c] = figures::right_angle({0, 0}, 64);
  d.add_shuffled({on_plane(a), on_plane(b), on_plane(c)});
  for (int i = 0; i < 32; ++i) {
    std::array<ScreenVertex, 3> v;
    for (ScreenVertex& corner : v) {
      const int x = d.random().between(0, 64);
      corner = on_plane({x, d.random().between(0, 64 - x)});
    }
    d.add_shuffled(v);
  }
  return d.triangles();
}

// In each cell one triangle three times, each with another first vertex and another colour.
std::vector<ScreenTriangle> equal_depth() {
  Drawing d(23);
  for (int i = 0; i < 12; ++i) {
    const Point origin = cell(i, 4);
    std::array<ScreenVertex, 3> v;
    for (ScreenVertex& corner : v) {
      corner = d.vertex(origin + d.in_box({0, 0}, {kCellPx * kPx, kCellPx * kPx}));
    }
    for (int copy = 0; copy < 3; ++copy) {
      const auto rgba = d.color();
      for (ScreenVertex& corner : v) corner.rgba = rgba;
      d.add_shuffled(v);
    }
  }
  return d.triangles();
}

// Sixteen rounds of a large far triangle, which keeps traversal busy while setup works ahead, and
// then eight small triangles inside one stamp, whose stamps thus come in consecutive cycles. There
// are few depths, so that many are equal.
std::vector<ScreenTriangle> back_to_back() {
  Drawing d(24);
  for (int i = 0; i < 16; ++i) {
    const Point corner = d.in_box({0, 0}, {4 * kPx, 4 * kPx});
    const int far = d.random().between(12, 15);
    d.add_flat(figures::right_angle(corner, 28 * kPx), static_cast<float>(far) / 16);
    const Point stamp = 2 * kPx * d.in_box({0, 0}, {13, 13});
    for (int k = 0; k < 8; ++k) {
      const Point a = stamp + d.in_box({0, 0}, {kPx, kPx});
      const Point b = stamp + d.in_box({kPx, 0}, {2 * kPx, kPx});
      const Point c = stamp + d.in_box({0, kPx}, {2 * kPx, 2 * kPx});
      d.add_flat({a, b, c}, static_cast<float>(d.random().between(1, 11)) / 16);
    }
  }
  return d.triangles();
}

// One triangle per pixel, each of a constant depth m/2^24 in [1/2, 1], including both ends.
std::vector<ScreenTriangle> depth_near_one() {
  Drawing d(25);
  for (int i = 0; i < 512; ++i) {
    const Point corner = d.center(i % 32, i / 32) - Point{100, 100};
    const int m = i == 0 ? 1 << 23 : i == 1 ? 1 << 24 : d.random().between(1 << 23, 1 << 24);
    d.add_flat(figures::right_angle(corner, 220), static_cast<float>(m) * 0x1p-24f);
  }
  return d.triangles();
}

// Triangles with w from 1 to 4, 64, 1000 and 10^6.
std::vector<ScreenTriangle> perspective() {
  Drawing d(26);
  for (const float ratio : {4.f, 64.f, 1e3f, 1e6f}) {
    for (int i = 0; i < 4; ++i) {
      std::array<ScreenVertex, 3> v;
      for (ScreenVertex& corner : v) corner = d.vertex(d.in_box({0, 0}, {64 * kPx, 48 * kPx}));
      v[0].w = ratio;
      v[1].w = d.random().uniform(1, ratio);
      d.add_shuffled(v);
    }
  }
  return d.triangles();
}

// A ground plane below the eye, in strips along the viewing direction. Each strip is two quads: one
// from behind the eye to just in front of it, one from there to the horizon.
Mesh plain() {
  constexpr uint32_t kColumns = 65;
  spec::Random random(27);
  Mesh mesh;
  for (uint32_t i = 0; i < 3 * kColumns; ++i) {
    static constexpr std::array<double, 3> kRowZ{3, -.3, -20};
    const double x = .03 * (i % kColumns) - .96;
    const double z = kRowZ[i / kColumns];
    mesh.position.push_back({x + static_cast<double>(random.uniform(-.01f, .01f)), 0,
                             z + .2 * z * static_cast<double>(random.uniform(-1, 1))});
    mesh.normal.push_back({0, 1, 0});
    const uint64_t bits = random.bits();
    mesh.color.push_back({static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
                          static_cast<uint8_t>(bits >> 16), 255});
    if (i < kColumns || i % kColumns == 0) continue;
    mesh.triangle.push_back({i, i - 1, i - kColumns});
    mesh.triangle.push_back({i - kColumns - 1, i - kColumns, i - 1});
  }
  return mesh;
}

std::vector<ScreenTriangle> near_plane() {
  return seen_mesh(plain(), {{0, .05, 0}, {0, 0, -.07}, {0, 1, 0}, 60}, kNearPlaneFrame);
}

}  // namespace

std::vector<HardCase> value_cases() {
  return {
      {"needles", "100 to 8000 px long, 1/16 to 2 px wide",
       "depth and colours within the design's bounds: no term grows as the area shrinks",
       frame(64, 48), needles},
      {"coplanar", "triangles inside another one, on the same plane",
       "depths equal to within the bound: a code apart at the most",
       frame(64, 64, DepthFunc::kLequal), coplanar},
      {"equal_depth_less", "the same triangle three times, its vertices in any order; depth less",
       "the first stays; depths are bit-identical", frame(64, 48), equal_depth},
      {"equal_depth_lequal", "the same with depth lequal",
       "the last one shows; depths are bit-identical", frame(64, 48, DepthFunc::kLequal),
       equal_depth},
      {"back_to_back", "triangles on the same stamp in consecutive cycles",
       "each sees the depth of the one before: the nearest is left, the first among equals",
       frame(32, 32), back_to_back},
      {"near_plane", "a plain cut by the near plane and the guard band, as clipping leaves it",
       "every sample of the frame is hit exactly once", kNearPlaneFrame, near_plane},
      {"depth_near_one", "depths that are floats from 1/2 to 1, one a sample",
       "codes rounded from z*(2^24 - 1); in binary32 about half would be wrong",
       frame(32, 16, DepthFunc::kLequal), depth_near_one},
      {"perspective", "W ratios of 4 to 10^6 within a triangle",
       "within the design's bounds, whatever the ratio", frame(64, 48), perspective},
  };
}

}  // namespace pineda::scene::hard
