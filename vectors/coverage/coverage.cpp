#include "vectors/coverage/coverage.h"

#include <map>
#include <utility>

#include "vectors/coverage/points.h"
#include "vectors/coverage/table.h"
#include "vectors/runner/sparse_memories.h"

namespace pineda::vectors {

using spec::Contract;

struct Coverage::Tables {
  Tables(Unit u, const Contract& c)
      : unit(u),
        contract(c),
        triangles(vectors::points<SeenTriangle>(), c),
        prims(vectors::points<SeenPrim>(), c),
        tiles(vectors::points<SeenTile>(), c),
        stamps(vectors::points<SeenStamp>(), c),
        fragments(vectors::points<SeenFragment>(), c),
        given_stamps(vectors::points<SeenGivenStamp>(), c),
        cases(vectors::points<SeenCase>(), c),
        frames(vectors::points<SeenFrame>(), c) {}

  void see_prim(const spec::SetupPrim& prim) {
    core::TileWalk walk(contract, prim);
    spec::Tile tile;
    int tested = 0, kept = 0, sent = 0;
    for (core::TileWalk::Test test; (test = walk.next(&tile)) != core::TileWalk::Test::kEnd;) {
      ++tested;
      const bool is_kept = test == core::TileWalk::Test::kKept;
      tiles.see({contract, prim, is_kept ? &tile : nullptr});
      if (!is_kept) continue;
      ++kept;
      core::StampWalk stamp_walk(contract, tile);
      spec::Stamp stamp;
      stamp_walk.begin(&stamp);
      while (stamp_walk.next(&stamp.mask, &stamp.x, &stamp.y)) {
        if (stamp.mask == 0) continue;
        ++sent;
        stamps.see({contract, stamp});
        stamp.first = false;
      }
    }
    prims.see({contract, prim, tested, kept, sent});
  }

  // Stamps of one frame, in order.
  class Fragments {
   public:
    Fragments(Tables* tables, const spec::FrameState& frame)
        : tables_(tables), frame_(frame), memories_(tables->contract, frame) {}

    void see(const spec::Stamp& stamp) {
      const Contract& c = tables_->contract;
      spec::Fragment fragment;
      core::interpolate(c, stamp, &fragment);
      const spec::DepthData stored = memories_.read(c, stamp.x, stamp.y, stamp.mask);
      const uint32_t passed = core::depth_test(c, frame_.depth, stamp.mask, fragment.z, stored.z);
      size_t* const last = &last_[{stamp.x, stamp.y}];  // its number, from 1
      ++number_;
      const SeenFragment seen{
          c, frame_, stamp, fragment, stored, passed, *last == 0 ? 0 : number_ - *last};
      tables_->fragments.see(seen);
      if (tables_->unit == Unit::kInterpZtest) tables_->given_stamps.see({seen});
      *last = number_;
      if (passed != 0 && core::tests_depth(c, frame_) && frame_.depth_write) {
        memories_.write(c, core::depth_write(c, stamp, fragment, passed));
      }
    }

   private:
    Tables* tables_;
    const spec::FrameState& frame_;
    SparseMemories memories_;
    size_t number_ = 0;
    std::map<std::pair<int, int>, size_t> last_;
  };

  Unit unit;
  Contract contract;
  Table<SeenTriangle> triangles;
  Table<SeenPrim> prims;
  Table<SeenTile> tiles;
  Table<SeenStamp> stamps;
  Table<SeenFragment> fragments;
  Table<SeenGivenStamp> given_stamps;
  Table<SeenCase> cases;
  Table<SeenFrame> frames;
};

Coverage::Coverage(Unit unit, const Contract& contract)
    : tables_(std::make_unique<Tables>(unit, contract)) {}
Coverage::~Coverage() = default;

void Coverage::see(const SetupCase& value) {
  tables_->cases.see({tables_->contract, value.ports});
  for (const spec::Triangle& triangle : value.in) {
    tables_->triangles.see({tables_->contract, value.frame, triangle});
  }
}

void Coverage::see(const TraversalCase& value) {
  tables_->cases.see({tables_->contract, value.ports});
  for (const spec::SetupPrim& prim : value.in) tables_->see_prim(prim);
}

void Coverage::see(const InterpZtestCase& value) {
  tables_->cases.see({tables_->contract, value.ports});
  Tables::Fragments fragments(tables_.get(), value.frame);
  for (const spec::Stamp& stamp : value.in) fragments.see(stamp);
}

void Coverage::see(const FrameCase& value) {
  tables_->cases.see({tables_->contract, value.ports});
  tables_->frames.see({tables_->contract, value});
  Tables::Fragments fragments(tables_.get(), value.frame);
  for (const spec::Triangle& triangle : value.in) {
    const SeenTriangle seen(tables_->contract, value.frame, triangle);
    tables_->triangles.see(seen);
    if (!seen.kept()) continue;
    tables_->see_prim(seen.prim);
    core::for_each_stamp(tables_->contract, seen.prim,
                         [&](const spec::Stamp& stamp) { fragments.see(stamp); });
  }
}

std::vector<PointHits> Coverage::points() const {
  const Tables& t = *tables_;
  std::vector<PointHits> all;
  t.cases.list(&all);
  const bool whole = t.unit == Unit::kFrame;
  if (whole) t.frames.list(&all);
  if (whole || t.unit == Unit::kSetup) t.triangles.list(&all);
  if (whole || t.unit == Unit::kTraversal) {
    t.prims.list(&all);
    t.tiles.list(&all);
    t.stamps.list(&all);
  }
  if (whole || t.unit == Unit::kInterpZtest) t.fragments.list(&all);
  if (t.unit == Unit::kInterpZtest) t.given_stamps.list(&all);
  return all;
}

std::vector<std::string> contradictions(const std::vector<PointHits>& points) {
  std::vector<std::string> all;
  for (const PointHits& point : points) {
    for (size_t i = 0; i < point.bins.size(); ++i) {
      if (point.count[i] == 0 || point.bins[i].unreachable.empty()) continue;
      all.push_back(fmt::format("{}: {}, called unreachable: {}", point.name, point.bins[i].name,
                                point.bins[i].unreachable));
    }
  }
  return all;
}

size_t reachable_bins(const std::vector<PointHits>& points) {
  size_t count = 0;
  for (const PointHits& point : points) {
    for (const Bin& bin : point.bins) count += bin.unreachable.empty() ? 1 : 0;
  }
  return count;
}

size_t hit_bins(const std::vector<PointHits>& points) {
  size_t count = 0;
  for (const PointHits& point : points) {
    for (size_t i = 0; i < point.bins.size(); ++i) {
      count += point.bins[i].unreachable.empty() && point.count[i] > 0 ? 1 : 0;
    }
  }
  return count;
}

size_t Coverage::hit() const {
  const Tables& t = *tables_;
  return t.cases.hit() + t.frames.hit() + t.triangles.hit() + t.prims.hit() + t.tiles.hit() +
         t.stamps.hit() + t.fragments.hit() + t.given_stamps.hit();
}

}  // namespace pineda::vectors
