#include "tests/studies/judge/closed_meshes.h"

#include <cmath>

#include "model/scene/polygons/triangulate.h"

namespace pineda::studies {
namespace {

using scene::Mesh;
using scene::PolygonCutter;

void color(Mesh* mesh) {
  spec::Random random(mesh->position.size());
  mesh->normal.assign(mesh->position.size(), {0, 0, 1});
  for (size_t i = 0; i < mesh->position.size(); ++i) {
    const uint64_t bits = random.bits();
    mesh->color.push_back({static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
                           static_cast<uint8_t>(bits >> 16), 255});
  }
}

/// Two copies of an outline, one behind the other, and the sides between them.
Mesh prism(const std::vector<std::array<double, 2>>& outline, double half_height) {
  Mesh mesh;
  const auto n = static_cast<uint32_t>(outline.size());
  for (const double z : {half_height, -half_height}) {
    for (const auto& p : outline) mesh.position.push_back({p[0], p[1], z});
  }
  PolygonCutter cutter(&mesh);
  std::vector<uint32_t> front, back;
  for (uint32_t i = 0; i < n; ++i) {
    front.push_back(i);
    back.push_back(2 * n - 1 - i);
  }
  cutter.add(front.data(), n);
  cutter.add(back.data(), n);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t j = (i + 1) % n;
    const std::array<uint32_t, 4> side = {j, i, n + i, n + j};
    cutter.add(side.data(), 4);
  }
  color(&mesh);
  return mesh;
}

Mesh star_prism() {
  // Multiples of 2^-8, so that all sides are planes to the last bit.
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i < 14; ++i) {
    const double radius = i % 2 == 0 ? 1 : .375;
    const double angle = 2 * M_PI * i / 14;
    outline.push_back({std::nearbyint(256 * radius * std::cos(angle)) / 256,
                       std::nearbyint(256 * radius * std::sin(angle)) / 256});
  }
  return prism(outline, .25);
}

/// A closed surface of triangles over a grid of two angles.
template <class Point>
Mesh torus(uint32_t rows, uint32_t columns, Point point) {
  Mesh mesh;
  for (uint32_t i = 0; i < rows; ++i) {
    for (uint32_t j = 0; j < columns; ++j) {
      mesh.position.push_back(point(2 * M_PI * i / rows, 2 * M_PI * j / columns));
      const uint32_t down = (i + 1) % rows * columns, here = i * columns, right = (j + 1) % columns;
      mesh.triangle.push_back({here + j, down + j, down + right});
      mesh.triangle.push_back({here + j, down + right, here + right});
    }
  }
  color(&mesh);
  return mesh;
}

Mesh ring(double spread, uint64_t seed) {
  spec::Random random(seed);
  return torus(12, 9, [&](double a, double b) {
    const double thick = .35 * (1 + static_cast<double>(random.uniform(0, 1)) * spread);
    const double radius = .65 + thick * std::cos(b);
    return scene::Vec3{radius * std::cos(a), radius * std::sin(a), thick * std::sin(b)};
  });
}

}  // namespace

std::vector<ClosedMesh> closed_meshes() {
  return {{"cube", prism({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 1)},
          {"star", star_prism()},
          {"torus", ring(0, 1)},
          {"rough torus", ring(1.5, 2)}};
}

scene::Camera random_camera(spec::Random* random) {
  const auto number = [&](float low, float high) {
    return static_cast<double>(random->uniform(low, high));
  };
  scene::Camera camera;
  const double reach = std::exp2(number(-3, 3));
  for (size_t i = 0; i < 3; ++i) camera.eye[i] = reach * number(-1, 1);
  for (size_t i = 0; i < 3; ++i) camera.target[i] = number(-1, 1);
  for (size_t i = 0; i < 3; ++i) camera.up[i] = number(-1, 1);
  camera.fovy_deg = random->bits() % 3 == 0 ? number(170, 178) : number(5, 178);
  return camera;
}

}  // namespace pineda::studies
