// The coverage of traversal: walks of tiles and stamps.
#include <algorithm>

#include "vectors/coverage/points.h"

namespace pineda::vectors {

using spec::Contract;

namespace {

int columns(const Contract& c) { return 1 << (c.design.tile_log2 - c.design.stamp_width_log2); }
int rows(const Contract& c) { return 1 << (c.design.tile_log2 - c.design.stamp_height_log2); }

void see_tile(const SeenTile& s, Hits* hits) {
  hits->add(s.tile == nullptr ? 0 : s.tile->accepted == 7 ? 2 : 1);
}

void see_place(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  hits->add(length_of(s.tile->x));
  hits->add(s.contract.width.tile_index + 1 + length_of(s.tile->y));
}

void see_box(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  const spec::Tile& t = *s.tile;
  const int last = (1 << s.contract.design.tile_log2) - 1;
  const std::array<bool, 4> cut{t.x0 > 0, t.x1<last, t.y0> 0, t.y1 < last};
  for (size_t i = 0; i < 4; ++i) {
    if (cut[i]) hits->add(i);
  }
  if (!cut[0] && !cut[1] && !cut[2] && !cut[3]) hits->add(4);
}

// The same inside a stamp.
void see_box_in_stamp(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  const int width = 1 << s.contract.design.stamp_width_log2;
  const int height = 1 << s.contract.design.stamp_height_log2;
  if (s.tile->x0 % width != 0) hits->add(0);
  if (s.tile->x1 % width != width - 1) hits->add(1);
  if (s.tile->y0 % height != 0) hits->add(2);
  if (s.tile->y1 % height != height - 1) hits->add(3);
}
Bins box_in_stamp(const Contract& c) {
  Bins bins = named({"left", "right", "top", "bottom"});
  if (c.design.stamp_width_log2 == 0) bins[0].unreachable = bins[1].unreachable = "one px wide";
  if (c.design.stamp_height_log2 == 0) bins[2].unreachable = bins[3].unreachable = "one px high";
  return bins;
}

// E' of each edge at the best and at the worst corner of a tile, where one more or less decides.
void see_margin(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  const int log2 = s.contract.design.tile_log2;
  const int64_t x = int64_t{s.tile->x - (s.prim.x0 >> log2)} << log2;
  const int64_t y = int64_t{s.tile->y - (s.prim.y0 >> log2)} << log2;
  const int64_t last = (1 << log2) - 1, zero = 0;
  bool just = false;
  for (const spec::EdgeFunction& edge : s.prim.edge) {
    const int64_t e = edge.e + x * edge.a + y * edge.b;
    const int64_t best = e + last * (std::max(edge.a, zero) + std::max(edge.b, zero));
    const int64_t worst = e + last * (std::min(edge.a, zero) + std::min(edge.b, zero));
    if (best == 0) hits->add(0);
    if (worst == -1) hits->add(1);
    if (worst == 0) hits->add(2);
    just |= worst == 0;
  }
  if (just && s.tile->accepted == 7) hits->add(3);
}

// E' of an accepted edge that a narrower register cannot hold.
void see_edge_wrap(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  const int log2 = s.contract.design.tile_log2;
  const int64_t dx = int64_t{s.tile->x - (s.prim.x0 >> log2)} << log2;
  const int64_t dy = int64_t{s.tile->y - (s.prim.y0 >> log2)} << log2;
  for (const spec::EdgeFunction& edge : s.prim.edge) {
    hits->add(leaves(edge.e + dx * edge.a + dy * edge.b, s.contract.width.tile_edge) ? 1 : 0);
  }
}

// A plane stepped to a tile, before it wraps and is narrowed.
struct Stepped {
  spec::int128_t ref;
  int64_t dx, dy;
};
Stepped stepped(const SeenTile& s, const spec::Plane& plane) {
  const int log2 = s.contract.design.tile_log2;
  const int64_t x = int64_t{s.tile->x - (s.prim.x0 >> log2)} << log2;
  const int64_t y = int64_t{s.tile->y - (s.prim.y0 >> log2)} << log2;
  return {plane.ref + spec::int128_t{plane.dx} * x + spec::int128_t{plane.dy} * y, plane.dx,
          plane.dy};
}

int narrowing(const Contract& c) {
  return c.design.gradient_fraction_bits - c.design.tile_fraction_bits;
}
void see_narrowing(const SeenTile& s, const spec::Plane& plane, Hits* hits) {
  const Stepped at = stepped(s, plane);
  const int shift = narrowing(s.contract);
  hits->add(rounding_bin(at.dx, shift));
  hits->add(4 + rounding_bin(at.dy, shift));
  hits->add(8 + rounding_bin(at.ref, shift));
}
Bins narrowings(const Contract& c) {
  return product(named({"dx", "dy", "ref"}), roundings(narrowing(c)));
}

template <class Work>
void for_each_attribute(const SeenTile& s, Work&& work) {
  for (size_t a = 0; a < static_cast<size_t>(s.contract.design.attributes); ++a) {
    work(s.prim.planes.attr[a]);
  }
}
bool has_attribute_planes(const Contract& c) {
  return c.design.attributes > 0 && !c.design.perspective;
}

void see_depth_narrowing(const SeenTile& s, Hits* hits) {
  if (s.tile != nullptr) see_narrowing(s, s.prim.planes.z, hits);
}
void see_attribute_narrowing(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  for_each_attribute(s, [&](const spec::Plane& plane) { see_narrowing(s, plane, hits); });
}
void see_depth_wrap(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  hits->add(leaves(stepped(s, s.prim.planes.z).ref, s.contract.width.depth_plane) ? 1 : 0);
}
void see_attribute_wrap(const SeenTile& s, Hits* hits) {
  if (s.tile == nullptr) return;
  for_each_attribute(s, [&](const spec::Plane& plane) {
    hits->add(leaves(stepped(s, plane).ref, s.contract.width.attr_plane) ? 1 : 0);
  });
}
Bins wrapping() { return named({"in range", "wrapped"}); }

// Rows are walked to the left where both sides of the triangle run down to the left.
bool turns(const spec::SetupPrim& prim) {
  const auto any = [&](bool falls_rightward, bool falls_downward) {
    return std::any_of(prim.edge.begin(), prim.edge.end(), [&](const spec::EdgeFunction& edge) {
      return (edge.a < 0) == falls_rightward && (edge.b <= 0) == falls_downward;
    });
  };
  return any(false, false) && any(true, true);
}

void see_walk(const SeenPrim& s, Hits* hits) {
  const int log2 = s.contract.design.tile_log2;
  const int wide = (s.prim.x1 >> log2) - (s.prim.x0 >> log2);
  const int high = (s.prim.y1 >> log2) - (s.prim.y0 >> log2);
  const int shape = wide == 0 ? (high == 0 ? 0 : 1) : (high == 0 ? 2 : 3);
  hits->add(2 * shape + (turns(s.prim) ? 1 : 0));
}

// Whether the walk passes over tiles of the box.
void see_passed_over(const SeenPrim& s, Hits* hits) {
  const int log2 = s.contract.design.tile_log2;
  const int wide = (s.prim.x1 >> log2) - (s.prim.x0 >> log2) + 1;
  const int high = (s.prim.y1 >> log2) - (s.prim.y0 >> log2) + 1;
  hits->add((turns(s.prim) ? 2 : 0) + (s.tiles_tested < wide * high ? 1 : 0));
}

// Masks: each lane alone, all but one corner, and how many.
void see_mask(const SeenStamp& s, Hits* hits) {
  const int lanes = s.contract.width.lanes;
  const uint32_t all = (uint32_t{1} << (lanes - 1) << 1) - 1;
  const int count = core::count_lanes(s.stamp.mask);
  hits->add(2 * lanes + count - 1);
  for (int lane = 0; lane < lanes; ++lane) {
    if (s.stamp.mask == uint32_t{1} << lane) hits->add(lane);
    if ((s.stamp.mask ^ all) == uint32_t{1} << lane) hits->add(lanes + lane);
  }
}
Bins masks(const Contract& c) {
  const int lanes = c.width.lanes;
  Bins bins = numbered(0, lanes - 1, "is the only lane");
  Bins but = numbered(0, lanes - 1, "is the only lane left out");
  const int width = 1 << c.design.stamp_width_log2;
  const int height = lanes / width;
  for (int lane = 0; lane < lanes; ++lane) {
    const int x = lane % width, y = lane / width;
    const bool is_between = (x > 0 && x < width - 1) || (y > 0 && y < height - 1);
    std::string* why = &but[static_cast<size_t>(lane)].unreachable;
    if (is_between) *why = "it lies between two lanes, and a triangle is convex";
    if (lanes == 1) *why = "an empty stamp is not sent";
  }
  return bins + but + numbered(1, lanes, "lanes");
}

void see_stamp_place(const SeenStamp& s, Hits* hits) {
  hits->add((s.stamp.y % rows(s.contract)) * columns(s.contract) + s.stamp.x % columns(s.contract));
}

}  // namespace

template <>
const std::vector<Point<SeenTile>>& points<SeenTile>() {
  static const std::vector<Point<SeenTile>> kPoints{
      {"tile", "what the edges say of a tile",
       [](const Contract&) {
         return named({"rejected", "tested by stamps", "accepted"});
       },
       see_tile},
      {"accepting_edges", "which edges accept a tile whole",
       [](const Contract&) {
         return named({"none", "0", "1", "0 and 1", "2", "0 and 2", "1 and 2", "all"});
       },
       [](const SeenTile& s, Hits* hits) {
         if (s.tile != nullptr) hits->add(s.tile->accepted);
       }},
      {"tile_margin", "E' of an edge at the corners that decide on a tile",
       [](const Contract&) {
         return named({"just not rejected", "just not accepted", "just accepted",
                       "just accepted, and so the tile"});
       },
       see_margin},
      {"tile_place", "length in bits of a tile's column and row",
       [](const Contract& c) {
         return product(named({"column", "row"}), numbered(0, c.width.tile_index, "bits"));
       },
       see_place},
      {"tile_box", "which sides of the box cut a tile",
       [](const Contract&) {
         return named({"left", "right", "top", "bottom", "none"});
       },
       see_box},
      {"stamp_box", "which sides of the box cut a stamp", box_in_stamp, see_box_in_stamp},
      {"edge_wrap", "E' of an edge at a tile that is kept",
       [](const Contract& c) {
         Bins bins = wrapping();
         if (c.design.perspective) bins[1].unreachable = "E' is not narrowed";
         return bins;
       },
       see_edge_wrap},
      {"depth_narrowing", "rounding of a depth plane for its tile",
       [](const Contract& c) { return where(c.design.depth_test, narrowings(c)); },
       see_depth_narrowing},
      {"attribute_narrowing", "rounding of an attribute's plane for its tile",
       [](const Contract& c) { return where(has_attribute_planes(c), narrowings(c)); },
       see_attribute_narrowing},
      {"depth_walk", "a depth plane at the first sample of a tile",
       [](const Contract& c) { return where(c.design.depth_test, wrapping()); }, see_depth_wrap},
      {"attribute_walk", "an attribute's plane at the first sample of a tile",
       [](const Contract& c) { return where(has_attribute_planes(c), wrapping()); },
       see_attribute_wrap},
  };
  return kPoints;
}

template <>
const std::vector<Point<SeenPrim>>& points<SeenPrim>() {
  static const std::vector<Point<SeenPrim>> kPoints{
      {"walk", "shape of a box in tiles, by the way its rows are walked",
       [](const Contract&) {
         return product(named({"one tile", "a column", "a row", "columns and rows"}),
                        named({"rightward", "leftward below the first row"}));
       },
       see_walk},
      {"passed_over", "tiles of the box that are not tested, by the way rows are walked",
       [](const Contract&) {
         return product(named({"rightward", "leftward below the first row"}),
                        named({"none", "some"}));
       },
       see_passed_over},
      {"prim_tiles", "tiles of a triangle that are kept",
       [](const Contract&) {
         return named({"none", "one", "two or more"});
       },
       [](const SeenPrim& s, Hits* hits) { hits->add(std::min(s.tiles_kept, 2)); }},
      {"prim_stamps", "stamps that a triangle sends",
       [](const Contract&) {
         return named({"none", "one", "two or more"});
       },
       [](const SeenPrim& s, Hits* hits) { hits->add(std::min(s.stamps, 2)); }},
  };
  return kPoints;
}

template <>
const std::vector<Point<SeenStamp>>& points<SeenStamp>() {
  static const std::vector<Point<SeenStamp>> kPoints{
      {"mask", "covered lanes of a stamp", masks, see_mask},
      {"stamp_place", "place of a stamp in its tile",
       [](const Contract& c) {
         return product(numbered(0, rows(c) - 1, "is the row"),
                        numbered(0, columns(c) - 1, "is the column"));
       },
       see_stamp_place},
      {"first", "whether a stamp is its tile's first",
       [](const Contract& c) {
         Bins bins = named({"first", "not first"});
         if (rows(c) * columns(c) == 1) bins[1].unreachable = "a tile is a stamp";
         return bins;
       },
       [](const SeenStamp& s, Hits* hits) { hits->add(s.stamp.first ? 0 : 1); }},
  };
  return kPoints;
}

}  // namespace pineda::vectors
