// The reciprocal of the doubled area, for each scheme of spec/reciprocal.
#pragma once

#include "model/spec/widths.h"

namespace pineda::core {

/// 1/area2 = mantissa * 2^(1 - k - length).
struct Reciprocal {
  int64_t mantissa;
  int length;  // bit_length(area2)
};

/// Bits     the definition. newton: ROM, then steps x <- 2x(1 - mx); quadratic: c0 - c1*t + c2*t^2;
///          both on m cut off after k+2 bits, products truncated to k+2 bits, and one rounding to k
///          bits. restoring: the quotient of the whole area2, truncated after k+1 bits, then the
///          same rounding: the nearest mantissa, and the same in radix 2 and 4. All saturate at
///          1 - 2^-k, where area2 is a power of two.
/// In       area2, 0 < area2 < 2^(AREA2_BITS - 1); a design with a reciprocal.
/// Out      mantissa UQ0.k in [1/2, 1).
/// Errors   |relative error| <= spec::reciprocal_error_bound(design).
/// Twin     rtl/reciprocal/reciprocal.sv, and one module for each scheme beside it.
Reciprocal reciprocal(const spec::Contract& contract, int64_t area2);

}  // namespace pineda::core
