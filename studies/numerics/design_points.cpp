#include "studies/numerics/design_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/judge/drawing.h"

namespace pineda::studies {
namespace {

exact::ScreenTriangle as_floats(const spec::Triangle& t, const spec::Design& d) {
  // Coordinates of 23 bits are floats without rounding. A float holds no z of 24.8 bits: the
  // vertex's depth is set to what the float snaps to.
  exact::ScreenTriangle screen;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& v = t.v[i];
    const double top = std::ldexp(1.0, d.depth_bits) - 1;
    screen[i].x = std::ldexp(static_cast<float>(v.x), -d.subpixel_bits);
    screen[i].y = std::ldexp(static_cast<float>(v.y), -d.subpixel_bits);
    screen[i].z = static_cast<float>(std::ldexp(static_cast<double>(v.z), -8) / top);
    for (size_t a = 0; a < 4; ++a) screen[i].rgba[a] = v.attr[a];
  }
  return screen;
}

void add(const DesignScorer& scorer, const char* shape, DesignPoint* to) {
  const Subject& s = scorer.subject();
  to->samples += s.judged + s.missing;
  to->wrong_samples += s.missing + s.extra;
  to->max_depth_ulp = std::max(to->max_depth_ulp, s.depth.max());
  to->max_color_lsb = std::max(to->max_color_lsb, s.color.max());
  if (s.holds()) return;
  to->broken.push_back(
      fmt::format("{}: {} missing, {} too many, depth {:.4f} ulp of {:.4f}, colour "
                  "{:.4f} LSB of {:.4f}",
                  shape, s.missing, s.extra, s.depth.max(), s.bounds->depth_ulp, s.color.max(),
                  s.bounds->attribute_lsb));
}

using Codes = std::vector<int64_t>;  // of the window, -1 where nothing is drawn

Codes codes_of(const spec::Contract& contract, const spec::FrameState& frame,
               const spec::Triangle& t) {
  const auto width = static_cast<size_t>(frame.width);
  Codes codes(width * static_cast<size_t>(frame.height), -1);
  judge::for_each_sample(contract, frame, t, [&](const judge::Drawn& s) {
    codes[static_cast<size_t>(s.y) * width + static_cast<size_t>(s.x)] = s.z;
  });
  return codes;
}

/// A triangle of some 300 px over the whole window and one inside it, on one steep plane.
std::pair<spec::Triangle, spec::Triangle> coplanar_pair(Random& random) {
  constexpr int kPx = 256;
  const int64_t gx = random.between(-16000, 16000);
  const int64_t gy = random.between(-16000, 16000);
  const int64_t middle = (int64_t{1} << 31) + random.between(0, 1 << 20);
  const auto on_plane = [&](Point a, Point b, Point c) {
    spec::Triangle t = triangle(a, b, c);
    for (auto& v : t.v) v.z = middle + gx * v.x + gy * v.y;
    return t;
  };
  const auto point = [&](int x0, int x1, int y0, int y1) {
    const int x = random.between(x0 * kPx, x1 * kPx);
    const int y = random.between(y0 * kPx, y1 * kPx);
    return Point{x, y};
  };
  const Point left = point(-150, -100, -60, -30);
  const Point right = point(170, 220, -60, -30);
  const Point below = point(10, 60, 150, 200);
  const Point a = point(0, 67, 0, 45);
  const Point b = point(0, 67, 0, 45);
  return {on_plane(left, right, below), on_plane(a, b, point(0, 67, 0, 45))};
}

}  // namespace

int64_t setup_product_bits(const spec::Design& d) {
  const spec::Widths w = spec::widths(d);
  const int64_t coordinate = w.edge_coeff;
  const int64_t k = d.reciprocal_bits;
  const auto plane = [&](int64_t in, int64_t numerator, int64_t bits) {
    return 4 * (in + 1) * coordinate + 2 * numerator * k +
           2 * (bits + d.subpixel_bits) * coordinate;
  };
  int64_t bits = 8 * coordinate * coordinate;
  bits += plane(w.depth_in, w.depth_numerator, w.depth_plane);
  bits += 4 * plane(d.attribute_bits, w.attr_numerator, w.attr_plane);
  if (spec::scheme_of(d).has_newton_steps) {
    bits += int64_t{2} * d.reciprocal_newton_steps * (k + 2) * (k + 2);
  }
  return bits;
}

std::vector<DesignPoint> study_design_points(const DesignPointOptions& options) {
  std::vector<DesignPoint> points;
  for (const spec::Design& d : options.designs) {
    points.emplace_back();
    points.back().design = d;
  }
  for (const Shape shape : kShapes) {
    const spec::FrameState frame = frame_of(shape);
    std::vector<std::unique_ptr<DesignScorer>> scorers;
    for (const auto& d : options.designs) {
      scorers.push_back(std::make_unique<DesignScorer>(d, frame, false));
    }
    Random random(options.seed);
    judge::ScreenTruth truth;
    for (int n = 0; n < options.triangles; ++n) {
      spec::Triangle t = random_triangle(random, shape);
      randomize_values(random, &t);
      const auto screen = as_floats(t, options.designs.front());
      const exact::ScreenJudge judge(screen, judge::format_of(options.designs.front()),
                                     judge::exact_frame(frame));
      for (size_t i = 0; i < 3; ++i) {
        t.v[i].z = judge.snapped().vertices()[i].z;
        t.v[i].inverse_w = 1 << (options.designs.front().inverse_w_bits - 1);  // w = 1
      }
      truth.judge(judge);
      for (const auto& scorer : scorers) scorer->score(t, truth);
      if (options.progress) options.progress(shape_name(shape), static_cast<uint64_t>(n));
    }
    for (size_t i = 0; i < points.size(); ++i) add(*scorers[i], shape_name(shape), &points[i]);
  }
  for (DesignPoint& p : points) p.coplanar = coplanar_difference(p.design, 200, options.seed);
  return points;
}

double coplanar_difference(const spec::Design& design, int pairs, uint64_t seed) {
  const spec::FrameState frame{67, 45, spec::Cull::kNone, spec::DepthFunc::kOff};
  const spec::Contract contract = spec::contract(design);
  Random random(seed);
  uint64_t compared = 0;
  uint64_t different = 0;
  for (int n = 0; n < pairs; ++n) {
    const auto [outer, inner] = coplanar_pair(random);
    const Codes first = codes_of(contract, frame, outer);
    const Codes second = codes_of(contract, frame, inner);
    for (size_t i = 0; i < first.size(); ++i) {
      if (first[i] < 0 || second[i] < 0) continue;
      ++compared;
      different += first[i] != second[i] ? 1 : 0;
    }
  }
  return compared == 0 ? 0 : static_cast<double>(different) / static_cast<double>(compared);
}

const std::vector<PrototypePoint>& prototype_points() {
  static const std::vector<PrototypePoint> all{
      {"low", 18.0e3, 36, 90.6, 19.4, .64},      {"med", 19.7e3, 40, 6.9, 1.56, .16},
      {"med_plus", 21.7e3, 42, .88, .79, .0095}, {"high", 25.6e3, 44, .544, .549, .0013},
      {"high_tile", 25.6e3, 34, .555, .559, 0},  {"high_plus", 26.9e3, 46, .515, .513, .0010},
      {"div28", 21.2e3, 44, .573, .549, .0024},  {"exact", 0, 82, .5, .5, 0},
  };
  return all;
}

}  // namespace pineda::studies
