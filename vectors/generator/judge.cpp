#include "vectors/generator/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/judge/comparison.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {
namespace {

using spec::Contract;
using Text = std::optional<std::string>;

constexpr int64_t kMaxSamples = 4096;
constexpr int kRows = 32;

// Judges one triangle.
class Hearing {
 public:
  Hearing(const Contract& c, const spec::FrameState& frame, const spec::Triangle& triangle,
          const spec::ErrorBounds& bounds)
      : c_(c),
        frame_(frame),
        triangle_(triangle),
        bounds_(bounds),
        truth_(c.design, frame, triangle),
        judge_(truth_.judge()) {
    drop_ = core::setup(c, frame, triangle, &prim_);
  }

  Text verdict() const {
    if (const Text text = drop()) return text;
    if (drop_ != core::Drop::kNone) return std::nullopt;
    if (const Text text = setup()) return text;
    return judge_.samples() <= kMaxSamples ? stamps() : std::nullopt;
  }

 private:
  Text drop() const {
    const bool by_judge = drop_ == core::Drop::kZeroArea || drop_ == core::Drop::kFacing;
    if (by_judge != judge_.culled()) return "culled by one of setup and judge only";
    if (drop_ != core::Drop::kNone && !judge_.culled() && judge_.samples() != 0) {
      return fmt::format("dropped ({}) with {} samples", core::drop_name(drop_), judge_.samples());
    }
    return std::nullopt;
  }

  // Judges rows of the box: the ends of each covered span, the samples beside them, and its middle.
  Text setup() const {
    const exact::Span rows = judge_.rows();
    if (rows.first <= rows.last && (rows.first < prim_.y0 || rows.last > prim_.y1)) {
      for (int y = rows.first; y <= rows.last; ++y) {
        const exact::Span span = judge_.span(y);
        if ((y < prim_.y0 || y > prim_.y1) && span.first <= span.last) {
          return fmt::format("row {} lies outside the box", y);
        }
      }
    }
    const int last = std::min(kRows, prim_.y1 - prim_.y0 + 1) - 1;
    for (int i = 0; i <= last; ++i) {
      const int y = last == 0
                        ? prim_.y0
                        : prim_.y0 + static_cast<int>(int64_t{prim_.y1 - prim_.y0} * i / last);
      if (const Text text = row(y)) return text;
    }
    return std::nullopt;
  }

  Text row(int y) const {
    const exact::Span span = judge_.span(y);
    const bool empty = span.first > span.last;
    if (!empty && (span.first < prim_.x0 || span.last > prim_.x1)) {
      return fmt::format("row {} reaches outside the box", y);
    }
    const int from = empty ? prim_.x0 : span.first;
    const int to = empty ? prim_.x1 : span.last;
    for (const int x : {from - 1, from, (from + to) / 2, to, to + 1}) {
      if (x < prim_.x0 || x > prim_.x1) continue;
      if (inside(x, y) != judge_.covers(x, y)) return fmt::format("edges at ({}, {})", x, y);
      if (!judge_.covers(x, y)) continue;
      if (const Text text = planes(x, y)) return text;
    }
    return std::nullopt;
  }

  // Pixels from the first sample of the box's first tile.
  int64_t from_x(int x) const {
    return x - (prim_.x0 >> c_.design.tile_log2 << c_.design.tile_log2);
  }
  int64_t from_y(int y) const {
    return y - (prim_.y0 >> c_.design.tile_log2 << c_.design.tile_log2);
  }

  bool inside(int x, int y) const {
    return std::all_of(prim_.edge.begin(), prim_.edge.end(), [&](const spec::EdgeFunction& edge) {
      return edge.e + from_x(x) * edge.a + from_y(y) * edge.b >= 0;
    });
  }

  // Judges setup's planes, before they are narrowed for a tile and without a bias.
  Text planes(int x, int y) const {
    if (c_.design.perspective) return std::nullopt;  // stamps() judges the values
    const auto value = [&](const spec::Plane& p, int bits, int out_bits) {
      const spec::int128_t sum =
          p.ref + spec::int128_t{p.dx} * from_x(x) + spec::int128_t{p.dy} * from_y(y);
      return std::clamp<int64_t>(
          spec::round_half_up(spec::wrap(sum, bits), c_.design.gradient_fraction_bits), 0,
          (int64_t{1} << out_bits) - 1);
    };
    judge::Drawn drawn{x, y, 0, {}};
    if (c_.design.depth_test) {
      drawn.z = value(prim_.planes.z, c_.width.depth_plane, c_.design.depth_bits);
    }
    const auto smooth = static_cast<size_t>(c_.design.attributes);
    for (size_t a = 0; a < smooth; ++a) {
      drawn.attr[a] = static_cast<int32_t>(
          value(prim_.planes.attr[a], c_.width.attr_plane, c_.design.attribute_bits));
    }
    const size_t channels = static_cast<size_t>(spec::channels(c_.design));
    for (size_t a = smooth; a < channels; ++a) drawn.attr[a] = prim_.planes.flat[a - smooth];
    const judge::Values values = judge::values_of(c_.design);
    const judge::Errors errors = truth_.errors(values, drawn);
    const auto beyond = judge::first_beyond(values, bounds_, errors);
    return beyond ? Text(judge::text_of(*beyond, errors, drawn)) : std::nullopt;
  }

  // Judges every sample that traversal sends, and that each is sent once. The bias is left to
  // tests/core.
  Text stamps() const {
    const judge::SnappedTruth truth(
        c_.design, frame_, triangle_,
        std::ldexp(static_cast<double>(prim_.planes.z_bias), -spec::kBiasFractionBits));
    judge::Verdict verdict;
    judge::Comparison comparison(judge::values_of(c_.design), &verdict);
    comparison.begin(truth, bounds_, triangle_.id);
    std::vector<int64_t> seen;
    for (const spec::Stamp& stamp : run_model(c_, TraversalCase{"", frame_, {prim_}, {}, {}}).out) {
      seen.push_back((int64_t{stamp.y} << 32) + stamp.x);
      spec::Fragment fragment;
      core::interpolate(c_, stamp, &fragment);
      judge::for_each_sample(c_.design, stamp, fragment,
                             [&](const judge::Drawn& drawn) { comparison.sample(drawn); });
    }
    comparison.end();
    if (verdict.first) return verdict.first->what;
    std::sort(seen.begin(), seen.end());
    if (std::adjacent_find(seen.begin(), seen.end()) != seen.end()) return "a stamp is sent twice";
    return std::nullopt;
  }

  const Contract& c_;
  spec::FrameState frame_;
  spec::Triangle triangle_;
  spec::ErrorBounds bounds_;
  judge::SnappedTruth truth_;  // without a bias
  const exact::Judge& judge_;
  spec::SetupPrim prim_;
  core::Drop drop_;
};

}  // namespace

std::optional<std::string> misjudged(const Contract& c, const Scene& scene,
                                     const spec::ErrorBounds& bounds) {
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const Hearing hearing(c, scene.frame, scene.triangles[i], bounds);
    if (const Text text = hearing.verdict()) {
      return fmt::format("scene {}, triangle {}: {}", scene.name, i, *text);
    }
  }
  return std::nullopt;
}

}  // namespace pineda::vectors
