// What the tests of model/core share: triangles to try, and checks against the exact judge.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/core/interp.h"
#include "model/core/setup.h"
#include "model/core/traversal.h"
#include "model/judge/comparison.h"
#include "studies/numerics/random_triangles.h"

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

using studies::frame_of;
using studies::Lattice;
using studies::Point;
using studies::Random;
using studies::random_triangle;
using studies::randomize_values;
using studies::Shape;
using studies::triangle;
using studies::unit_lattice;

inline exact::Judge judge(const spec::FrameState& frame, const spec::Triangle& t) {
  return judge::exact_judge(kContract.design, frame, t);
}
inline judge::SnappedTruth truth(const spec::FrameState& frame, const spec::Triangle& t) {
  return {kContract.design, frame, t};
}

/// Calls visit(x, y, lane) for each covered sample of a stamp.
template <class Visitor>
void for_each_sample(const spec::Stamp& stamp, Visitor&& visit) {
  judge::for_each_lane(kContract.design, stamp, visit);
}

/// Empty when traversal covers just the triangle's samples, each once, and within the box, else the
/// first difference.
std::string coverage_difference(const spec::SetupPrim& prim, const judge::SnappedTruth& truth);

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

/// How an edge treats samples on it; only kTopLeft is right. kShiftFirst is the top-left rule with
/// its bias added after the shift, which is an easy mistake.
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
