// Arithmetic of the mesh judge. Each formula is a template that works in floating point with an
// error bound, and in exact integers where that bound does not suffice.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "model/exact/mesh.h"

namespace exact {

using Integer = boost::multiprecision::cpp_int;

/// A number and the sum of the magnitudes of the terms that it was computed from. Its error is
/// below kErrorOfMagnitude * magnitude, for the few dozen roundings that an edge function takes.
struct Approximate {
  long double value = 0;
  long double magnitude = 0;

  Approximate() = default;
  explicit Approximate(long double v) : value(v), magnitude(std::abs(v)) {}
  Approximate(long double v, long double m) : value(v), magnitude(m) {}
};
inline constexpr long double kErrorOfMagnitude = 64 * std::numeric_limits<long double>::epsilon();

inline Approximate operator+(const Approximate& a, const Approximate& b) {
  return {a.value + b.value, a.magnitude + b.magnitude};
}
inline Approximate operator-(const Approximate& a, const Approximate& b) {
  return {a.value - b.value, a.magnitude + b.magnitude};
}
inline Approximate operator*(const Approximate& a, const Approximate& b) {
  return {a.value * b.value, a.magnitude * b.magnitude};
}
inline Approximate magnitude_of(const Approximate& a) { return {std::abs(a.value), a.magnitude}; }
inline Integer magnitude_of(const Integer& a) { return abs(a); }

/// Enlarges the error bound of a sum for its number of terms; integers have none.
inline void widen(Approximate* sum, size_t terms) {
  sum->magnitude *= 1 + static_cast<long double>(terms) / 32;
}
inline void widen(Integer*, size_t) {}

/// Is the sign certain, given the error bound?
inline bool is_certain(const Approximate& a) {
  return std::abs(a.value) >= kErrorOfMagnitude * a.magnitude;
}
inline int sign_of(const Approximate& a) { return (a.value > 0 ? 1 : 0) - (a.value < 0 ? 1 : 0); }
inline int sign_of(const Integer& a) { return a.sign(); }

template <class T>
struct Corner {
  T x, y, z, w;
};

template <class T>
using Vector = std::array<T, 3>;  // x, y, w

template <class T>
Vector<T> cross(const Corner<T>& p, const Corner<T>& q) {
  return {p.y * q.w - p.w * q.y, p.w * q.x - p.x * q.w, p.x * q.y - p.y * q.x};
}

template <class T>
T dot(const Vector<T>& n, const Corner<T>& p) {
  return n[0] * p.x + n[1] * p.y + n[2] * p.w;
}

template <class T>
T determinant(const Corner<T>& p, const Corner<T>& q, const Corner<T>& r) {
  return dot(cross(q, r), p);
}

/// The line function a*x + b*y + c at the sample of pixel (x, y), and the half width of the band
/// around its zeros; all scaled by the same positive number.
template <class T>
struct Line {
  T a, b, c, band;
};

// The dot product of n with the ray through a sample, as a function of the pixel; scaled by width *
// height * 2^kBandFractionBits so that all coefficients are integers.
template <class T>
Line<T> line_of(const Vector<T>& n, const MeshFrame& f) {
  const T scale(1 << MeshFrame::kBandFractionBits);
  const T w(f.width), h(f.height);
  Line<T> line;
  const T a = T(2) * h * n[0];
  const T b = T(-2) * w * n[1];
  line.a = scale * a;
  line.b = scale * b;
  line.c = scale * (n[0] * h * T(1 - f.width) + n[1] * w * T(f.height - 1) + n[2] * w * h);
  line.band = T(f.band) * (magnitude_of(a) + magnitude_of(b));
  return line;
}

}  // namespace exact
