// Traversal in time.
#pragma once

#include <optional>

#include "model/timing/units/local_time.h"
#include "model/timing/units/tokens.h"

namespace pineda::timing {

/// Traversal: the tiles of a triangle's box, then the stamps of each tile that is not rejected.
///
/// Bits     core::TileWalk and core::StampWalk define every output bit, fast::TileCoverWalk finds
///          the same faster; this class adds only time.
/// In       prim_i: edges and planes at the first sample of the box's first tile.
/// Out      stamp_o: coverage mask and planes of one stamp; never empty.
/// Rate     one tile test a cycle and one stamp test a cycle, side by side. Latency 4 cycles.
/// Drops    tiles that an edge rejects, stamps without a covered sample: counted.
/// Errors   a stream left unbound: SC_REPORT_FATAL "pineda/traversal/unbound".
/// Twin     rtl/traversal/traversal_unit.sv, same ports. Source: Pineda, SIGGRAPH 1988.
///
/// Timing. Two walkers with a FIFO between them, each with a local time. The tile walker takes a
/// triangle as early as in the cycle of its last test and tests its first tile in the next one:
///   taken = max(last test, visible);  test[0] = taken + 1;  test[k+1] = done[k] + 1
///   done[k] = test[k] if rejected or hidden, else the cycle in which the FIFO takes the tile.
/// A tile is hidden by the depths that hierarchical z sees in test[k], and by no later ones.
/// The stamp walker does the same with tiles and stamps. A stamp that is not empty goes into an
/// output register, which is free again in the cycle in which the stamp in it is taken:
///   done[k] = test[k] if empty, else max(test[k], sent[k'])   k' = the stamp sent before
///   sent[k] = the cycle in which the next FIFO takes what is offered from done[k] + 1 on.
/// So if nothing is in the register at test[0] and the next FIFO never pushes back, test[k] =
/// test[0] + k and sent[k] = test[k] + 1: such a tile is timed as a whole.
class TraversalUnit final : public sc_core::sc_module, public StreamIn<spec::SetupPrim> {
 public:
  sc_core::sc_export<StreamIn<spec::SetupPrim>> prim_i{"prim_i"};
  Port<StampStream> stamp_o{"stamp_o"};

  TraversalUnit(sc_core::sc_module_name name, const spec::Contract& contract);

  void begin_frame(Frame* frame);
  Cycle take(const spec::SetupPrim& prim, Cycle visible) override;
  /// The first cycle in which the unit is idle, once all triangles are through.
  Cycle idle_from() const;
  /// `drained`: the cycle in which the frame has drained.
  UnitCycles tile_cycles(Cycle drained) const;
  UnitCycles stamp_cycles(Cycle drained) const;
  std::vector<Cycle> tile_levels(Cycle drained) const { return tiles_.levels(drained); }

 private:
  /// The second walker.
  class StampWalker final : public sc_core::sc_object, public StreamIn<TileToken> {
   public:
    explicit StampWalker(TraversalUnit* unit) : sc_object("stamp_walker"), unit_(*unit) {}
    void begin_frame(Listener* listener);
    Cycle take(const TileToken& tile, Cycle visible) override;

    LocalTime time;
    Cycle sent = -1;  // the cycle in which the last stamp was taken

   private:
    void walk(const TileToken& tile);

    TraversalUnit& unit_;
  };

  void end_of_elaboration() override;
  void walk_tiles(const spec::SetupPrim& prim);
  void walk_stamps(const spec::SetupPrim& prim);
  void send(const TileToken& tile);
  void prefetch() const;
  bool is_hidden();

  spec::Contract contract_;
  Frame* frame_ = nullptr;
  LocalTime time_;  // of the tile walker
  fast::TileCoverWalk walk_;
  fast::TileCover cover_;
  std::optional<fast::TileShader> floors_;  // hierarchical z
  std::optional<core::TileWalk> planes_;    // if Frame::tokens: what stamps are made of
  spec::Tile tile_;
  spec::Stamp stamp_;
  StampWalker stamp_walker_;
  TimedFifo<TileToken, StampWalker> tiles_;
};

}  // namespace pineda::timing
