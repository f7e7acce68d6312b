// Interpolation and depth test of one stamp.
#pragma once

#include "model/spec/structs.h"

namespace pineda::core {

/// Bits     the definition: ref + i*dx + j*dy modulo the plane's width, F' fraction bits, then one
///          rounding (half up) and a clamp to the output's range.
/// In       a stamp.
/// Out      depth codes and attributes at the covered lanes, 0 in the others.
/// Errors   |z - exact| <= .68 code, |attribute - exact| <= .66 LSB for high_tile.
/// Twin     rtl/interp_ztest_unit.sv.
void interpolate(const spec::Contract& contract, const spec::Stamp& stamp,
                 spec::Fragment* fragment);

/// Lanes of `mask` that pass against the stored codes. Depth off passes all.
uint32_t depth_test(const spec::Contract& contract, spec::DepthFunc func, uint32_t mask,
                    const std::array<uint32_t, spec::kMaxLanes>& z,
                    const std::array<uint32_t, spec::kMaxLanes>& stored);

/// The two writes of a stamp whose lanes `passed` (not empty) survive the test.
spec::DepthWrite depth_write(const spec::Contract& contract, const spec::Stamp& stamp,
                             const spec::Fragment& fragment, uint32_t passed);
spec::ColorWrite color_write(const spec::Contract& contract, const spec::Stamp& stamp,
                             const spec::Fragment& fragment, uint32_t passed);

}  // namespace pineda::core
