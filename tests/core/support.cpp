#include "tests/core/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pineda::test {

std::string coverage_difference(const spec::SetupPrim& prim, const judge::SnappedTruth& truth) {
  judge::Seen seen;
  seen.begin(truth);
  std::string difference;
  const auto note = [&](const char* what, int x, int y) {
    if (difference.empty()) difference = fmt::format("{}: {},{}", what, x, y);
  };
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    for_each_sample(stamp, [&](int x, int y, size_t) {
      const judge::Found found = seen.draw(x, y);
      if (found == judge::Found::kExtra) note("extra", x, y);
      if (found == judge::Found::kTwice) note("sent twice", x, y);
      if (x < prim.x0 || x > prim.x1 || y < prim.y0 || y > prim.y1) note("outside the box", x, y);
    });
  });
  seen.for_each_missing([&](int x, int y) { note("missing", x, y); });
  return difference;
}

std::string coverage_difference(const spec::FrameState& frame, const spec::Triangle& t) {
  const judge::SnappedTruth truth(kContract.design, frame, t);
  spec::SetupPrim prim;
  const core::Drop drop = core::setup(kContract, frame, t, &prim);
  const bool culled = drop == core::Drop::kZeroArea || drop == core::Drop::kFacing;
  if (culled != truth.judge().culled()) return culled ? "culled" : "not culled";
  if (drop == core::Drop::kNone) return coverage_difference(prim, truth);
  return truth.judge().samples() == 0 ? "" : std::string("dropped: ") + core::drop_name(drop);
}

void measure(const spec::FrameState& frame, const spec::Triangle& t, Errors* errors, int stride) {
  spec::SetupPrim prim;
  if (core::setup(kContract, frame, t, &prim) != core::Drop::kNone) return;
  const judge::SnappedTruth truth(kContract.design, frame, t);
  const judge::Values values = judge::values_of(kContract.design);
  int turn = 0;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    if (turn++ % stride != 0) return;
    spec::Fragment fragment;
    core::interpolate(kContract, stamp, &fragment);
    judge::for_each_sample(kContract.design, stamp, fragment, [&](const judge::Drawn& drawn) {
      ++errors->samples;
      const judge::Errors e = truth.errors(values, drawn);
      errors->depth_codes = std::max(errors->depth_codes, std::abs(e.depth.units));
      for (const judge::Error& attribute : e.attr) {
        errors->attr_lsb = std::max(errors->attr_lsb, std::abs(attribute.units));
      }
    });
  });
}

spec::SetupPrim with_rule(spec::SetupPrim prim, const spec::Triangle& t, Rule rule) {
  std::array<spec::Vertex, 3> v = t.v;
  const auto cross = [](const spec::Vertex& o, const spec::Vertex& p, int64_t x, int64_t y) {
    return (int64_t{p.x} - o.x) * (y - o.y) - (x - o.x) * (int64_t{p.y} - o.y);
  };
  if (cross(v[0], v[1], v[2].x, v[2].y) < 0) std::swap(v[1], v[2]);
  const int64_t x = (prim.x0 & ~7) * int64_t{kPx} + kHalfPx;
  const int64_t y = (prim.y0 & ~7) * int64_t{kPx} + kHalfPx;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& from = v[i];
    const spec::Vertex& to = v[(i + 1) % 3];
    const bool top_left = to.y < from.y || (to.y == from.y && to.x > from.x);
    const int64_t e = cross(from, to, x, y);
    const int64_t bias = rule == Rule::kInclusive || (rule != Rule::kStrict && top_left) ? 0 : 1;
    prim.edge[i].a = int64_t{from.y} - to.y;
    prim.edge[i].b = int64_t{to.x} - from.x;
    prim.edge[i].e = rule == Rule::kShiftFirst ? (e >> 8) - bias : (e - bias) >> 8;
  }
  return prim;
}

HitMap::HitMap(const spec::FrameState& frame)
    : frame_(frame), hits_(static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height)) {}

void HitMap::draw(const spec::Triangle& t, Rule rule) {
  spec::SetupPrim prim;
  if (core::setup(kContract, frame_, t, &prim) != core::Drop::kNone) return;
  if (rule != Rule::kTopLeft) {
    // The mutant rules count samples on right and bottom edges, so the box must include these.
    prim = with_rule(prim, t, rule);
    prim.x1 = std::min(prim.x1 + 1, frame_.width - 1);
    prim.y1 = std::min(prim.y1 + 1, frame_.height - 1);
  }
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    for_each_sample(stamp, [&](int x, int y, size_t) {
      ++hits_[static_cast<size_t>(y) * static_cast<size_t>(frame_.width) + static_cast<size_t>(x)];
    });
  });
}

int HitMap::count(int hits) const {
  return static_cast<int>(std::count_if(hits_.begin(), hits_.end(),
                                        [=](int h) { return hits < 0 ? h > 1 : h == hits; }));
}

}  // namespace pineda::test
