#include "bench/scenes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/scene/scene.h"
#include "model/spec/random.h"

namespace pineda::bench {
namespace {

using scene::ScreenTriangle;
using scene::ScreenVertex;

struct Point {
  double x, y;
};
using Corners = std::array<Point, 3>;

struct RandomScene {
  const char* name;
  uint32_t triangles;
  double area_px;  // of each; 0: from kLeastOfFrame of the frame to half of it
  uint64_t seed;
};
constexpr RandomScene kRandomScenes[] = {
    {"px1", 1'000'000, 1, 1},
    {"px10", 1'000'000, 10, 2},
    {"px1000", 20'000, 1000, 3},
    {"screen", 200, 0, 4},
};
constexpr const char* kBunny = "bunny";
constexpr const char* kBunnyFile = "/usr/share/glmark2/models/bunny.obj";

constexpr double kLeastOfFrame = .35;
constexpr double kLeastArea = .25;  // of the longest side's square: no slivers
constexpr double kDepths = 0x1p24;

double area_of(const Corners& c) {
  return std::abs((c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y)) /
         2;
}

double square_of_longest_side(const Corners& c) {
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Point& from = c[i];
    const Point& to = c[(i + 1) % 3];
    const double dx = to.x - from.x, dy = to.y - from.y;
    longest = std::max(longest, dx * dx + dy * dy);
  }
  return longest;
}

// Three points of a rectangle at the origin.
Corners draw_corners(spec::Random* random, double width, double height) {
  Corners corners;
  for (Point& corner : corners) {
    corner.x = random->unit() * width;
    corner.y = random->unit() * height;
  }
  return corners;
}

// No sliver, of this area, somewhere in the frame.
Corners draw_small(spec::Random* random, double area_px) {
  Corners corners;
  do {
    corners = draw_corners(random, 1, 1);
  } while (area_of(corners) < kLeastArea * square_of_longest_side(corners));
  const double scale = std::sqrt(area_px / area_of(corners));
  const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const double x = random->unit() * (kWidth - scale * (right - left));
  const double y = random->unit() * (kHeight - scale * (bottom - top));
  for (Point& corner : corners) {
    corner = {x + scale * (corner.x - left), y + scale * (corner.y - top)};
  }
  return corners;
}

Corners draw_large(spec::Random* random) {
  Corners corners;
  do {
    corners = draw_corners(random, kWidth, kHeight);
  } while (area_of(corners) < kLeastOfFrame * kWidth * kHeight);
  return corners;
}

// The nearest multiple of 1/steps.
float on_grid(double value, double steps) {
  return static_cast<float>(std::floor(value * steps + .5) / steps);
}
float depth_on_grid(double z) {
  return static_cast<float>(std::clamp(std::floor(z * kDepths + .5), 0., kDepths - 1) / kDepths);
}

// A small triangle's depths differ little.
std::array<double, 3> draw_depths(spec::Random* random, bool small) {
  const double middle = .05 + .9 * random->unit();
  std::array<double, 3> depths{};
  for (double& depth : depths) {
    const double other = random->unit();
    depth = small ? middle + .04 * (other - .5) : other;
  }
  return depths;
}

std::vector<ScreenTriangle> draw(const RandomScene& scene, double subpixels) {
  spec::Random random(scene.seed);
  const bool small = scene.area_px > 0;
  std::vector<ScreenTriangle> triangles(scene.triangles);
  for (uint32_t id = 0; id < scene.triangles; ++id) {
    const Corners corners = small ? draw_small(&random, scene.area_px) : draw_large(&random);
    const auto depths = draw_depths(&random, small);
    triangles[id].id = id;
    for (size_t i = 0; i < 3; ++i) {
      ScreenVertex& v = triangles[id].v[i];
      v.x = on_grid(corners[i].x, subpixels);
      v.y = on_grid(corners[i].y, subpixels);
      v.z = depth_on_grid(depths[i]);
      const uint64_t color = random.bits();
      for (size_t c = 0; c < 3; ++c) v.rgba[c] = static_cast<uint8_t>(color >> (8 * c));
      v.rgba[3] = 255;
    }
  }
  return triangles;
}

std::vector<ScreenTriangle> read_mesh(const spec::Contract& contract, const std::string& file,
                                      double subpixels) {
  scene::Options options;
  options.size = scene::Size{kWidth, kHeight};
  const scene::Scene mesh = scene::open_scene(contract, file, options);
  if (mesh.mesh == nullptr) throw scene::InputError(file, "expected a mesh");
  std::vector<ScreenTriangle> triangles;
  for (spec::Triangle triangle; mesh.source->next(&triangle);) {
    ScreenTriangle stated = mesh.source->screen();
    for (size_t i = 0; i < 3; ++i) {
      ScreenVertex& v = stated.v[i];
      v.x = static_cast<float>(triangle.v[i].x / subpixels);
      v.y = static_cast<float>(triangle.v[i].y / subpixels);
      v.z = depth_on_grid(v.z);
      v.w = 1;
    }
    triangles.push_back(stated);
  }
  if (triangles.empty()) throw scene::InputError(file, "expected triangles, found none");
  return triangles;
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const RandomScene& scene : kRandomScenes) all.emplace_back(scene.name);
    all.emplace_back(kBunny);
    return all;
  }();
  return names;
}

std::string file_of(const std::string& scene) {
  if (scene == kBunny) return kBunnyFile;
  const auto is_it = [&](const RandomScene& random) { return scene == random.name; };
  return std::any_of(std::begin(kRandomScenes), std::end(kRandomScenes), is_it) ? "" : scene;
}

std::vector<ScreenTriangle> triangles_of(const spec::Contract& contract, const std::string& scene) {
  const double subpixels = 1 << contract.design.subpixel_bits;
  for (const RandomScene& random : kRandomScenes) {
    if (scene == random.name) return draw(random, subpixels);
  }
  return read_mesh(contract, file_of(scene), subpixels);
}

spec::FrameState frame_state() {
  spec::FrameState state;
  state.width = kWidth;
  state.height = kHeight;
  return state;
}

fast::TriangleList snapped(const spec::Contract& contract,
                           const std::vector<ScreenTriangle>& triangles) {
  scene::SnappedSource source(contract, std::make_unique<scene::ListReader>(triangles));
  fast::TriangleList all(contract, frame_state());
  for (spec::Triangle triangle; source.next(&triangle);) all.push_back(triangle);
  return all;
}

}  // namespace pineda::bench
