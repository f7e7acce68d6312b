// What goes through the streams behind setup: tiles, with the coverage of all their stamps, and
// stamps, which are places in a tile. Nothing is copied; a token lives as long as the call.
#pragma once

#include "model/timing/stream.h"

namespace pineda::timing {

/// A tile that is neither rejected nor hidden, with its stamps.
struct TileToken {
  const spec::SetupPrim* prim = nullptr;
  const core::TileCover* cover = nullptr;
  spec::Stamp* stamp = nullptr;  // if Frame::tokens: what all stamps of the tile share
};

/// A stamp of a tile that has a covered sample.
struct StampToken {
  const TileToken* tile = nullptr;
  int test = 0;   // its stamp test
  int place = 0;  // its number in the whole tile, row by row

  uint32_t id() const { return tile->prim->id; }
};

/// A stream of stamps, which can take the run of a tile at once.
class StampIn : public StreamIn<StampToken> {
 public:
  /// All stamps of a tile; that of test k is visible from first_visible + k on. If each can be
  /// taken in that cycle, takes them all; else nothing happens, and they have to come one by one.
  virtual bool take_run(const TileToken& tile, Cycle first_visible) = 0;
};

/// Its producer's end.
class StampStream : public StreamOut<StampToken> {
 public:
  /// All stamps of a tile; that of test k is offered from first_offered + k on. As
  /// StampIn::take_run().
  virtual bool push_run(const TileToken& tile, Cycle first_offered) = 0;
};

/// The FIFO between traversal and interpolation.
///
/// Rate     a run flows freely, push[k] = offered[k] and pop[k] = push[k] + 1 for each stamp k of
/// it,
///          if the consumer takes each when it sees it, and each finds its slot free: those of
///          stamps before the run are looked at; of its own, pop[n - depth] + 1 <= push[n - 2] + 2
///          <= push[n] from depth 2 on.
class StampFifo final : public TimedFifo<StampToken, StampIn, StampStream> {
 public:
  StampFifo(sc_core::sc_module_name name, int depth) : TimedFifo(name, Fifo::kStamps, depth) {}

  bool push_run(const TileToken& tile, Cycle first_offered) override {
    if (freed_.size() < 2) return false;
    if (!is_free(tile.cover->covered, first_offered)) return false;
    if (!consumer_->take_run(tile, first_offered + 1)) return false;
    const core::TileSamples& covered = tile.cover->covered;
    levels_.flow(covered.count, first_offered + covered.last + 1);
    if (static_cast<size_t>(covered.count) <= freed_.size()) {
      covered.for_each_stamp([&](int test) {
        freed_[next_] = first_offered + test + 1;
        next_ = next_ + 1 == freed_.size() ? 0 : next_ + 1;
      });
      return true;
    }
    // Only the last ones can still be waited for.
    next_ = (next_ + static_cast<size_t>(covered.count)) % freed_.size();
    int test = covered.last;
    for (size_t left = freed_.size(), slot = next_; left > 0; --test) {
      if ((covered.stamps[static_cast<size_t>(test) / 64] >> (test % 64) & 1) == 0) continue;
      slot = slot == 0 ? freed_.size() - 1 : slot - 1;
      freed_[slot] = first_offered + test + 1;
      --left;
    }
    return true;
  }

 private:
  // Each stamp finds its slot free. The j-th one comes in first + j at the earliest.
  bool is_free(const core::TileSamples& covered, Cycle first_offered) const {
    const Cycle first = first_offered + covered.first;
    const size_t slots = std::min(freed_.size(), static_cast<size_t>(covered.count));
    for (size_t j = 0, slot = next_; j < slots; ++j) {
      if (freed_[slot] + 1 > first + static_cast<Cycle>(j)) return false;
      slot = slot + 1 == freed_.size() ? 0 : slot + 1;
    }
    return true;
  }
};

}  // namespace pineda::timing
