// Planes of depth and of affine attributes, quickly.
#pragma once

#include "model/core/planes.h"
#include "model/fast/setup.h"

namespace pineda::fast {

/// What the planes of one triangle are made of; vertices in canonical order.
struct PlaneSetup : core::PlaneSetup {
  std::array<const spec::Vertex*, 3> v;
  std::array<const spec::Vertex*, 3> painted;  // whose attributes are interpolated
};

/// Do 64 bits hold every intermediate of an attribute's plane? If so, four planes are computed side
/// by side. The bits are the same.
bool has_narrow_attributes(const spec::Contract& contract);

/// Bits     those of core::plane(), core::depth_magnitude() and core::depth_bias().
/// In       a design with a reciprocal; wanted: depth's plane or all of them.
/// Out      the planes that the design has. Attributes come in groups of four; planes of a group
///          that the design lacks are of no use.
void make_planes(const spec::Contract& contract, const spec::FrameState& frame,
                 const PlaneSetup& shared, Planes wanted, spec::PlaneSet* set);

}  // namespace pineda::fast
