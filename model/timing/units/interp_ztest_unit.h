// Interpolation and depth test in time.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "model/timing/ports/memory.h"
#include "model/timing/units/in_flight.h"
#include "model/timing/units/local_time.h"
#include "model/timing/units/ring.h"
#include "model/timing/units/tokens.h"

namespace pineda::timing {

/// Interpolation and depth test: one stamp in, its depth and colour writes out, in order.
///
/// Bits     core::interpolate_depth(), core::depth_test() and core::interpolate_attributes() define
///          every output bit, fast::TileShader finds the same faster; this class adds only time.
/// In       stamp_i.
/// Out      depth_io (reads too), color_wr_o: the covered samples that pass; nothing if none does.
///          With the test off, or depth not to be written, colour only. A design without depth has
///          no depth_io.
/// Rate     a stamp a cycle at any latency up to width.inflight_stamps - 4, as long as no address
///          is in flight and no port stalls.
/// Drops    samples that fail the test.
/// Errors   a stream or port left unbound: SC_REPORT_FATAL "pineda/interp_ztest/unbound".
/// Twin     rtl/interp/interp_ztest_unit.sv.
///
/// Timing, for stamp n, with p = the stamp before it and T = width.inflight_stamps:
///   accept[n] = the first cycle in which the read port is ready, not before
///               visible[n], accept[p] + 1,
///               retire[m] + 1 of the last stamp m with the same address, unless the test is off,
///               retire[n - T] + 1, since stamps leave the table in order and so free its slots in
///               order
///   load[n]   = max(accept[n] + 4, response[n] + 1, retire[p], enter[p])
///               The queue of stamps takes a cycle, the depth interpolator 3, the response FIFO 1.
///               The queue is as deep as the table. A response that finds its FIFO full waits, but
///               then a stamp before it is loaded two cycles later or more. The write register is
///               free again in the cycle in which its depth is written and its colours have left.
///   retire[n] = the cycle in which the depth write, offered from load[n] + 1 on, is accepted;
///               load[n] + 1 if there is nothing to write.
/// A stamp enters the FIFO in front only when there is a slot for the planes of one more tile;
/// those of a tile are kept until the first stamp of the next one is loaded. So it waits for load[f] + 1,
/// with f the first stamp of the tile that came design.plane_slots - 1 tiles before the next one.
/// A design without depth has neither table nor queues:
///   accept[n] = load[n] = max(visible[n], accept[p] + 1, enter[p])
/// Only stamps with a sample that passed have colours. Let q be the one before n, and
/// L = width.attribute_cycles. Behind the pipe there is room for L + 1 stamps, as many as can be
/// under way, and a stamp enters only when a place is free. So the pipe never stops:
///   enter[n]  = max(load[n] + 1, exit[n - (L + 1)] + 1)
///   exit[n]   = the first cycle in which the colour port is ready, from
///               max(enter[n] + L, exit[q] + 1) on
/// Without interpolated attributes the colour write leaves the write register: enter[n] = exit[n] =
/// the first cycle in which the colour port is ready, from load[n] + 1 on.
///
/// Where memories are always ready and answer in R cycles, nothing behind the read waits. By
/// induction: if retire[p] = enter[p] = accept[p] + C with C = max(4, R + 1) + 1, then both are at
/// most accept[n] + C - 1 = load[n]; and where T >= C + 1, a slot is free whenever a stamp comes.
/// Hence
///   accept[n] = max(visible[n], accept[p] + 1, retire[m] + 1),
///   retire[n] = enter[n] = accept[n] + C,  exit[n] = enter[n] + L,
/// with C = 5 if depths are not read, 1 in a design without depth. So the stamps of a tile of which
/// none is in flight can be timed all at once.
///
/// Other memories are served in the order of time: a read that is offered in t comes after every
/// write of an earlier stamp that is offered before t.
class InterpZtestUnit final : public sc_core::sc_module, public StampIn {
 public:
  sc_core::sc_export<StampIn> stamp_i{"stamp_i"};
  Port<DepthMemory> depth_io{"depth_io"};
  Port<ColorMemory> color_wr_o{"color_wr_o"};

  InterpZtestUnit(sc_core::sc_module_name name, const spec::Contract& contract);

  /// Is there a slot for every stamp in flight, where memories are always ready and answer in so many
  /// cycles?
  bool keeps_up_with(Cycle latency) const {
    return !contract_.design.depth_test || latency <= contract_.width.inflight_stamps - 4;
  }
  void begin_frame(Frame* frame);
  Cycle take(const StampToken& stamp, Cycle visible) override;
  Cycle has_room() override;
  bool take_run(const TileToken& tile, Cycle first_visible) override;
  /// Serves the memories until all writes offered before `until` are done.
  void advance(Cycle until);
  void drain();

  /// The first cycle in which the unit is idle, once all stamps are through.
  Cycle idle_from() const { return std::max({time_.now(), write_free_ + 1, exit_ + 1}); }
  /// The cycle of the last write accepted, -1 if there was none.
  Cycle last_write() const { return std::max(retired_, exit_); }
  /// `drained`: the cycle in which the frame has drained.
  UnitCycles cycles(Cycle drained) const;

