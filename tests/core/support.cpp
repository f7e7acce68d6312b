#include "tests/core/support.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pineda::test {

exact::Judge judge(const spec::FrameState& frame, const spec::Triangle& t) {
  exact::Triangle v;
  for (size_t i = 0; i < 3; ++i) {
    const auto& attr = t.v[i].attr;
    v[i] = {t.v[i].x, t.v[i].y, t.v[i].z, {attr.begin(), attr.begin() + 4}};
  }
  const auto cull = frame.cull == spec::Cull::kNone   ? exact::Cull::kNone
                    : frame.cull == spec::Cull::kBack ? exact::Cull::kBack
                                                      : exact::Cull::kFront;
  return {v, kContract.design.subpixel_bits, frame.width, frame.height, cull};
}

std::string coverage_difference(const spec::SetupPrim& prim, const exact::Judge& judge) {
  const auto at = [](int x, int y) { return std::to_string(x) + "," + std::to_string(y); };
  const int width = prim.x1 - prim.x0 + 1;
  std::vector<char> hit(static_cast<size_t>(width) * static_cast<size_t>(prim.y1 - prim.y0 + 1));
  std::string difference;
  int64_t samples = 0;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    for_each_sample(stamp, [&](int x, int y, size_t) {
      ++samples;
      if (x < prim.x0 || x > prim.x1 || y < prim.y0 || y > prim.y1) {
        difference = "outside the box: " + at(x, y);
      } else if (char& h = hit[static_cast<size_t>((y - prim.y0) * width + x - prim.x0)]; h != 0) {
        difference = "sent twice: " + at(x, y);
      } else {
        h = 1;
      }
    });
  });
  if (!difference.empty()) return difference;
  for (int y = prim.y0; y <= prim.y1; ++y) {
    const exact::Span span = judge.span(y);
    for (int x = prim.x0; x <= prim.x1; ++x) {
      const bool wanted = span.first <= x && x <= span.last;
      const bool got = hit[static_cast<size_t>((y - prim.y0) * width + x - prim.x0)] != 0;
      if (got != wanted) return (wanted ? "missing: " : "extra: ") + at(x, y);
    }
  }
  // The box held all that was wanted.
  if (samples == judge.samples()) return {};
  return "outside the box: " + std::to_string(judge.samples() - samples) + " samples missing";
}

std::string coverage_difference(const spec::FrameState& frame, const spec::Triangle& t) {
  const exact::Judge exact = judge(frame, t);
  spec::SetupPrim prim;
  const core::Drop drop = core::setup(kContract, frame, t, &prim);
  const bool culled = drop == core::Drop::kZeroArea || drop == core::Drop::kFacing;
  if (culled != exact.culled()) return culled ? "culled" : "not culled";
  if (drop == core::Drop::kNone) return coverage_difference(prim, exact);
  return exact.samples() == 0 ? "" : std::string("dropped: ") + core::drop_name(drop);
}

void measure(const spec::FrameState& frame, const spec::Triangle& t, Errors* errors, int stride) {
  spec::SetupPrim prim;
  if (core::setup(kContract, frame, t, &prim) != core::Drop::kNone) return;
  const exact::Judge exact = judge(frame, t);
  int turn = 0;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    if (turn++ % stride != 0) return;
    spec::Fragment fragment;
    core::interpolate(kContract, stamp, &fragment);
    for_each_sample(stamp, [&](int x, int y, size_t lane) {
      ++errors->samples;
      errors->depth_codes =
          std::max(errors->depth_codes, std::abs(exact.depth_error(x, y, fragment.z[lane])));
      for (int a = 0; a < kContract.design.attributes; ++a) {
        const double error =
            exact.attribute_error(x, y, a, fragment.attr[lane][static_cast<size_t>(a)]);
        errors->attr_lsb = std::max(errors->attr_lsb, std::abs(error));
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
    // A rule that counts samples on right and bottom edges needs the box to reach them.
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
