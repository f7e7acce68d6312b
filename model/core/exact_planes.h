// Exact planes, which a design without a reciprocal interpolates with.
#pragma once

#include "model/spec/structs.h"

namespace pineda::core {

/// The planes of one triangle, kept as quotients and remainders of divisions by its doubled area.
///
/// Bits     the definition for reciprocal_scheme = kNone: each code is the exact value of the
///          plane through the snapped vertices, rounded once, half up; depth with its bias.
/// In       a triangle whose doubled area is not 0.
/// Errors   |z - exact| <= 1/2 code, |attribute - exact| <= 1/2 LSB.
/// Twin     none: functional model alone.
class ExactPlanes {
 public:
  ExactPlanes(const spec::Contract& contract, const spec::FrameState& frame,
              const spec::Triangle& triangle);

  /// Like core::interpolate_depth().
  void depth(const spec::Contract& contract, const spec::Stamp& stamp,
             spec::Fragment* fragment) const;
  /// Like core::interpolate_attributes().
  void attributes(const spec::Contract& contract, const spec::Stamp& stamp, uint32_t lanes,
                  spec::Fragment* fragment) const;

 private:
  // The number quotient + remainder/denominator; 0 <= remainder < denominator. Quotients wrap
  // modulo 2^64: at covered samples their sum is a code again, so that wrapping does no harm.
  struct Step {
    uint64_t quotient;
    int64_t remainder;
  };
  struct Plane {
    Step dx, dy, ref;  // change per px right, per px down; value at the sample of pixel (0, 0)
    int64_t denominator;
  };
  static Step divide(spec::int128_t numerator, int64_t denominator);
  static int64_t nearest(const Plane& plane, int x, int y);
  Plane plane(const spec::Contract& contract, const spec::Triangle& triangle,
              const std::array<int64_t, 3>& value, int fraction_bits) const;
  Step depth_bias(const spec::Contract& contract, const spec::FrameState& frame,
                  const spec::Triangle& triangle) const;

  int64_t area2_;  // positive when clockwise
  Plane z_;
  std::array<Plane, spec::kMaxAttributes> attr_;
};

}  // namespace pineda::core
