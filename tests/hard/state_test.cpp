// The right answers of the cases of raster state.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "model/spec/bounds.h"
#include "tests/core/support.h"
#include "tests/hard/support.h"

namespace pineda::hard {
namespace {

using spec::DepthFunc;
using test::kContract;

constexpr int64_t kFarCode = (1 << 24) - 1;

TEST(Scissor, HitsEverySampleInsideOnceAndNoneOutside) {
  const Snapped scene = snapped("scissor");
  const auto& f = scene.frame;
  const auto hits = drawn(scene).buffer().hits;
  for (int y = 0; y < f.height; ++y) {
    for (int x = 0; x < f.width; ++x) {
      const bool inside = x >= 13 && x < 51 && y >= 7 && y < 36;
      ASSERT_EQ(hits[static_cast<size_t>(y * f.width + x)], inside ? 1 : 0) << x << "," << y;
    }
  }
  // Some triangles are dropped by the scissored box alone; without the scissor they are drawn.
  Snapped whole = scene;
  whole.frame = {f.width, f.height};
  const auto outside = static_cast<size_t>(core::Drop::kOutside);
  EXPECT_GT(drawn(scene).counters().dropped[outside],
            drawn(whole).counters().dropped[outside] + 20);
  const auto all = drawn(whole).buffer().hits;
  EXPECT_EQ(std::count(all.begin(), all.end(), 1), f.width * f.height);
}

/// The expected frame: depth and colour are constant in each triangle, so coverage and the depth
/// function determine it.
struct Seen {
  std::vector<int64_t> z;
  std::vector<size_t> triangle;  // SIZE_MAX: none
  int replaced = 0;
  int refused = 0;
};

template <class Passes>
Seen seen(const Snapped& scene, Passes passes) {
  const auto width = static_cast<size_t>(scene.frame.width);
  const size_t samples = width * static_cast<size_t>(scene.frame.height);
  const auto cleared = static_cast<int64_t>(std::floor(scene.frame.clear_depth * kFarCode + .5));
  Seen s{std::vector<int64_t>(samples, cleared), std::vector<size_t>(samples, SIZE_MAX)};
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const exact::Judge exact = judge(kContract, scene.frame, scene.triangles[i]);
    const int64_t z = (scene.triangles[i].v[0].z + 128) >> 8;
    for (size_t k = 0; k < samples; ++k) {
      if (!exact.covers(static_cast<int>(k % width), static_cast<int>(k / width))) continue;
      if (!passes(z, s.z[k])) {
        ++s.refused;
        continue;
      }
      s.replaced += s.triangle[k] != SIZE_MAX ? 1 : 0;
      s.triangle[k] = i;
      if (scene.frame.depth_write && scene.frame.depth != DepthFunc::kOff) s.z[k] = z;
    }
  }
  return s;
}

void expect_drawn(const Snapped& scene, const Seen& wanted, const std::string& name) {
  const core::Renderer all = drawn(scene);
  for (size_t k = 0; k < wanted.z.size(); ++k) {
    ASSERT_EQ(all.buffer().depth[k], wanted.z[k]) << name << " " << k;
    for (size_t i = 0; i < 4; ++i) {
      const size_t t = wanted.triangle[k];
      ASSERT_EQ(all.buffer().color[4 * k + i], t == SIZE_MAX ? 0 : scene.triangles[t].v[0].attr[i])
          << name << " " << k;
    }
  }
}

template <class Passes>
void expect_seen(const std::string& name, Passes passes) {
  const Snapped scene = snapped(name);
  const Seen wanted = seen(scene, passes);
  EXPECT_GT(wanted.replaced, 100) << name;
  EXPECT_GT(wanted.refused, 100) << name;
  expect_drawn(scene, wanted, name);
}

TEST(DepthFunctions, NotequalSeesWhatIsAtAnotherDepth) {
  expect_seen("depth_notequal", [](int64_t z, int64_t stored) { return z != stored; });
}

TEST(DepthFunctions, GequalSeesTheFarEndAlone) {
  expect_seen("depth_gequal", [](int64_t z, int64_t) { return z == kFarCode; });
}

TEST(DepthFunctions, WithoutWritesTheLastIsSeenAndDepthsStayCleared) {
  expect_seen("depth_write_off", [](int64_t z, int64_t) { return z < kFarCode; });
  const auto depth = drawn(snapped("depth_write_off")).buffer().depth;
  EXPECT_EQ(std::count(depth.begin(), depth.end(), kFarCode), 32 * 32);
}

TEST(ReversedZ, SeesTheGreatestDepthTheFirstOrTheLastOfEqualOnes) {
  expect_seen("reversed_z", [](int64_t z, int64_t stored) { return z > stored; });
  expect_seen("reversed_z_gequal", [](int64_t z, int64_t stored) { return z >= stored; });
  const auto depth = drawn(snapped("reversed_z")).buffer().depth;
  EXPECT_GT(std::count(depth.begin(), depth.end(), 0), 10);
  EXPECT_GT(std::count(depth.begin(), depth.end(), kFarCode), 100);
}

TEST(ClearDepth, SeesOnlyWhatIsNearer) {
  expect_seen("clear_depth", [](int64_t z, int64_t stored) { return z < stored; });
  const auto depth = drawn(snapped("clear_depth")).buffer().depth;
  EXPECT_GT(std::count(depth.begin(), depth.end(), 12582911), 10);  // of .75
}

TEST(ClearDepth, EveryFunctionSeesWhatItPassesOnEveryClearedDepth) {
  using L = int64_t;
  const std::function<bool(L, L)> passes[] = {std::less<L>(),
                                              std::less_equal<L>(),
                                              [](L, L) { return true; },
                                              [](L, L) { return false; },
                                              std::equal_to<L>(),
                                              std::greater<L>(),
                                              std::not_equal_to<L>(),
                                              std::greater_equal<L>(),
                                              [](L, L) { return true; }};
  Snapped scene = snapped("reversed_z");
  std::set<std::vector<int64_t>> frames;
  for (const double depth : {0., .25, .5, 1.}) {
    scene.frame.clear_depth = depth;
    for (size_t f = 0; f < std::size(passes); ++f) {
      scene.frame.depth = static_cast<DepthFunc>(f);
      const Seen wanted = seen(scene, passes[f]);
      expect_drawn(scene, wanted, std::to_string(f) + " cleared to " + std::to_string(depth));
      frames.insert(wanted.z);
    }
  }
  EXPECT_GT(frames.size(), 12u);  // of 36: many are equal if cleared to an end
}

// The default design's codes, computed in doubles from the floats, which is exact enough here.
TEST(DepthBias, MovesCodesByConstantAndSlopeAndStopsAtTheEnds) {
  for (const char* name : {"depth_bias_near", "depth_bias_far"}) {
    const Snapped scene = snapped(name);
    const double constant = static_cast<double>(scene.frame.bias_constant);
    const double factor = scene.frame.bias_slope / 256.;
    int at_end = 0, within = 0;
    for (size_t i = 0; i < scene.triangles.size(); ++i) {
      const auto& v = scene.triangles[i].v;
      const auto side = [&](int from, int to) {
        const auto &a = v[static_cast<size_t>(from)], &b = v[static_cast<size_t>(to)];
        return std::array<double, 3>{(b.x - a.x) / 256., (b.y - a.y) / 256.,
                                     static_cast<double>(b.z - a.z) / 256.};
      };
      const auto p = side(0, 1), q = side(0, 2);
      const double area2 = p[0] * q[1] - p[1] * q[0];
      if (area2 == 0) continue;
      const double dx = (p[2] * q[1] - q[2] * p[1]) / area2;
      const double dy = (q[2] * p[0] - p[2] * q[0]) / area2;
      const double bias = constant + factor * std::max(std::abs(dx), std::abs(dy));
      const core::Renderer one = drawn(scene, i, 1);
      for (size_t k = 0; k < one.buffer().hits.size(); ++k) {
        if (one.buffer().hits[k] == 0 || one.buffer().color[4 * k + 3] == 0) continue;
        const double x = static_cast<double>(k % 64) + .5 - v[0].x / 256.;
        const double y = static_cast<double>(k / 64) + .5 - v[0].y / 256.;
        const double z = static_cast<double>(v[0].z) / 256 + x * dx + y * dy + bias;
        const double exact = std::clamp(z, 0., static_cast<double>(kFarCode));
        (exact == z ? within : at_end) += 1;
        ASSERT_NEAR(one.buffer().depth[k], exact, .68 + std::abs(factor) * .01) << name << i;
      }
    }
    EXPECT_GT(within, 2000) << name;
    // Beyond the far end LESS draws nothing.
    EXPECT_GT(at_end, name == std::string("depth_bias_near") ? 500 : -1) << name;
  }
}

// The bound of a biased code grows with the slope, since the magnitude is rounded; HardCaseTest
// shows that no design exceeds it. Without this part the judge would fail the low design's slopes.
TEST(DepthBias, AddsToTheBoundWhatItsSlopeSays) {
  const spec::Design& d = spec::kHighTile;
  EXPECT_EQ(spec::depth_bias_error_bound(d, 0, 1e9), 0);
  EXPECT_EQ(spec::depth_bias_error_bound(*spec::find_design("exact"), 2, 1e9), 0);
  EXPECT_EQ(spec::depth_bias_error_bound(*spec::find_design("flat"), 2, 1e9), 0);
  EXPECT_DOUBLE_EQ(spec::depth_bias_error_bound(d, -2, 0), 2 / 512.);
  EXPECT_NEAR(spec::depth_bias_error_bound(d, 1, 1 << 24), 1 / 512. + std::exp2(24 - 29.41), 1e-4);
  // A magnitude beyond 2^26 saturates.
  EXPECT_GT(spec::depth_bias_error_bound(d, 1, std::exp2(27)), std::exp2(26));
  EXPECT_LT(spec::depth_bias_error_bound(d, 1, std::exp2(26) - 1), 1);
}

TEST(FlatShading, GivesEverySampleItsTrianglesFirstColour) {
  for (const auto& design : spec::designs()) {
    SCOPED_TRACE(design.name);
    const auto contract = spec::contract(design);
    const Snapped scene = snapped(hard_case("flat_shading"), contract);
    uint64_t samples = 0, smooth = 0;
    for (const auto& t : scene.triangles) {
      core::Renderer renderer(contract, scene.frame);
      renderer.draw(t);
      const auto& buffer = renderer.buffer();
      for (size_t k = 0; k < buffer.hits.size(); ++k) {
        if (buffer.hits[k] == 0) continue;
        ++samples;
        for (size_t i = 0; i < 4; ++i) ASSERT_EQ(buffer.color[4 * k + i], t.v[0].attr[i]);
      }
      spec::FrameState shaded = scene.frame;
      shaded.shade = spec::Shade::kSmooth;
      core::Renderer other(contract, shaded);
      other.draw(t);
      smooth += other.buffer().color != buffer.color ? 1 : 0;
    }
    EXPECT_GT(samples, 5000u);
    // The mutant: smooth shading gives another frame, in designs that can shade smoothly.
    EXPECT_EQ(smooth > 20, design.attributes > 0);
  }
}

}  // namespace
}  // namespace pineda::hard
