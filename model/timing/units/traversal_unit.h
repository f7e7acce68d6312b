// Traversal in time.
#pragma once

#include <optional>

#include "model/timing/units/local_time.h"
#include "model/timing/units/tokens.h"

namespace pineda::timing {

/// Traversal: the tiles of a triangle's box, in those that are not rejected the covered samples,
/// and of these the stamps.
///
/// Bits     core::TileWalk and core::StampWalk define every output bit, fast::TileCoverWalk finds
///          the same faster; this class adds only time.
/// In       prim_i: edges and planes at the first sample of the box's first tile.
/// Out      stamp_o: coverage mask and planes of one stamp; never empty.
/// Rate     side by side, each a cycle: a tile tested, a group of stamps tested, a stamp sent.
///          Latency 4 cycles.
/// Drops    tiles that an edge rejects, stamps without a covered sample: counted.
/// Errors   a stream left unbound: SC_REPORT_FATAL "pineda/traversal/unbound".
/// Twin     rtl/traversal/traversal_unit.sv, same ports. Source: Pineda, SIGGRAPH 1988.
///
/// Timing. Three stages, each with a local time; a FIFO stands between the first two. The tile
/// walker takes a triangle as early as in the cycle of its last test and tests its first tile in
/// the next one:
///   taken = max(last test, visible);  test[0] = taken + 1;  test[k+1] = done[k] + 1
///   done[k] = test[k] if rejected or hidden, else the cycle in which the FIFO takes the tile.
/// Without a FIFO in front, or with hierarchical z, it takes a triangle a cycle later than that.
/// A tile is hidden by the depths that hierarchical z sees in test[k], and by no later ones.
/// Coverage does the same with tiles and groups of stamps. A group that is not empty goes to the
/// sender, which takes it as early as in the cycle in which it sends the last stamp before:
///   done[k] = test[k] if empty, else max(test[k], sent[k'])   k' = the last stamp before
///   sent[k] = the cycle in which the next FIFO takes what is offered from done[k] + 1 on, or from
///             the cycle after that of the stamp before on.
/// A group that is not empty has at least one stamp. So if none between the first and the last one
/// is empty and the next FIFO never pushes back, the stamps of a tile leave one a cycle from
/// done[first] + 1 on: such a tile is timed as a whole.
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
  UnitCycles coverage_cycles(Cycle drained) const;
  UnitCycles stamp_cycles(Cycle drained) const;
  std::vector<Cycle> tile_levels(Cycle drained) const { return tiles_.levels(drained); }

 private:
  /// The second and the third stage.
  class Coverage final : public sc_core::sc_object, public StreamIn<TileToken> {
   public:
    explicit Coverage(TraversalUnit* unit) : sc_object("coverage"), unit_(*unit) {}
    void begin_frame(Listener* listener);
    Cycle take(const TileToken& tile, Cycle visible) override;

    LocalTime time;
    LocalTime sender;

   private:
    bool take_run(const TileToken& tile);
    void walk(const TileToken& tile);
    void send(const TileToken& tile, int place);
    Cycle sent() const { return sender.now() - 1; }  // the last stamp, or before

    TraversalUnit& unit_;
  };

  void end_of_elaboration() override;
  void walk_small(const spec::SetupPrim& prim, const fast::SmallWalk& walk);
  void walk_tiles(const spec::SetupPrim& prim);
  void walk_stamps(const spec::SetupPrim& prim);
  void send(const TileToken& tile);
  void prefetch(const fast::TileCover& cover) const;
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
  Coverage coverage_;
  TimedFifo<TileToken, Coverage> tiles_;
};

}  // namespace pineda::timing
