// Planes of depth and of affine attributes, by the reciprocal of the doubled area.
#pragma once

#include "model/core/reciprocal.h"
#include "model/core/setup.h"
#include "model/spec/structs.h"

namespace pineda::core {

/// What the planes of one triangle share; vertices in canonical order, the first is the anchor.
struct PlaneSetup {
  Reciprocal reciprocal;
  std::array<int64_t, 2> dx;  // vertices 1 and 2 from the anchor, subpixels
  std::array<int64_t, 2> dy;
  int64_t ref_x;  // first sample from the anchor, subpixels
  int64_t ref_y;
  std::array<const spec::Vertex*, 3> v;
  std::array<const spec::Vertex*, 3> painted;  // whose attributes they have
};

/// Whether 64 bits hold all of an attribute's plane on its way: then all of them are made side by
/// side. The bits are the same.
bool has_narrow_attributes(const spec::Contract& contract);

/// Bits     part of setup(): what its planes are made of, and depth's bias.
/// In       a design with a reciprocal; wanted: depth's plane or all of them.
/// Out      the planes that the design has. Attributes come in groups of four; planes of a group
///          that the design lacks are of no use.
void make_planes(const spec::Contract& contract, const spec::FrameState& frame,
                 const PlaneSetup& shared, Planes wanted, spec::PlaneSet* set);

}  // namespace pineda::core
