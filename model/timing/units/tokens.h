// What goes through the streams behind setup: tiles, with the coverage of all their stamps, and
// stamps, which are places in a tile. Nothing is copied; a token lives as long as the call.
#pragma once

#include "model/timing/units/stream.h"

namespace pineda::timing {

/// A tile that is neither rejected nor hidden, with its stamps.
struct TileToken {
  const spec::SetupPrim* prim = nullptr;
  const fast::TileCover* cover = nullptr;
  spec::Stamp* stamp = nullptr;  // what all stamps of the tile share; only if Frame::tokens
};

/// A stamp of a tile that has a covered sample.
struct StampToken {
  const TileToken* tile = nullptr;
  int place = 0;  // its number in the whole tile, row by row

  uint32_t id() const { return tile->prim->id; }
  /// The first of its tile?
  bool is_first() const { return place == tile->cover->covered.first; }
};

/// A stream of stamps, which can take the run of a tile at once.
class StampIn : public StreamIn<StampToken> {
 public:
  /// From this cycle on a stamp can enter the FIFO in front, as far as the unit behind it keeps
  /// what its tile brings along.
  virtual Cycle has_room() = 0;
  /// All stamps of a tile; the k-th one, from 0, is visible from first_visible + k on. Takes them
  /// all if each can be taken in the cycle in which it becomes visible. Else it returns false, and
  /// the stamps have to come one by one.
  virtual bool take_run(const TileToken& tile, Cycle first_visible) = 0;
};

/// Its producer's end.
class StampStream : public StreamOut<StampToken> {
 public:
  /// All stamps of a tile; the k-th one, from 0, is offered from first_offered + k on. True if all
  /// are taken, as by StampIn::take_run().
  virtual bool push_run(const TileToken& tile, Cycle first_offered) = 0;
};

/// The FIFO between traversal and interpolation.
///
/// Rate     if the consumer takes each stamp of a run when it becomes visible, the run flows
///          freely: push[k] = offered[k] and pop[k] = push[k] + 1 for each stamp k of it. A slot is
///          free for each of them if the depth is 2 or more: the consumer takes stamp 0 in push[0]
///          + 1, so pop[-1] <= push[0], and pops only grow, so pop[k - depth] <= pop[k - 2] <=
///          push[k] - 1.
class StampFifo final : public TimedFifo<StampToken, StampIn, StampStream> {
 public:
  StampFifo(sc_core::sc_module_name name, int depth) : TimedFifo(name, Fifo::kStamps, depth) {}

  Cycle push(const StampToken& stamp, Cycle earliest) override {
    return TimedFifo::push(stamp, std::max(earliest, consumer_->has_room()));
  }
  bool push_run(const TileToken& tile, Cycle first_offered) override {
    if (levels_.depth() < 2 || !consumer_->take_run(tile, first_offered + 1)) return false;
    levels_.flow(tile.cover->covered.count);
    return true;
  }
};

}  // namespace pineda::timing
