#include "tests/baseline/support.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pineda::test {

using baseline::Baseline;
using baseline::Sample;

const Baseline& find_baseline(const std::string& name) {
  for (const Baseline& b : baseline::baselines()) {
    if (b.name == name) return b;
  }
  throw std::out_of_range("no baseline " + name);
}

std::vector<Sample> samples_of(const std::string& name, const spec::FrameState& frame,
                               const spec::Triangle& t) {
  Gathered gathered;
  find_baseline(name).make(kContract, frame)->draw(t, &gathered);
  return gathered.samples;
}

void judge_samples(const spec::FrameState& frame, const spec::Triangle& t,
                   const std::vector<Sample>& samples, Verdict* verdict, int subpixel_bits) {
  spec::Design design = spec::kHighTile;
  design.subpixel_bits = subpixel_bits;
  const judge::SnappedTruth truth(design, frame, t);
  judge::Seen seen;
  seen.begin(truth);
  const int64_t before = verdict->faults();
  for (const Sample& s : samples) {
    const judge::Found found = seen.draw(s.x, s.y);
    verdict->twice += found == judge::Found::kTwice ? 1 : 0;
    verdict->extra += found == judge::Found::kExtra ? 1 : 0;
    if (found != judge::Found::kRight) continue;
    judge::Drawn drawn{s.x, s.y, s.z, {}};
    std::copy(s.rgba.begin(), s.rgba.end(), drawn.attr.begin());
    const judge::Errors errors = truth.errors(judge::values_of(design), drawn);
    verdict->depth_ulp = std::max(verdict->depth_ulp, std::abs(errors.depth.units));
    for (const judge::Error& error : errors.attr) {
      verdict->color_lsb = std::max(verdict->color_lsb, std::abs(error.units));
    }
  }
  seen.for_each_missing([&](int, int) { ++verdict->missing; });
  const int64_t wanted = truth.judge().samples();
  verdict->wanted += wanted;
  verdict->triangles += wanted > 0 ? 1 : 0;
  verdict->wrong += verdict->faults() != before ? 1 : 0;
}

Verdict judge_random(const std::string& name, Shape shape, int count, uint64_t seed) {
  Verdict verdict;
  Random random(seed);
  const auto rasterizer = find_baseline(name).make(kContract, frame_of(shape));
  for (int n = 0; n < count; ++n) {
    spec::Triangle t = random_triangle(random, shape);
    randomize_values(random, &t);
    Gathered gathered;
    rasterizer->draw(t, &gathered);
    judge_samples(frame_of(shape), t, gathered.samples, &verdict);
  }
  return verdict;
}

const std::vector<std::string>& exact_baselines() {
  static const std::vector<std::string> kNames{"edge_walk",
                                               "edge_flat",
                                               "edge_smooth",
                                               "fp64",
                                               "painter",
                                               "barycentric",
                                               "barycentric_incremental",
                                               "subdivision"};
  return kNames;
}

spec::Triangle triangle_in(Random& random, int size_px) {
  std::array<Point, 3> p;
  for (Point& q : p) {
    q.x = random.between(0, size_px * kPx);
    q.y = random.between(0, size_px * kPx);
  }
  spec::Triangle t = triangle(p[0], p[1], p[2]);
  randomize_values(random, &t);
  return t;
}

std::vector<spec::Triangle> lattice_mesh(Random& random, int size_px) {
  constexpr int kSpacing = 13;  // half pixels
  const int quads = (2 * size_px - 2) / kSpacing;
  std::vector<Point> corner;
  for (int j = 0; j <= quads; ++j) {
    for (int i = 0; i <= quads; ++i) {
      const auto place = [&](int k, bool rim) {
        const int jitter = random.between(-3, 3);
        return k == 0       ? kPx
               : k == quads ? (size_px - 1) * kPx
                            : kPx + (k * kSpacing + (rim ? 0 : jitter)) * kHalfPx;
      };
      const bool rim = i == 0 || j == 0 || i == quads || j == quads;
      const int x = place(i, rim);
      const int y = place(j, rim);
      corner.push_back({x, y});
    }
  }
  std::vector<spec::Triangle> mesh;
  for (int j = 0; j < quads; ++j) {
    for (int i = 0; i < quads; ++i) {
      const auto at = [&](int di, int dj) {
        return corner[static_cast<size_t>((j + dj) * (quads + 1) + i + di)];
      };
      const bool falling = random.between(0, 1) != 0;
      const Point p = falling ? at(0, 0) : at(1, 0);
      const Point q = falling ? at(1, 1) : at(0, 1);
      mesh.push_back(triangle(p, q, falling ? at(1, 0) : at(0, 0)));
      mesh.push_back(triangle(q, falling ? at(0, 1) : at(1, 1), p));
    }
  }
  return mesh;
}

int Hits::doubles() const {
  return static_cast<int>(std::count_if(hits_.begin(), hits_.end(), [](int h) { return h > 1; }));
}

int Hits::holes() const {
  int holes = 0;
  for (int y = 1; y < size_ - 1; ++y) {
    for (int x = 1; x < size_ - 1; ++x) holes += at(x, y) == 0 ? 1 : 0;
  }
  return holes;
}

Hits hits_of(const std::string& name, const std::vector<spec::Triangle>& mesh, int size_px) {
  const spec::FrameState frame{size_px, size_px, spec::Cull::kNone, spec::DepthFunc::kLess};
  const auto rasterizer = find_baseline(name).make(kContract, frame);
  Hits hits(size_px);
  for (const spec::Triangle& t : mesh) {
    Gathered gathered;
    rasterizer->draw(t, &gathered);
    for (const Sample& s : gathered.samples) hits.add(s.x, s.y);
  }
  return hits;
}

}  // namespace pineda::test
