#include "studies/needs/scene_use.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/judge/visible_frame.h"
#include "studies/judge/scene_truth.h"

namespace pineda::studies {
namespace {

/// Depth bits that hold a float's depth nearly exactly: with 8 fraction bits, to 2^-41. With a
/// depth bias the base's own bits, since the bias is in its codes.
int exact_depth_bits(const spec::Design& base, const spec::FrameState& frame) {
  return frame.has_bias() ? base.depth_bits : 32;
}

/// A depth from the judge, which divides once: equal depths may differ by 2^-53 code.
struct Depth {
  int64_t whole;
  double fraction;
};
double difference(const Depth& a, const Depth& b) {
  const double codes = static_cast<double>(a.whole - b.whole) + (a.fraction - b.fraction);
  constexpr double kNone = 0x1p-32;
  return std::abs(codes) < kNone ? 0 : codes;
}

/// The cleared depth, rounded as the judge rounds a vertex's z, so that a triangle at that depth is
/// equal to it.
Depth cleared_depth(const spec::FrameState& frame, int depth_bits) {
  bool clamped = false;
  const int64_t units =
      exact::depth_input(static_cast<float>(frame.clear_depth), depth_bits, &clamped);
  return {units >> 8, static_cast<double>(units & 255) / 256};
}

/// Collects what a scene uses while drawing it with exact depths.
class Gatherer {
 public:
  Gatherer(const spec::Contract& base, const spec::FrameState& frame, SceneUse* use,
           Winners* winners)
      : base_(base),
        frame_(frame),
        top_code_((int64_t{1} << exact_depth_bits(base.design, frame)) - 1),
        use_(*use),
        winners_(*winners) {
    const size_t pixels = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
    winners_.assign(pixels, 0);
    depth_.assign(pixels, cleared_depth(frame, exact_depth_bits(base.design, frame)));
    hits_.assign(pixels, 0);
    use_.guard_bits =
        std::max(4, spec::ceil_log2(static_cast<uint64_t>(std::max(frame.width, frame.height))));
  }

  void triangle(const spec::Triangle& t, const exact::ScreenJudge& judge,
                const scene::ScreenTriangle& screen);
  void finish();

 private:
  void positions(const spec::Triangle& t);
  void extent(const spec::Triangle& t);
  void colors(const scene::ScreenTriangle& screen);
  void sample(const exact::Sample& sample);

