// What the judge must say of a triangle of floats, in rationals: every definition written
// literally, without regard to speed. Faults can be planted, to show that a comparison sees them.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "model/exact/exact.h"

namespace exact {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

enum class Fault {
  kNone,
  kInclusiveEdges,
  kTiesUp,
  kTruncatedDepth,
  kWNotInverted,
  kSlopesSummed,  // in place of the greater one
};

Integer floor_of(const Rational& r);

class Reference {
 public:
  Reference(const ScreenTriangle& triangle, const Format& format, const Frame& frame,
            Fault fault = Fault::kNone);

  /// Positive when clockwise on screen.
  Rational doubled_area() const;
  bool covers(int x, int y) const;
  /// With its bias, clamped.
  Rational z(int x, int y) const;
  Rational affine(int x, int y, size_t attribute) const;
  Rational perspective(int x, int y, size_t attribute) const;

 private:
  struct Point {
    Rational x, y;
  };
  struct Corner {
    Point p;
    Rational z, w;
    std::array<Rational, 4> attribute;
  };
  static Rational edge(const Point& from, const Point& to, const Point& p);
  static Point centre(int x, int y) { return {Rational(2 * x + 1, 2), Rational(2 * y + 1, 2)}; }
  Rational plane(int x, int y) const;  // z without bias
  /// The share of corner i in the sample.
  Rational barycentric(size_t i, const Point& p) const;

  std::array<Corner, 3> corner_;
  Frame frame_;
  Rational top_code_;
  Fault fault_;
};

}  // namespace exact
