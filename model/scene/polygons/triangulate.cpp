#include "model/scene/polygons/triangulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/scene/polygons/ears.h"
#include "model/scene/polygons/winding.h"

namespace pineda::scene {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Greater than any error from the underflow of a product.
constexpr double kUnderflow = 1e-300;

// A vector in doubles, with an error bound for each component.
struct Near {
  Vec3 value{};
  Vec3 error{};
};

// The Newell normal.
Near near_normal(const std::vector<Vec3>& corner) {
  Near near;
  Vec3 magnitude{};
  for (size_t i = 1; i + 1 < corner.size(); ++i) {
    // b is an edge, not a second vector from corner 0: smaller products have smaller errors.
    const Vec3 a = corner[i] - corner[0], b = corner[i + 1] - corner[i];
    for (size_t k = 0; k < 3; ++k) {
      const size_t x = (k + 1) % 3, y = (k + 2) % 3;
      const double left = a[x] * b[y], right = a[y] * b[x];
      near.value[k] += left - right;
      magnitude[k] += std::abs(left) + std::abs(right);
    }
  }
  // Each term has half an epsilon of error for each factor, the product and the difference, and the
  // sum half an epsilon for each term. The rest covers the rounding of `magnitude` itself.
  const auto terms = static_cast<double>(corner.size() + 8);
  for (size_t k = 0; k < 3; ++k) near.error[k] = terms * (kEpsilon * magnitude[k] + kUnderflow);
  return near;
}

// n x w for a fixed w that is unlikely to be parallel or perpendicular to anything in a mesh.
Near across(const Near& n) {
  constexpr Vec3 kAskew{.6180339887, .2786204327, .7352941176};
  Near near;
  for (size_t k = 0; k < 3; ++k) {
    const size_t x = (k + 1) % 3, y = (k + 2) % 3;
    const double left = n.value[x] * kAskew[y], right = n.value[y] * kAskew[x];
    near.value[k] = left - right;
    near.error[k] = n.error[x] + n.error[y] + 2 * kEpsilon * (std::abs(left) + std::abs(right));
  }
  return near;
}

// The sign of a scalar product with a vector that is off by up to 2 epsilon of `magnitude`; 0 if
// doubles cannot tell.
int near_sign(const Near& near, const Vec3& other, const Vec3& magnitude) {
  double sum = 0, error = kUnderflow;
  for (size_t k = 0; k < 3; ++k) {
    const double size = std::abs(near.value[k]);
    sum += near.value[k] * other[k];
    error += (near.error[k] + 8 * kEpsilon * size) * magnitude[k] + kUnderflow * size;
  }
  if (!(std::abs(sum) > error) || !std::isfinite(sum)) return 0;
  return sum > 0 ? 1 : -1;
}

// The sign of n . ((b - a) x (c - b)).
int near_turn(const Near& n, const Vec3& ab, const Vec3& bc) {
  Vec3 product, magnitude;
  for (size_t k = 0; k < 3; ++k) {
    const size_t x = (k + 1) % 3, y = (k + 2) % 3;
    const double left = ab[x] * bc[y], right = ab[y] * bc[x];
    product[k] = left - right;
    magnitude[k] = std::abs(left) + std::abs(right);
  }
  return near_sign(n, product, magnitude);
}

// Counts how often the edges of a polygon change between ahead and back along a direction: for a
// convex polygon twice.
struct Reversals {
  bool first = false, last = false, has_first = false;
  int count = 0;
  void add(bool ahead) {
    if (!has_first) first = last = ahead;
    has_first = true;
    if (ahead != last) ++count;
    last = ahead;
  }
  bool are_two() const { return count + (first != last ? 1 : 0) == 2; }
};

// Is the polygon convex, with left turns only? Nothing if doubles cannot decide.
std::optional<bool> is_surely_convex(const std::vector<Vec3>& corner) {
  const size_t n = corner.size();
  const Near normal = near_normal(corner);
  const Near ahead = across(normal);
  Reversals reversals;
  bool is_sure = true;
  Vec3 before = corner[0] - corner[n - 1];
  for (size_t i = 0; i < n; ++i) {
    const Vec3 step = corner[i + 1 < n ? i + 1 : 0] - corner[i];
    const int turn = near_turn(normal, before, step);
    if (turn < 0) return false;
    is_sure = is_sure && turn > 0;
    before = step;
    if (!is_sure || n < 5) continue;  // fewer than five left turns cannot go around twice
    const int sign =
        near_sign(ahead, step, {std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
    is_sure = sign != 0;
    reversals.add(sign > 0);
  }
  if (!is_sure) return std::nullopt;
  return n < 5 || reversals.are_two();
}

bool is_convex(const PlanarPolygon& polygon) {
  // Leaves out corners that equal the one before.
  std::vector<uint32_t> corner;
  for (uint32_t i = 0; i < polygon.size(); ++i) {
    const uint32_t before = i > 0 ? i - 1 : polygon.size() - 1;
    if (polygon.place(i) != polygon.place(before)) corner.push_back(i);
  }
  Reversals reversals;
  const size_t n = corner.size();
  for (size_t i = 0; i < n; ++i) {
    const uint32_t a = corner[i > 0 ? i - 1 : n - 1], b = corner[i],
                   c = corner[i + 1 < n ? i + 1 : 0];
    const bool was_right = polygon.place(b) > polygon.place(a);
    const bool is_right = polygon.place(c) > polygon.place(b);
    const int turn = polygon.turn(a, b, c);
    if (turn < 0 || (turn == 0 && was_right != is_right)) return false;
    reversals.add(is_right);
  }
  return reversals.are_two();
}

PolygonShape add_fan(size_t corners, PolygonShape shape,
                     std::vector<std::array<uint32_t, 3>>* triangles) {
  for (uint32_t i = 2; i < corners; ++i) triangles->push_back({0, i - 1, i});
  return shape;
}

}  // namespace

PolygonShape triangulate(const std::vector<Vec3>& corner,
                         std::vector<std::array<uint32_t, 3>>* triangles) {
  const auto fan = [&](PolygonShape shape) { return add_fan(corner.size(), shape, triangles); };
  if (!std::all_of(corner.begin(), corner.end(), [](const Vec3& p) { return is_finite(p); })) {
    return fan(PolygonShape::kUnbounded);
  }
  const auto convex = is_surely_convex(corner);
  if (convex && *convex) return fan(PolygonShape::kConvex);
  const PlanarPolygon polygon(corner);
  if (!polygon.has_plane()) return fan(PolygonShape::kFlat);
  if (!convex && is_convex(polygon)) return fan(PolygonShape::kConvex);
  if (!winds_once(polygon)) return fan(PolygonShape::kCrossing);
  const EarCut ears = cut_ears(polygon, triangles);
  if (ears == EarCut::kDone) return PolygonShape::kSimple;
  return fan(ears == EarCut::kImpossible ? PolygonShape::kCrossing : PolygonShape::kUnknown);
}

void PolygonCutter::add(const uint32_t* vertex, size_t count) {
  const size_t first_triangle = mesh_->triangle.size();
  if (count == 3) {
    mesh_->triangle.push_back({vertex[0], vertex[1], vertex[2]});
    add_provoking(vertex[0], first_triangle);
    return;
  }
  corner_.clear();
  cut_.clear();
  for (size_t i = 0; i < count; ++i) corner_.push_back(mesh_->position[vertex[i]]);
  const PolygonShape shape = triangulate(corner_, &cut_);
  for (const auto& t : cut_) {
    mesh_->triangle.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
  }
  add_provoking(vertex[0], first_triangle);
  crossing_ += shape == PolygonShape::kCrossing ? 1 : 0;
  unknown_ += shape == PolygonShape::kUnknown ? 1 : 0;
  flat_ += shape == PolygonShape::kFlat ? 1 : 0;
  if (shape != PolygonShape::kConvex && shape != PolygonShape::kSimple) return;
  mesh_->polygon.push_back({static_cast<uint32_t>(mesh_->corner.size()),
                            static_cast<uint32_t>(count), static_cast<uint32_t>(first_triangle),
                            static_cast<uint32_t>(cut_.size())});
  mesh_->corner.insert(mesh_->corner.end(), vertex, vertex + count);
}

void PolygonCutter::add_provoking(uint32_t vertex, size_t first_triangle) {
  auto& provoking = mesh_->provoking;
  const auto& triangle = mesh_->triangle;
  if (provoking.empty()) {
    const bool are_first =
        std::all_of(triangle.begin() + static_cast<std::ptrdiff_t>(first_triangle), triangle.end(),
                    [&](const auto& t) { return t[0] == vertex; });
    if (are_first) return;
    for (size_t i = 0; i < first_triangle; ++i) provoking.push_back(triangle[i][0]);
  }
  provoking.resize(triangle.size(), vertex);
}

void PolygonCutter::warn(const std::string& file, std::vector<std::string>* warnings) const {
  const auto say = [&](uint64_t count, const char* what) {
    if (count > 0) warnings->push_back(fmt::format("{}: {} {}", file, count, what));
  };
  say(crossing_, "polygons cross themselves: cut as fans");
  say(unknown_,
      "polygons are too intricate, with more ways to cut them than are tried: cut as fans");
  say(flat_, "polygons have a mean normal of zero: cut as fans");
}

}  // namespace pineda::scene
