// What the units share while they draw one frame.
#pragma once

#include "model/core/frame_counters.h"
#include "model/fast/setup.h"
#include "model/fast/small_walks.h"
#include "model/fast/tile_shader.h"
#include "model/timing/counted/listener.h"
#include "model/timing/units/hierarchical_z.h"
#include "model/timing/units/last_write.h"

namespace pineda::timing {

class FrameMemory;

/// The frame being drawn.
struct Frame {
  spec::FrameState state;
  Listener* listener = nullptr;
  // Stamps are made one by one, with all that they carry, since a listener or memories outside want
  // them. Else values are computed by whole tiles.
  bool tokens = false;
  // Where stamps are not made: what the memories hold.
  fast::TiledBuffer* buffer = nullptr;
  // If these are not always ready: what is asked when they take a stamp. The stamps of a place
  // follow one another in the order of triangles, since each waits until the one before has been
  // written. So values need not wait for their time.
  FrameMemory* memory = nullptr;
  Cycle depth_latency = 0;  // else: they answer a read after it
  bool has_values = true;   // stamps are drawn as they come; else only their cycles are known
  core::FrameCounters counters;
  fast::StampCounts stamps;  // sent
  fast::StampsBySamples stamps_by_samples{};
  std::array<Cycle, kMemoryPorts> port_stalls{};
  fast::Planes planes = fast::Planes::kAll;  // what setup makes
  LastWrite* last_write = nullptr;           // if depths are tested at the end, where needed
  HierarchicalZ* hierarchical_z = nullptr;   // if the design has it
  // Looks at triangles before their turn; null if none are looked at. `walk` is what it finds of the
  // triangle that goes through the units now, null if nothing.
  fast::SmallWalks* small_walks = nullptr;
  const fast::SmallWalk* walk = nullptr;
};

}  // namespace pineda::timing