  const spec::Contract& base_;
  spec::FrameState frame_;
  int64_t top_code_;
  SceneUse& use_;
  Winners& winners_;
  std::vector<Depth> depth_;
  std::vector<uint32_t> hits_;
  judge::ScreenTruth truth_;
};

void Gatherer::positions(const spec::Triangle& t) {
  const int s = base_.design.subpixel_bits;
  for (const spec::Vertex& v : t.v) {
    for (const int32_t c : {v.x, v.y}) {
      // -2^g fits into g bits, 2^g does not.
      const auto reach = static_cast<uint64_t>(c < 0 ? ~c : c);
      use_.guard_bits = std::max(use_.guard_bits, spec::bit_length(reach) - s);
    }
  }
}

void Gatherer::extent(const spec::Triangle& t) {
  const double px = std::ldexp(1.0, -base_.design.subpixel_bits);
  const auto [x_low, x_high] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
  const auto [y_low, y_high] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  const double width = px * (double{1} * x_high - x_low);
  const double height = px * (double{1} * y_high - y_low);
  const bool is_first = use_.dropped[0] == 1;
  const auto lower = [&](double* to, double v) { *to = is_first ? v : std::min(*to, v); };
  const auto raise = [&](double* to, double v) { *to = is_first ? v : std::max(*to, v); };
  lower(&use_.x_low_px, px * x_low);
  lower(&use_.y_low_px, px * y_low);
  raise(&use_.x_high_px, px * x_high);
  raise(&use_.y_high_px, px * y_high);
  raise(&use_.widest_px, width);
  raise(&use_.tallest_px, height);
  raise(&use_.farthest_px, width + height);
}

void Gatherer::colors(const scene::ScreenTriangle& screen) {
  const auto& v = screen.v;
  bool varies = false;
  for (size_t c = 0; c < 4; ++c) {
    const int first = v[0].rgba[c];
    const bool in_triangle =
        frame_.shade == spec::Shade::kSmooth && (v[1].rgba[c] != first || v[2].rgba[c] != first);
    if (use_.dropped[0] == 1) use_.color_value[c] = first;
    const auto kind = in_triangle                    ? Variation::kVaries
                      : first != use_.color_value[c] ? Variation::kFlat
                                                     : Variation::kConstant;
    use_.color[c] = std::max(use_.color[c], kind);
    varies = varies || in_triangle;
  }
  const bool perspective = v[0].w != v[1].w || v[1].w != v[2].w;
  use_.perspective_triangles += varies && perspective ? 1 : 0;
  for (const auto& vertex : v) {
    const double z = std::clamp(double{vertex.z}, 0., 1.);
    use_.depth_low = std::min(use_.depth_low, z);
    use_.depth_high = std::max(use_.depth_high, z);
  }
}

void Gatherer::sample(const exact::Sample& s) {
  const size_t i =
      static_cast<size_t>(s.y) * static_cast<size_t>(frame_.width) + static_cast<size_t>(s.x);
  ++use_.samples;
  use_.covered += hits_[i] == 0 ? 1 : 0;
  use_.most_hits = std::max<uint64_t>(use_.most_hits, ++hits_[i]);
  const bool is_tested = frame_.depth != spec::DepthFunc::kOff;
  const Depth depth{s.z.whole, s.z.fraction};
  const double gap = difference(depth, depth_[i]);
  if (is_tested && winners_[i] != 0) {
    const double part = std::abs(gap) / static_cast<double>(top_code_);
    ++use_.compared;
    if (gap == 0) ++use_.equal;
    if (gap != 0 && (use_.least_gap == 0 || part < use_.least_gap)) use_.least_gap = part;
  }
  if (!judge::passes(frame_.depth, gap < 0 ? -1 : gap > 0 ? 1 : 0)) return;
  winners_[i] = static_cast<uint32_t>(use_.triangles);
  if (is_tested && frame_.depth_write) depth_[i] = depth;
}

void Gatherer::triangle(const spec::Triangle& t, const exact::ScreenJudge& judge,
                        const scene::ScreenTriangle& screen) {
  ++use_.triangles;
  positions(t);
  spec::SetupPrim prim;
  const core::Drop drop = core::setup(base_, frame_, t, &prim);
  ++use_.dropped[static_cast<size_t>(drop)];
  if (drop != core::Drop::kNone) return;
  extent(t);
  const double area2 = std::abs(static_cast<double>(judge.snapped().doubled_area()));
  use_.largest_area_px2 =
      std::max(use_.largest_area_px2, std::ldexp(area2, -2 * base_.design.subpixel_bits - 1));
  colors(screen);
  for_each_band(judge, frame_.width, base_.design.tile_log2, [&](int, int, exact::Span rows) {
    truth_.judge(judge, rows);
    for (const exact::Sample& s : truth_.samples()) sample(s);
  });
}

void Gatherer::finish() {
  if (use_.dropped[0] == 0) use_.depth_low = 0;
}

}  // namespace

const char* variation_name(Variation variation) {
  static constexpr const char* kNames[] = {"constant everywhere", "constant in a triangle",
                                           "varying in a triangle"};
  return kNames[static_cast<int>(variation)];
}

int SceneUse::gap_bits() const {
  return least_gap == 0 ? 0 : static_cast<int>(std::ceil(-std::log2(least_gap)));
}

SceneUse scene_use(const scene::Scene& scene, const spec::Contract& base, Winners* winners) {
  SceneUse use;
  Gatherer gatherer(base, scene.frame, &use, winners);
  exact::Format format = judge::format_of(base.design);
  format.depth_bits = exact_depth_bits(base.design, scene.frame);
  format.attributes = 0;  // only the vertices' colours are looked at
  for_each_judged(scene, base, format, [&](const spec::Triangle& t, const exact::ScreenJudge& j) {
    gatherer.triangle(t, j, scene.source->screen());
    return true;
  });
  gatherer.finish();
  return use;
}

}  // namespace pineda::studies
