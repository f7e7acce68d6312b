#include "studies/numerics/reciprocals.h"

#include <algorithm>
#include <cmath>

#include "model/core/reciprocal.h"

namespace pineda::studies {
namespace {

using spec::Design;
using spec::ReciprocalScheme;

/// The search over one design.
class Search {
 public:
  explicit Search(const Design& design) : contract_(spec::contract(design)) {}

  void try_area(int64_t area2) {
    const core::Reciprocal r = core::reciprocal(contract_, area2);
    // (computed - exact) / exact, from the exact integer area2*mantissa - 2^(k + length - 1).
    const int shift = contract_.design.reciprocal_bits + r.length - 1;
    const spec::int128_t difference =
        spec::int128_t{area2} * r.mantissa - (spec::int128_t{1} << shift);
    const double error = std::ldexp(std::abs(static_cast<double>(difference)), -shift);
    if (error <= worst_.error) return;
    worst_.error = error;
    worst_.area2 = area2;
  }

  /// Tries the least and the greatest area whose leading bits are this mantissa.
  void try_mantissa(int64_t mantissa, int below) {
    const int64_t low = mantissa << below;
    try_area(low);
    try_area(low + ((int64_t{1} << below) - 1));
  }

  ReciprocalError& worst() { return worst_; }

 private:
  spec::Contract contract_;
  ReciprocalError worst_;
};

Design scheme(ReciprocalScheme s, int lut_bits, int newton_steps, int k) {
  Design d;
  d.reciprocal_scheme = s;
  d.reciprocal_lut_bits = lut_bits;
  d.reciprocal_newton_steps = newton_steps;
  d.reciprocal_bits = k;
  return d;
}

}  // namespace

double ReciprocalError::good_bits() const { return -std::log2(error); }

ReciprocalError reciprocal_error(const Design& design, int64_t most) {
  const int bits = spec::reciprocal_working_bits(design);
  // Bits below the mantissa in the largest areas.
  const int below = spec::widths(design).area2 - 1 - bits;
  const int64_t mantissas = int64_t{1} << (bits - 1);
  Search search(design);
  search.worst().exhaustive = mantissas <= most;
  if (search.worst().exhaustive) {
    for (int64_t m = mantissas; m < 2 * mantissas; ++m) search.try_mantissa(m, below);
    return search.worst();
  }
  // An odd stride visits every residue of a cell's power-of-two size, so every place in a cell.
  const int64_t stride = (mantissas / most) | 1;
  for (int64_t m = mantissas; m < 2 * mantissas; m += stride) search.try_mantissa(m, below);
  const int64_t cell = mantissas >> std::max(spec::tamed(design).reciprocal_lut_bits, 1);
  for (int64_t edge = mantissas; edge <= 2 * mantissas; edge += cell) {
    for (int64_t near = -2000; near <= 2000; ++near) {
      const int64_t m = std::clamp(edge + near, mantissas, 2 * mantissas - 1);
      search.try_mantissa(m, below);
    }
  }
  return search.worst();
}

std::vector<ReciprocalRow> reciprocal_rows() {
  constexpr auto kNewton = ReciprocalScheme::kNewton;
  return {
      {"LUT10", scheme(kNewton, 10, 0, 16), 10.7},
      {"LUT8 + 1 Newton", scheme(kNewton, 8, 1, 19), 17.2},
      {"LUT10 + 1 Newton", scheme(kNewton, 10, 1, 22), 20.9},
      {"quadratic LUT7", scheme(ReciprocalScheme::kQuadratic, 7, 0, 26), 24.2},
      {"LUT12 + 1 Newton", scheme(kNewton, 12, 1, 26), 24.8},
      {"LUT7 + 2 Newton", scheme(kNewton, 7, 2, 30), 29.4},
      {"LUT8 + 2 Newton", scheme(kNewton, 8, 2, 32), 31.6},
      {"restoring, radix 2", scheme(ReciprocalScheme::kRestoring2, 0, 0, 28), 28},
      {"restoring, radix 4", scheme(ReciprocalScheme::kRestoring4, 0, 0, 28), 28},
  };
}

}  // namespace pineda::studies
