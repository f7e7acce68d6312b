// What the units share while they draw one frame.
#pragma once

#include "model/core/frame.h"
#include "model/timing/hierarchical_z.h"
#include "model/timing/local_time.h"

namespace pineda::timing {

/// Sees each token at the output of its unit, with the cycle of the handshake. Tokens of one kind
/// come in order; between kinds there is no order but that of their cycles. Must not throw.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void prim(Cycle, const spec::SetupPrim&) {}
  virtual void stamp(Cycle, const spec::Stamp&) {}
  virtual void depth(Cycle, const spec::DepthWrite&) {}
  virtual void color(Cycle, const spec::ColorWrite&) {}
};

/// The frame being drawn.
struct Frame {
  spec::FrameState state;
  Listener* listener = nullptr;  // never null while units run
  core::FrameCounters counters;
  HierarchicalZ* hierarchical_z = nullptr;  // if the design has it
  // Tiles and stamps that are not drawn yet. Only when none is left does a tile test know every
  // depth that was written before its cycle.
  int64_t under_way = 0;
};

}  // namespace pineda::timing
