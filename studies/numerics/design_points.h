// The front of speed against error: every design point on six classes of random triangles.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "studies/judge/scorer.h"
#include "studies/numerics/random_triangles.h"

namespace pineda::studies {

/// Bits of the partial products that setup forms for a triangle with depth and four colours: a
/// proxy of its area. The area takes two products and the edges at the first sample six,
/// (guard+2+S)^2 bits each; each plane takes four for its numerators, two for its gradients (by the
/// reciprocal) and two for its reference; a Newton step takes two of k+2 bits.
int64_t setup_product_bits(const spec::Design& design);

/// One design over all classes.
struct DesignPoint {
  spec::Design design;
  uint64_t samples = 0;
  uint64_t wrong_samples = 0;  // missing or too many
  double max_depth_ulp = 0;
  double max_color_lsb = 0;
  double coplanar = 0;              // share of depth codes that differ between coplanar triangles
  std::vector<std::string> broken;  // classes where it does not hold, with what was measured
};

struct DesignPointOptions {
  std::vector<spec::Design> designs;  // all with the same input formats
  int triangles = 2000;               // of each class
  uint64_t seed = 1;
  std::function<void(const char* what, uint64_t done)> progress;
};

std::vector<DesignPoint> study_design_points(const DesignPointOptions& options);

/// Share of samples whose depth codes differ between a triangle and another one inside it on the
/// same plane. The gradients are whole codes a px, the plane's height is any multiple of 2^-8
/// codes.
double coplanar_difference(const spec::Design& design, int pairs, uint64_t seed);

/// Figures that a software prototype measured before this model existed; the design points were
/// chosen by them.
struct PrototypePoint {
  const char* name;
  double products;  // bits
  int z_adder_bits;
  double max_depth_ulp;
  double max_color_lsb;
  double coplanar;
};
const std::vector<PrototypePoint>& prototype_points();

}  // namespace pineda::studies
