// What the units share while they draw one frame.
#pragma once

#include "model/fast/setup.h"
#include "model/fast/tile_shader.h"
#include "model/timing/cycles.h"
#include "model/timing/hierarchical_z.h"
#include "model/timing/last_write.h"

namespace pineda::timing {

/// Sees each token at the output of its unit, with the cycle of the handshake, and what the units'
/// cycles are spent on. Tokens and spans of one kind come in order; between kinds there is no order
/// but that of their cycles. Must not throw.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void prim(Cycle, const spec::SetupPrim&) {}
  virtual void stamp(Cycle, const spec::Stamp&) {}
  virtual void depth(Cycle, const spec::DepthWrite&) {}
  virtual void color(Cycle, const spec::ColorWrite&) {}
  /// The unit spent the cycles [from, until) so, on triangle `id`; spans of a unit come in order.
  /// Cycles in which nothing is there to work on are not reported.
  virtual void spent(Unit, Cause, Cycle /*from*/, Cycle /*until*/, uint32_t /*id*/) {}
  /// A slot of the FIFO was taken in the cycle `inserted` and freed in `freed`; of one FIFO in
  /// order.
  virtual void slot(Fifo, Cycle /*inserted*/, Cycle /*freed*/) {}
};

/// The frame being drawn.
struct Frame {
  spec::FrameState state;
  Listener* listener = nullptr;
  // Stamps are made with all that they carry: somebody looks at them, or the memories want them one
  // by one. Else values are computed by whole tiles.
  bool tokens = false;
  // Else the contents of the memories, which are always ready and answer after this latency.
  fast::TiledBuffer* buffer = nullptr;
  Cycle depth_latency = 0;
  bool has_values = true;  // stamps are drawn as they come; else only their time is known
  core::FrameCounters counters;
  fast::StampCounts stamps;  // sent
  fast::StampsBySamples stamps_by_samples{};
  std::array<Cycle, kMemoryPorts> port_stalls{};
  fast::Planes planes = fast::Planes::kAll;  // what setup makes
  LastWrite* last_write = nullptr;           // depths wait until somebody needs them
  HierarchicalZ* hierarchical_z = nullptr;   // if the design has it
};

}  // namespace pineda::timing
