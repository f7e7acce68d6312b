// What the tests of model/core share: triangles to try, and checks against the exact judge.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "model/core/interp.h"
#include "model/core/setup.h"
#include "model/core/traversal.h"
#include "model/exact/exact.h"

namespace pineda::test {

inline constexpr spec::Contract kContract = spec::contract(spec::kHighTile);
inline constexpr int kPx = 1 << spec::kHighTile.subpixel_bits;  // subpixels of a pixel
inline constexpr int kHalfPx = kPx / 2;
inline constexpr int kGuardLow = -(1 << (kContract.width.coord - 1));
inline constexpr int kGuardHigh = -kGuardLow - 1;
inline constexpr int64_t kMaxDepthInput = ((int64_t{1} << 24) - 1) << 8;

/// The greatest frame: no test allocates it.
inline constexpr spec::FrameState kHugeFrame{16384, 16384, spec::Cull::kNone,
                                             spec::DepthFunc::kLess};
/// A small frame whose borders cut tiles and stamps, for triangles far greater than it.
inline constexpr spec::FrameState kWindow{67, 45, spec::Cull::kNone, spec::DepthFunc::kLess};

/// Draws numbers; the same ones on every platform.
class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}
  int64_t in(int64_t low, int64_t high) {  // both inclusive
    return low + static_cast<int64_t>(engine_() % static_cast<uint64_t>(high - low + 1));
  }
  int coordinate(int64_t low, int64_t high) { return static_cast<int>(in(low, high)); }
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  // [0, 1)

 private:
  std::mt19937_64 engine_;
};

/// A position in subpixels.
struct Point {
  int x;
  int y;
};

/// A triangle whose values are all 0.
spec::Triangle triangle(Point a, Point b, Point c);

/// Gives each vertex a depth and colours: each at an extreme or anywhere, at random.
void randomize_values(Random& random, spec::Triangle* t);

/// Classes of random triangles.
enum class Shape {
  k16Px,       // anywhere in the huge frame and over its borders
  k256Px,      // around the window
  k8192Px,     // an edge crosses the window
  kGuardBand,  // the same, corners anywhere in the guard band
  kNeedle,     // the same, 100-8000 px long, 1/16-2 px wide
  kSliver,     // doubled area of 1 to 4 units, a vertex on a pixel centre
};
spec::FrameState frame_of(Shape shape);
spec::Triangle random_triangle(Random& random, Shape shape);

/// d and w with cross(d, w) = 1, d of at most `reach` subpixels a side.
struct Lattice {
  Point d;
  Point w;
};
Lattice unit_lattice(Random& random, int reach);

exact::Judge judge(const spec::FrameState& frame, const spec::Triangle& t);

/// Calls visit(tile, stamp) for each stamp with a covered sample, in the unit's order.
template <class Visitor>
void for_each_stamp(const spec::SetupPrim& prim, Visitor&& visit) {
  core::TileWalk tiles(kContract, prim);
  core::Tile tile;
  for (auto test = tiles.next(&tile); test != core::TileWalk::Test::kEnd;
       test = tiles.next(&tile)) {
    if (test == core::TileWalk::Test::kRejected) continue;
    spec::Stamp stamp;
    stamp.id = tile.id;
    stamp.planes = tile.planes;
    core::StampWalk stamps(kContract, tile);
    while (stamps.next(&stamp.mask, &stamp.x, &stamp.y)) {
      if (stamp.mask != 0) visit(tile, stamp);
    }
  }
}

/// Calls visit(x, y, lane) for each covered sample of a stamp.
template <class Visitor>
void for_each_sample(const spec::Stamp& stamp, Visitor&& visit) {
  const int w_log2 = kContract.design.stamp_width_log2;
  const int h_log2 = kContract.design.stamp_height_log2;
  for (int lane = 0; lane < kContract.width.lanes; ++lane) {
    if ((stamp.mask >> lane & 1) == 0) continue;
    visit((stamp.x << w_log2) + (lane & ((1 << w_log2) - 1)),
          (stamp.y << h_log2) + (lane >> w_log2), static_cast<size_t>(lane));
  }
}

/// Empty when traversal covers just the judge's samples, each once, else the first difference.
std::string coverage_difference(const spec::SetupPrim& prim, const exact::Judge& judge);

/// The same for a triangle, dropped ones included.
std::string coverage_difference(const spec::FrameState& frame, const spec::Triangle& t);

/// Largest errors against the judge.
struct Errors {
  double depth_codes = 0;
  double attr_lsb = 0;
  int64_t samples = 0;
};

/// Adds the errors of a triangle's samples, of each `stride`-th stamp.
void measure(const spec::FrameState& frame, const spec::Triangle& t, Errors* errors,
             int stride = 1);

/// How an edge may treat samples on it; only kTopLeft is right. kShiftFirst is the top-left rule
/// with its bias applied after the shift, as a hasty reader of the rule would.
enum class Rule { kTopLeft, kInclusive, kStrict, kShiftFirst };

/// `prim` with the edges of `t` set up by `rule`: mutants that a check must catch.
spec::SetupPrim with_rule(spec::SetupPrim prim, const spec::Triangle& t, Rule rule);

/// How many triangles cover each sample of a frame.
class HitMap {
 public:
  explicit HitMap(const spec::FrameState& frame);
  void draw(const spec::Triangle& t, Rule rule = Rule::kTopLeft);
  int at(int x, int y) const {
    return hits_[static_cast<size_t>(y) * static_cast<size_t>(frame_.width) +
                 static_cast<size_t>(x)];
  }
  /// Samples hit `hits` times; -1: more than once.
  int count(int hits) const;

 private:
  spec::FrameState frame_;
  std::vector<int> hits_;
};

}  // namespace pineda::test
