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

/// Bits     affine attributes, the definition: like depth, without a bias; for perspective see
///          perspective.h.
/// In       a stamp; some of its covered lanes.
/// Out      fragment->attr at those lanes, 0 in the others.
/// Errors   |attribute - exact| <= .66 LSB for high_tile.
/// Twin     rtl/interp/attribute_interpolator.sv.
void interpolate_attributes(const spec::Contract& contract, const spec::Stamp& stamp,
                            uint32_t lanes, spec::Fragment* fragment);

/// Hierarchical z: the top hierarchical_z_bits of a lower bound of the depth codes of a triangle in
/// a tile, from the tile's planes; 0 where the plane is too steep to know.
uint32_t depth_floor(const spec::Contract& contract, const spec::PlaneSet& planes);

/// Hierarchical z: the top hierarchical_z_bits of the greatest code stored in a stamp after the
/// lanes `passed` are written.
uint32_t depth_ceiling(const spec::Contract& contract, const spec::Fragment& fragment,
                       uint32_t passed, const std::array<uint32_t, spec::kMaxLanes>& stored);

/// Interpolates depth and attributes at all covered lanes.
inline void interpolate(const spec::Contract& contract, const spec::Stamp& stamp,
                        spec::Fragment* fragment) {
  interpolate_depth(contract, stamp, fragment);
  interpolate_attributes(contract, stamp, stamp.mask, fragment);
}

/// Whether this design and frame compare samples with stored depths.
bool tests_depth(const spec::Contract& contract, const spec::FrameState& frame);

/// How a new depth must compare with the stored one to pass a depth function.
struct PassesWhen {
  bool less, equal, greater;
};
PassesWhen passes_when(spec::DepthFunc func);

/// The lanes of `mask` that pass the depth test against the stored codes. Depth off passes all.
uint32_t depth_test(const spec::Contract& contract, spec::DepthFunc func, uint32_t mask,
                    const std::array<uint32_t, spec::kMaxLanes>& z,
                    const std::array<uint32_t, spec::kMaxLanes>& stored);

/// The depth and colour write of a stamp whose lanes `passed` (at least one) passed the depth test.
/// *write may be reused from an earlier stamp of the same design.
spec::DepthWrite depth_write(const spec::Contract& contract, const spec::Stamp& stamp,
                             const spec::Fragment& fragment, uint32_t passed);
spec::ColorWrite color_write(const spec::Contract& contract, const spec::Stamp& stamp,
                             const spec::Fragment& fragment, uint32_t passed);
void color_write(const spec::Contract& contract, const spec::Stamp& stamp,
                 const spec::Fragment& fragment, uint32_t passed, spec::ColorWrite* write);

}  // namespace pineda::core
