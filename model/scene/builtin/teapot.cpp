#include <utility>

#include "model/scene/builtin/builtin.h"

namespace pineda::scene {
namespace {

// Martin Newell's teapot (1975), with his coordinates, z up. Surfaces of revolution are stored as a
// profile (radius, height), mirrored ones as one half.
using Profile = std::array<std::array<double, 2>, 4>;
using Patch = std::array<std::array<Vec3, 4>, 4>;  // [v][u]

// Two profiles of the lid, from its middle outwards; four from the rim down to the middle of the
// bottom.
constexpr std::array<Profile, 6> kProfiles = {{
    {{{0, 3.15}, {.8, 3.15}, {0, 2.85}, {.2, 2.7}}},
    {{{.2, 2.7}, {.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},
    {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, .9}}},
    {{{2, .9}, {2, .45}, {1.5, .225}, {1.5, .15}}},
    {{{1.5, .15}, {1.5, .075}, {1.425, 0}, {0, 0}}},
}};

// The control points that make a cubic a quarter circle: Newell used .56 (and .5625 in one row, at
// the knob).
constexpr double kQuarter = .56;

// Half of a tube's cross-section: a cubic from `first` to `second` in the plane y = 0, whose inner
// control points have y = width.
struct Section {
  double width;
  std::array<double, 2> first, second;  // x, z
};
using Tube = std::array<Section, 7>;  // two patches that share the middle section

constexpr Tube kHandle = {{{.3, {-1.6, 2.025}, {-1.5, 2.25}},
                           {.3, {-2.3, 2.025}, {-2.5, 2.25}},
                           {.3, {-2.7, 2.025}, {-3, 2.25}},
                           {.3, {-2.7, 1.8}, {-3, 1.8}},
                           {.3, {-2.7, 1.575}, {-3, 1.35}},
                           {.3, {-2.5, 1.125}, {-2.65, .9375}},
                           {.3, {-2, .9}, {-1.9, .6}}}};

constexpr Tube kSpout = {{{.66, {1.7, 1.425}, {1.7, .6}},
                          {.66, {2.6, 1.425}, {3.1, .825}},
                          {.25, {2.3, 2.1}, {2.4, 2.025}},
                          {.25, {2.7, 2.4}, {3.3, 2.4}},
                          {.25, {2.8, 2.475}, {3.525, 2.49375}},
                          {.15, {2.9, 2.475}, {3.45, 2.5125}},
                          {.15, {2.8, 2.4}, {3.2, 2.4}}}};

Vec3 y_up(double x, double y, double z) { return {x, z, -y}; }

// A quarter of a surface of revolution, rotated by quarter turns. These are exact, so that adjacent
// patches share their edge bit for bit.
Patch round_patch(const Profile& profile, int quarter_turns) {
  Patch patch;
  for (size_t v = 0; v < 4; ++v) {
    const double r = profile[v][0];
    const double k = kQuarter * r;
    const std::array<std::array<double, 2>, 4> arc = {{{r, 0}, {r, k}, {k, r}, {0, r}}};
    for (size_t u = 0; u < 4; ++u) {
      double x = arc[u][0], y = arc[u][1];
      for (int i = 0; i < quarter_turns; ++i) {
        const double turned = -y;
        y = x;
        x = turned;
      }
      patch[v][u] = y_up(x, y, profile[v][1]);
    }
  }
  return patch;
}

// One of a tube's four patches: the side y > 0 or y < 0, and the half that starts at section
// `first`.
Patch tube_patch(const Tube& tube, size_t first, double side) {
  Patch patch;
  for (size_t v = 0; v < 4; ++v) {
    const Section& section = tube[first + v];
    const auto& [x0, z0] = section.first;
    const auto& [x1, z1] = section.second;
    const double y = side * section.width;
    patch[v] = {y_up(x0, 0, z0), y_up(x0, y, z0), y_up(x1, y, z1), y_up(x1, 0, z1)};
  }
  return patch;
}

using Weights = std::array<double, 4>;

// Exactly (1, 0, 0, 0) at t = 0 and (0, 0, 0, 1) at t = 1, so the edge of a patch depends only on
// the control points of that edge.
Weights bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}
Weights bernstein_slope(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t};
}

Vec3 evaluate(const Patch& patch, const Weights& v, const Weights& u) {
  Vec3 sum{};
  for (size_t i = 0; i < 4; ++i) {
    Vec3 row{};
    for (size_t j = 0; j < 4; ++j) row = row + u[j] * patch[i][j];
    sum = sum + v[i] * row;
  }
  return sum;
}

// At a pole, where an edge of the patch is one point, returns that control point: evaluating would
// give several points that differ by rounding.
Vec3 position_at(const Patch& patch, double v, double u) {
  if (v == 0 && patch[0][0] == patch[0][3]) return patch[0][0];
  if (v == 1 && patch[3][0] == patch[3][3]) return patch[3][0];
  return evaluate(patch, bernstein(v), bernstein(u));
}

Vec3 normal_at(const Patch& patch, double v, double u) {
  // At a pole the derivative along u is 0. The normal a small step away is close enough for
  // shading.
  constexpr double kStep = 1e-5;
  for (const double at : {v, v < .5 ? v + kStep : v - kStep}) {
    const Vec3 n = cross(evaluate(patch, bernstein_slope(at), bernstein(u)),
                         evaluate(patch, bernstein(at), bernstein_slope(u)));
    if (length(n) > 1e-9) return normalized(n);
  }
  return {};
}

// `side` = -1 reverses the orientation, for a mirrored patch.
void append(const Patch& patch, int n, double side, Mesh* mesh) {
  const auto base = static_cast<uint32_t>(mesh->position.size());
  const auto row = static_cast<uint32_t>(n + 1);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double v = static_cast<double>(i) / n, u = static_cast<double>(j) / n;
      mesh->position.push_back(position_at(patch, v, u));
      mesh->normal.push_back(side * normal_at(patch, v, u));
    }
  }
  const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
    const auto& p = mesh->position;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;  // no area: at a pole
    if (side < 0) std::swap(b, c);
    mesh->triangle.push_back({a, b, c});
  };
  for (uint32_t i = 0; i + 1 < row; ++i) {
    for (uint32_t j = 0; j + 1 < row; ++j) {
      const uint32_t corner = base + i * row + j;
      add(corner, corner + row, corner + row + 1);
      add(corner, corner + row + 1, corner + 1);
    }
  }
}

}  // namespace

Mesh teapot(int n) {
  Mesh mesh;
  for (const Profile& profile : kProfiles) {
    for (int turn = 0; turn < 4; ++turn) append(round_patch(profile, turn), n, 1, &mesh);
  }
  for (const Tube* tube : {&kHandle, &kSpout}) {
    for (const size_t first : {size_t{0}, size_t{3}}) {
      for (const double side : {1.0, -1.0}) append(tube_patch(*tube, first, side), n, side, &mesh);
    }
  }
  return mesh;
}

}  // namespace pineda::scene
