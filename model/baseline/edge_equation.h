// The draw loop of the edge-equation baselines; derived classes supply the setup.
#pragma once

#include "model/baseline/common.h"

namespace pineda::baseline {

inline constexpr int kFractionBits = 12;
inline constexpr int64_t kOne = int64_t{1} << kFractionBits;

// Edges and planes with 12 fraction bits; c and ref are at the sample of pixel (0, 0). Planes may
// wrap modulo 2^64: the values of covered samples fit, so they come out right.
struct Plane {
  int64_t dx = 0;
  int64_t dy = 0;
  int64_t ref = 0;
};
struct Setup {
  std::array<Edge, 3> edge;  // the top-left bias folded in: inside means at() >= 0
  std::array<Plane, kParameters> plane;
};

// The draw loop.
//
// As printed  the box from the signs of the edges; planes from the origin; one test of the three
//             edges ORed together; a row ends when it leaves the triangle.
// Mended      `t += b` at the end of a row (not e); pixel (x, y), not [y*x] or [y][x] with a scaled
//             y; samples at pixel centres; the top-left bias, so that >= 0 hits a shared edge once;
//             64 bits, so that edges do not overflow; a clamp that keeps all valid codes; half a
//             code added before the shift, to round; the box by exact comparisons, and with y
//             pointing the right way.
class EdgeEquation : public Common {
 public:
  using Common::Common;

  void draw(const spec::Triangle& t, Sink* sink) final {
    const Box pixels = sign_box(t);
    Setup setup;
    if (!pixels.empty() && set_up(t, &setup)) scan(setup, pixels, sink);
  }

 protected:
  // False if the triangle is not drawn.
  virtual bool set_up(const spec::Triangle& t, Setup* setup) const = 0;

 private:
  Box sign_box(const spec::Triangle& t) const;
  void scan(const Setup& setup, const Box& pixels, Sink* sink);
};

}  // namespace pineda::baseline
