// Interpolation and depth test of one stamp.
#pragma once

#include "model/spec/structs.h"

namespace pineda::core {

/// Bits     depth, the definition: ref + i*dx + j*dy modulo the plane's width, F' fraction bits,
///          plus the bias; then one rounding (half up) and a clamp to the output's range.
/// In       a stamp.
/// Out      fragment->z: depth codes at the covered lanes, 0 in the others.
/// Errors   |z - exact| <= .68 code for high_tile.
/// Twin     rtl/interp/depth_interpolator.sv, rtl/interp/depth_code.sv.
void interpolate_depth(const spec::Contract& contract, const spec::Stamp& stamp,
                       spec::Fragment* fragment);

/// Bits     affine attributes, the definition: as depth, without a bias; with perspective see
///          perspective.h.
/// In       a stamp; some of its covered lanes.
/// Out      fragment->attr at those lanes, 0 in the others.
/// Errors   |attribute - exact| <= .66 LSB for high_tile.
/// Twin     rtl/interp/attribute_interpolator.sv.
void interpolate_attributes(const spec::Contract& contract, const spec::Stamp& stamp,
                            uint32_t lanes, spec::Fragment* fragment);

/// The top hierarchical_z_bits of the least code that a tile can have, whatever its samples; 0
/// where the plane is steep, so that nothing is known. In: planes of a tile.
uint32_t depth_floor(const spec::Contract& contract, const spec::PlaneSet& planes);

/// The top hierarchical_z_bits of the greatest code of a stamp after the write of its lanes
/// `passed`.
uint32_t depth_ceiling(const spec::Contract& contract, const spec::Fragment& fragment,
                       uint32_t passed, const std::array<uint32_t, spec::kMaxLanes>& stored);

/// Both, at every covered lane.
inline void interpolate(const spec::Contract& contract, const spec::Stamp& stamp,
                        spec::Fragment* fragment) {
  interpolate_depth(contract, stamp, fragment);
  interpolate_attributes(contract, stamp, stamp.mask, fragment);
}

/// Whether samples are compared with stored depths.
bool tests_depth(const spec::Contract& contract, const spec::FrameState& frame);

/// The outcomes of comparing a new depth with the stored one that a depth function lets pass.
struct PassesWhen {
  bool less, equal, greater;
};
PassesWhen passes_when(spec::DepthFunc func);

/// Lanes of `mask` that pass against the stored codes. Depth off passes all.
uint32_t depth_test(const spec::Contract& contract, spec::DepthFunc func, uint32_t mask,
                    const std::array<uint32_t, spec::kMaxLanes>& z,
                    const std::array<uint32_t, spec::kMaxLanes>& stored);

/// The two writes of a stamp whose lanes `passed` (not empty) survive the test; *write may be one
/// of the same design before.
spec::DepthWrite depth_write(const spec::Contract& contract, const spec::Stamp& stamp,
                             const spec::Fragment& fragment, uint32_t passed);
spec::ColorWrite color_write(const spec::Contract& contract, const spec::Stamp& stamp,
                             const spec::Fragment& fragment, uint32_t passed);
void color_write(const spec::Contract& contract, const spec::Stamp& stamp,
                 const spec::Fragment& fragment, uint32_t passed, spec::ColorWrite* write);

}  // namespace pineda::core
