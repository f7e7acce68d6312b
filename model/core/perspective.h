// Perspective-correct attributes, by weights E_i/w_i that have the same precision at every sample.
#pragma once

#include "model/core/reciprocal.h"
#include "model/spec/structs.h"

namespace pineda::core {

/// The weights of the three vertices at one sample of a stamp, not normalized, in a common unit.
///
/// Bits     the definition: for each vertex the exact product E*inverse_w; the three are then
///          truncated to a common unit in which the greatest has 26 bits.
/// In       a stamp of a design with perspective; i, j: px from the corner of its tile, of a sample
///          that the triangle covers.
std::array<int64_t, 3> weight_products(const spec::Contract& contract, const spec::Stamp& stamp,
                                       int i, int j);

/// The attributes for given weights of the vertices.
///
/// Bits     the definition: weights U1.24 of vertices 1 and 2, rounded half up, at most 1;
///          a0 + g1*(a1 - a0) + g2*(a2 - a0), rounded half up and clamped.
/// In       weight_products(), and the reciprocal of their sum.
void weigh_attributes(const spec::Contract& contract, const spec::Stamp& stamp,
                      const std::array<int64_t, 3>& product, const Reciprocal& reciprocal,
                      spec::Attributes* attr);

/// The attributes at one sample of a stamp.
///
/// Bits     the definition: weight_products(), the reciprocal() of their sum, weigh_attributes().
/// In       a stamp of a design with perspective; i, j: px from the corner of its tile, of a sample
///          that the triangle covers.
/// Out      attr: the interpolated attributes.
/// Errors   |attribute - exact| <= spec::error_bounds(design).attribute_lsb, whatever the w's.
/// Twin     rtl/interp/perspective_interpolator.sv.
void perspective_attributes(const spec::Contract& contract, const spec::Stamp& stamp, int i, int j,
                            spec::Attributes* attr);

}  // namespace pineda::core
