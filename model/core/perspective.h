// Attributes corrected by perspective: weights from E_i/w_i, the same precision at every sample.
#pragma once

#include "model/spec/structs.h"

namespace pineda::core {

/// The attributes at one sample of a stamp.
///
/// Bits     the definition. For each vertex the product E*inverse_w, exact; the three cut off to
///          units that they share, in which the greatest has 26 bits; their sum's reciprocal as
///          reciprocal() gives it; weights U1.24 of vertices 1 and 2, rounded half up, at most 1;
///          a0 + g1*(a1 - a0) + g2*(a2 - a0), rounded half up and clamped.
/// In       a stamp of a design with perspective; i, j: px from the corner of its tile, of a sample
///          that the triangle covers.
/// Out      attr: the interpolated attributes.
/// Errors   |attribute - exact| <= spec::error_bounds(design).attribute_lsb, whatever the w's.
/// Twin     rtl/interp/perspective_interpolator.sv.
void perspective_attributes(const spec::Contract& contract, const spec::Stamp& stamp, int i, int j,
                            spec::Attributes* attr);

}  // namespace pineda::core
