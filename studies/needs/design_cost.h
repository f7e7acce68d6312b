// What a design costs, in bits: a proxy of its area.
#pragma once

#include <cstdint>

#include "model/spec/design.h"

namespace pineda::studies {

/// Bits of partial products, adders and registers, each counted as one; a bit of ROM or of a memory
/// as an eighth.
/// Setup counts as if every product had its own multiplier, whatever the style. Traversal is left
/// out: its adders are as wide as the edges, which count as part of the buffered tokens.
struct DesignCost {
  int64_t setup = 0;          // area, edges, planes
  int64_t reciprocal = 0;     // products, subtractors and ROM; with perspective one a lane
  int64_t interpolation = 0;  // of all lanes
  int64_t buffers = 0;        // the FIFOs' tokens, and a stamp for each depth read in flight
  int64_t memory = 0;         // of hierarchical z

  int64_t total() const { return setup + reciprocal + interpolation + buffers + memory; }
};

/// In       a design that can be built.
DesignCost design_cost(const spec::Design& design);

}  // namespace pineda::studies
