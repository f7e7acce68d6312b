// Setup of the planes of depth and affine attributes, with the reciprocal of the doubled area.
#pragma once

#include "model/core/reciprocal.h"
#include "model/spec/structs.h"

namespace pineda::core {

/// Inputs that all planes of one triangle share. Vertices in canonical order; vertex 0 is the
/// anchor.
struct PlaneSetup {
  Reciprocal reciprocal;
  std::array<int64_t, 2> dx;  // offsets of vertices 1 and 2 from the anchor, subpixels
  std::array<int64_t, 2> dy;
  int64_t ref_x;  // offset of the reference sample from the anchor, subpixels
  int64_t ref_y;
};

/// The plane through three values at the triangle's vertices.
///
/// Bits     the definition. Gradients: numerator * mantissa, exact, then rounded half up to F
///          fraction bits. The value at the reference sample: the anchor's value plus the rounded
///          gradients times the offset, exact, then rounded half up. All wrap modulo 2^bits at the
///          end.
/// In       values with `fraction_bits`.
/// Twin     rtl/setup/setup_plane.sv.
spec::Plane plane(const spec::Contract& contract, const PlaneSetup& setup,
                  const std::array<int64_t, 3>& value, int fraction_bits, int bits);

/// max(|dz/dx|, |dz/dy|) of the gradients before they wrap, in units of 2^-8 codes/px, saturated.
///
/// Bits     the definition: the gradients rounded half up to 8 fraction bits.
/// Twin     rtl/setup/setup_magnitude.sv.
int64_t depth_magnitude(const spec::Contract& contract, const PlaneSetup& setup,
                        const std::array<int64_t, 3>& z);

/// The bias of a triangle's depth: constant + slope * magnitude in units of 2^-16 codes, saturated.
///
/// Bits     the definition.
/// Twin     rtl/setup/setup_plane_bias.sv.
int64_t depth_bias(const spec::Contract& contract, const spec::FrameState& frame,
                   int64_t magnitude);

}  // namespace pineda::core
