// The greatest depth stored in each tile of a frame, as tile tests see it.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "model/spec/structs.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// Hierarchical z: the greatest depth of every stamp of a frame, by tile.
///
/// Bits     a tile is hidden when depth_floor() of the triangle there is greater than the greatest
///          depth of all its stamps, both in their top bits. Then no sample of it can pass LESS or
///          LEQUAL; with another depth function nothing is hidden. A stamp that was not written has
///          the depth that the frame is cleared to.
/// In       update(): the depths of stamps, in the order of the cycles in which their writes are
///          accepted. hides(): tile tests, in the order of their cycles.
/// Rate     a write accepted in t is seen by a test in t + hierarchical_z_delay_cycles.
/// Drops    tiles beyond hierarchical_z_tiles: never hidden.
/// Twin     rtl/interp/hierarchical_z.sv.
class HierarchicalZ {
 public:
  /// `catch_up(cycle)` is called before a test in that cycle. When it returns, update() must have
  /// been called for every write accepted before that cycle.
  explicit HierarchicalZ(
      const spec::Contract& contract, std::function<void(Cycle)> catch_up = [](Cycle) {})
      : contract_(contract), catch_up_(std::move(catch_up)) {}

  void begin_frame(const spec::FrameState& frame);
  /// The frame's depth function lets tiles be hidden.
  bool is_active() const { return active_; }
  void update(Cycle accepted, const spec::DepthMax& depth);
  bool hides(Cycle cycle, int tile_x, int tile_y, uint32_t floor);

 private:
  struct Update {
    Cycle visible;
    spec::DepthMax depth;
  };
  size_t index(int tile_x, int tile_y) const {
    return static_cast<size_t>(tile_y) * static_cast<size_t>(columns_) +
           static_cast<size_t>(tile_x);
  }
  void apply(const spec::DepthMax& depth);

  spec::Contract contract_;
  std::function<void(Cycle)> catch_up_;
  bool active_ = false;
  int columns_ = 0;                 // tiles in a row of the frame
  std::vector<uint16_t> greatest_;  // by stamp of the tile, by tile; outside the frame 0
  std::deque<Update> pending_;
};

}  // namespace pineda::timing
