#include "vectors/generator/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/core/frame.h"
#include "model/exact/exact.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {
namespace {

using spec::Contract;
using Text = std::optional<std::string>;

constexpr int64_t kMaxSamples = 4096;
constexpr int kRows = 32;

exact::Judge judge_of(const Contract& c, const spec::FrameState& frame, const spec::Triangle& t) {
  exact::Triangle triangle;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& v = t.v[i];
    // Flat shading: the first vertex's attributes everywhere.
    const auto& attr = (frame.shade == spec::Shade::kFlat ? t.v[0] : v).attr;
    triangle[i] = {v.x, v.y, v.z, {attr.begin(), attr.begin() + c.design.attributes}};
  }
  exact::Frame exact{frame.width, frame.height, static_cast<exact::Cull>(frame.cull)};
  exact.x0 = frame.scissor_x0;
  exact.y0 = frame.scissor_y0;
  exact.x1 = frame.scissor_x1;
  exact.y1 = frame.scissor_y1;
  return exact::Judge(triangle, c.design.subpixel_bits, exact);
}

// One triangle before its judge.
class Hearing {
 public:
  Hearing(const Contract& c, const spec::FrameState& frame, const spec::Triangle& triangle,
          const Bounds& bounds)
      : c_(c),
        frame_(frame),
        triangle_(triangle),
        bounds_(bounds),
        judge_(judge_of(c, frame, triangle)) {
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

  // Rows of the box: the ends of each covered span, the samples beside them, and its middle.
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

  // The planes of setup, before they are narrowed for a tile and without a bias.
  Text planes(int x, int y) const {
    if (c_.design.perspective) return std::nullopt;  // stamps() judges what it makes of the edges
    const auto value = [&](const spec::Plane& p, int bits, int out_bits) {
      const spec::int128_t sum =
          p.ref + spec::int128_t{p.dx} * from_x(x) + spec::int128_t{p.dy} * from_y(y);
      return std::clamp<int64_t>(
          spec::round_half_up(spec::wrap(sum, bits), c_.design.gradient_fraction_bits), 0,
          (int64_t{1} << out_bits) - 1);
    };
    std::array<int64_t, spec::kMaxAttributes> attr{};
    for (size_t a = 0; a < static_cast<size_t>(c_.design.attributes); ++a) {
      attr[a] = value(prim_.planes.attr[a], c_.width.attr_plane, c_.design.attribute_bits);
    }
    const int64_t z = c_.design.depth_test
                          ? value(prim_.planes.z, c_.width.depth_plane, c_.design.depth_bits)
                          : 0;
    return values(x, y, z, 0, attr);
  }

  // `bias` is the one that setup found, in codes: whether it is right, tests/core says.
  template <class Attributes>
  Text values(int x, int y, int64_t z, double bias, const Attributes& attr) const {
    const double depth = c_.design.depth_test ? judge_.depth_error(x, y, z) - bias : 0;
    const bool clamped = bias > 0 ? z == (int64_t{1} << c_.design.depth_bits) - 1 && depth < 0
                                  : bias < 0 && z == 0 && depth > 0;
    if (std::fabs(depth) > bounds_.depth_codes && !clamped) {
      return fmt::format("depth at ({}, {}) is {} codes off", x, y, depth);
    }
    for (int a = 0; a < c_.design.attributes; ++a) {
      const double error = c_.design.perspective
                               ? perspective_error(x, y, a, attr[static_cast<size_t>(a)])
                               : judge_.attribute_error(x, y, a, attr[static_cast<size_t>(a)]);
      if (std::fabs(error) > bounds_.attribute_lsb) {
        return fmt::format("attribute {} at ({}, {}) is {} LSB off", a, x, y, error);
      }
    }
    return std::nullopt;
  }

  // Against weights in exact integers, times 1/w as the vertices have it; then in long doubles.
  double perspective_error(int x, int y, int attribute, int64_t value) const {
    const auto weights = judge_.weights(x, y);
    long double sum = 0;
    long double total = 0;
    for (size_t i = 0; i < 3; ++i) {
      const spec::Vertex& v = triangle_.v[i];
      const long double weight =
          std::ldexp(static_cast<long double>(weights[i]) * v.inverse_w, -v.inverse_w_shift);
      total += weight;
      sum += weight * judge_.vertices()[i].attr[static_cast<size_t>(attribute)];
    }
    return static_cast<double>(static_cast<long double>(value) - sum / total);
  }

  // Every sample that traversal sends, and that it sends as many as there are, each once.
  Text stamps() const {
    int64_t samples = 0;
    std::vector<int64_t> seen;
    for (const spec::Stamp& stamp : run_model(c_, TraversalCase{"", frame_, {prim_}, {}}).out) {
      seen.push_back((int64_t{stamp.y} << 32) + stamp.x);
      spec::Fragment fragment;
      core::interpolate(c_, stamp, &fragment);
      for (int lane = 0; lane < c_.width.lanes; ++lane) {
        if ((stamp.mask >> lane & 1) == 0) continue;
        const int w_log2 = c_.design.stamp_width_log2;
        const int x = (stamp.x << w_log2) + (lane & ((1 << w_log2) - 1));
        const int y = (stamp.y << c_.design.stamp_height_log2) + (lane >> w_log2);
        if (!judge_.covers(x, y)) return fmt::format("sample ({}, {}) is not covered", x, y);
        ++samples;
        const auto l = static_cast<size_t>(lane);
        const double bias =
            std::ldexp(static_cast<double>(stamp.planes.z_bias), -spec::kBiasFractionBits);
        if (const Text text = values(x, y, fragment.z[l], bias, fragment.attr[l])) return text;
      }
    }
    std::sort(seen.begin(), seen.end());
    if (std::adjacent_find(seen.begin(), seen.end()) != seen.end()) return "a stamp is sent twice";
    if (samples == judge_.samples()) return std::nullopt;
    return fmt::format("{} samples are sent of {}", samples, judge_.samples());
  }

  const Contract& c_;
  spec::FrameState frame_;
  spec::Triangle triangle_;
  Bounds bounds_;
  exact::Judge judge_;
  spec::SetupPrim prim_;
  core::Drop drop_;
};

}  // namespace

std::optional<std::string> misjudged(const Contract& c, const Scene& scene, const Bounds& bounds) {
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const Hearing hearing(c, scene.frame, scene.triangles[i], bounds);
    if (const Text text = hearing.verdict()) {
      return fmt::format("scene {}, triangle {}: {}", scene.name, i, *text);
    }
  }
  return std::nullopt;
}

}  // namespace pineda::vectors