 private:
  // A stamp's column and row.
  struct Place {
    int x, y;
  };
  // A stamp whose depths have been read, until it leaves the write register.
  struct Stored {
    Place place;
    Cycle data;   // the first cycle in which it can be loaded, as far as its depths are concerned
    bool first;   // of its tile
    bool passed;  // it has colours
    bool writes;  // it has a depth write
    uint32_t greatest;  // depth after its write, for hierarchical z
  };
  // The colours of a stamp, in the pipe or behind it, and when they are offered.
  struct Colored {
    Cycle offered;
    Place place;
  };
  // What a stamp writes, if Frame::tokens.
  struct Writes {
    spec::DepthWrite depth;
    spec::ColorWrite color;
  };
  // The write register, which holds the first stamp of stored_.
  struct Register {
    bool loaded = false;
    bool written = false;
    bool entered = false;
    Cycle offered = 0;        // from this cycle on its writes are offered
    Cycle write_offered = 0;  // the same of its depth write, later where the port was not ready
    Cycle retire = 0;
    Cycle enter = 0;
  };

  void end_of_elaboration() override;

  size_t tile_of(const fast::TileCover& cover) const;
  size_t address_of(const fast::TileCover& cover, int place) const;
  Place place_of(const fast::TileCover& cover, int place) const;
  void draw(const TileToken& tile);
  bool asks() const { return frame_->tokens || frame_->memory != nullptr; }

  // Memories that are always ready
  Cycle take_direct(const StampToken& stamp, Cycle visible);
  void pass_run(const fast::TileCover& cover, Cycle retire);
  void pass(Cycle retire);
  void update(const fast::TileCover& cover, int place, Cycle retire);
  uint32_t greatest_depth(Place place) const;  // stored in a stamp, the top bits

  // Other memories
  Cycle take_asking(const StampToken& token, Cycle visible);
  Cycle accept(const StampToken& token, Place place, size_t address, Cycle* response);
  Cycle read(const StampToken& token, Place place, Cycle* response);
  Reply read(const StampToken& token, Place place, Cycle offered);
  Reply write_depth(Cycle offered);
  Reply write_color(Cycle offered);
  void wait_for_address(size_t tile, size_t address, uint32_t id);
  void see(const StampToken& token, Stored* stored);
  void test(const spec::Stamp& stamp, Stored* stored);
  // The lanes whose depths are read: the covered ones, with hierarchical z all inside the frame.
  uint32_t asked(const spec::Stamp& stamp) const;
  uint32_t inside(int stamp_x, int stamp_y) const;
  void wait_for(uint64_t retired);
  void wait_for_planes();
  size_t next_slot() const { return slot_ + 1 == tile_loads_.size() ? 0 : slot_ + 1; }
  // From this cycle on there is room for the planes of a tile in a slot.
  Cycle planes_free(size_t slot) const { return tile_loads_[slot] + 1; }
  void accept_tile();
  void keep_planes(Cycle loaded);
  bool step(Cycle until);
  bool offer(Cycle until);
  bool turn();
  void count_stall(MemoryPort port, Cycle cycles);
  void retire(Cycle cycle);
  void exit(Cycle cycle);

  spec::Contract contract_;
  Frame* frame_ = nullptr;
  LocalTime time_;
  bool tests_ = false;         // depths are read and compared
  bool writes_depth_ = false;  // depths that pass are written
  int tile_columns_ = 0;       // tiles in a row of the frame
  int columns_log2_ = 0;       // stamps in a row of a tile
  int tile_stamps_log2_ = 0;   // stamps of a tile
  Cycle write_free_ = -1;      // the write register can be loaded from this cycle on
  Cycle retired_ = -1;         // the last depth write accepted
  Cycle exit_ = -1;            // the last colour write accepted

  std::optional<fast::TileShader> shader_;
  Cycle pass_cycles_ = 0;  // C
  InFlight in_flight_;

  Ring<Stored> stored_;
  Register register_;
  Ring<Colored> colored_;
  Ring<Writes> writes_;            // of stored_
  Ring<spec::ColorWrite> colors_;  // of colored_
  // By address and by tile: the number of the last stamp there, from 1.
  std::vector<uint64_t> last_stamp_, last_of_tile_;
  uint64_t accepted_count_ = 0;
  uint64_t retired_count_ = 0;
  uint64_t entered_count_ = 0;
  uint64_t exit_count_ = 0;
  std::vector<Cycle> slot_free_;  // by slot of the in-flight table
  // By tile modulo plane_slots - 1: when its first stamp was loaded.
  std::vector<Cycle> tile_loads_;
  size_t slot_ = 0;  // of the next tile: tiles_accepted_ modulo plane_slots - 1
  uint64_t tiles_accepted_ = 0;
  uint64_t tiles_loaded_ = 0;
  std::vector<Cycle> exits_;  // of the last L + 1 colour writes
  spec::DepthData data_;
  spec::Fragment fragment_;
};

}  // namespace pineda::timing
