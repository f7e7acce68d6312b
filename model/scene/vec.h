// Three-component vectors of doubles for the mesh pipeline.
#pragma once

#include <array>
#include <cmath>

namespace pineda::scene {

using Vec3 = std::array<double, 3>;

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
/// The unit vector; the zero vector stays as it is.
inline Vec3 normalized(const Vec3& a) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : a;
}
inline bool is_finite(const Vec3& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}
/// Does the vector define a direction: is its length finite and not zero?
inline bool is_direction(const Vec3& a) {
  const double l = length(a);
  return l > 0 && std::isfinite(l);
}

}  // namespace pineda::scene
