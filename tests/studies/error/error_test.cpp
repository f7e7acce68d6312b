// The measurement of speed against error: right on known cases, and able to see faults.
#include "studies/error/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "studies/judge/scorer.h"
#include "studies/numerics/random_triangles.h"

namespace pineda::studies {
namespace {

constexpr spec::FrameState kFrame{96, 80, spec::Cull::kNone, spec::DepthFunc::kLess};

/// A triangle whose floats are those of its snapped vertices.
SceneTriangle scene_triangle(std::array<Point, 3> p, std::array<float, 3> z, int red) {
  SceneTriangle t;
  for (size_t i = 0; i < 3; ++i) {
    t.screen[i] = {std::ldexp(static_cast<float>(p[i].x), -8),
                   std::ldexp(static_cast<float>(p[i].y), -8),
                   z[i],
                   1,
                   {red, 17, 200, 255}};
    bool clamped = false;
    t.snapped.v[i].x = p[i].x;
    t.snapped.v[i].y = p[i].y;
    t.snapped.v[i].z = exact::depth_input(z[i], 24, &clamped);
    t.snapped.v[i].inverse_w = 1 << (spec::kHighTile.inverse_w_bits - 1);  // w = 1
    for (size_t a = 0; a < 4; ++a) t.snapped.v[i].attr[a] = t.screen[i].rgba[a];
  }
  return t;
}

std::vector<SceneTriangle> some_triangles(int count) {
  Random random(5);
  std::vector<SceneTriangle> triangles;
  for (int n = 0; n < count; ++n) {
    std::array<Point, 3> p;
    for (auto& point : p) {
      point.x = random.between(-20 * 256, 110 * 256);
      point.y = random.between(-20 * 256, 100 * 256);
    }
    const auto z = [&] { return static_cast<float>(random.unit()); };
    const float z0 = z();
    const float z1 = z();
    triangles.push_back(scene_triangle(p, {z0, z1, z()}, random.between(0, 255)));
    triangles.back().snapped.id = static_cast<uint32_t>(n);
  }
  return triangles;
}

ErrorOptions all_designs() {
  ErrorOptions options;
  for (const spec::Design& d : spec::designs()) {
    if (same_formats(d, spec::kHighTile)) options.designs.push_back(d);
  }
  return options;
}

const Subject& subject(const ErrorStudy& study, std::string_view name) {
  const auto found = std::find_if(study.subjects.begin(), study.subjects.end(),
                                  [&](const Subject& s) { return s.name == name; });
  EXPECT_NE(found, study.subjects.end()) << name;
  return *found;
}

TEST(ErrorStudy, EveryDesignHoldsAndTheExactOneIsNearestEverywhere) {
  const auto triangles = some_triangles(60);
  const ErrorStudy study = study_errors(triangles, kFrame, all_designs());
  EXPECT_TRUE(study.holds());
  EXPECT_EQ(study.triangles, 60u);
  EXPECT_GT(study.samples, 20000u);
  EXPECT_EQ(study.affine_lsb, 0);
  EXPECT_EQ(static_cast<int64_t>(study.samples),
            count_samples(triangles, kFrame, spec::kHighTile, int64_t{1} << 40));
  for (const Subject& s : study.subjects) {
    EXPECT_GT(s.seconds, 0) << s.name;
    if (!s.is_design) continue;
    EXPECT_EQ(s.missing + s.extra, 0u) << s.name;
    EXPECT_EQ(s.judged, study.samples) << s.name;
    EXPECT_EQ(s.depth.count(), s.name == "flat" ? 0 : study.samples) << s.name;
    EXPECT_EQ(s.color.count(), 4 * study.samples) << s.name;
  }
  EXPECT_LE(subject(study, "exact").depth.max(), .5);
  EXPECT_EQ(subject(study, "exact").depth.misrounded(), 0);
  EXPECT_EQ(subject(study, "exact").color.misrounded(), 0);
  EXPECT_GT(subject(study, "low").depth.misrounded(), .05);
}

// A fault in a design's input coordinates shows as missing and extra samples.
TEST(ErrorStudy, OneSubpixelToTheRightBreaksTheCoverage) {
  auto triangles = some_triangles(60);
  for (auto& t : triangles) {
    for (auto& v : t.snapped.v) ++v.x;
  }
  ErrorOptions options = all_designs();
  options.designs.resize(1);
  options.baselines = false;
  const ErrorStudy study = study_errors(triangles, kFrame, options);
  EXPECT_FALSE(study.holds());
  EXPECT_GT(study.subjects[0].missing, 0u);
  EXPECT_GT(study.subjects[0].extra, 0u);
}

// A fault in its depth shows as a broken bound.
TEST(ErrorStudy, OneCodeTooFarBreaksTheBound) {
  auto triangles = some_triangles(20);
  for (auto& t : triangles) {
    for (auto& v : t.snapped.v) v.z = std::max<int64_t>(v.z - 256, 0);
  }
  ErrorOptions options;
  options.designs = {spec::kHighTile};
  options.baselines = false;
  const ErrorStudy study = study_errors(triangles, kFrame, options);
  EXPECT_EQ(study.subjects[0].missing + study.subjects[0].extra, 0u);
  EXPECT_GT(study.subjects[0].depth.max(), study.subjects[0].bounds->depth_ulp);
  EXPECT_FALSE(study.holds());
}

// Two triangles that intersect: by mean depth the painter puts one in front everywhere.
TEST(ErrorStudy, PainterIsJudgedByTheFrameItLeaves) {
  const std::array<Point, 3> p{{{0, 0}, {90 * 256, 0}, {0, 70 * 256}}};
  const std::vector<SceneTriangle> triangles{scene_triangle(p, {.1f, .9f, .5f}, 0),
                                             scene_triangle(p, {.9f, .2f, .5f}, 255)};
  const ErrorStudy study = study_errors(triangles, kFrame, all_designs());
  const Subject& painter = subject(study, "painter");
  EXPECT_TRUE(painter.judged_by_frame);
  EXPECT_EQ(painter.missing + painter.extra, 0u);
  EXPECT_LT(painter.depth.count(), study.samples);  // visible ones only
  EXPECT_GT(painter.depth.max(), 1e6);
  EXPECT_EQ(painter.color.max(), 255);
  EXPECT_LE(subject(study, "fp64").depth.max(), .51);
}

TEST(ErrorStudy, MapsShowWhereTheErrorIs) {
  const std::array<Point, 3> p{{{0, 0}, {32 * 256, 0}, {0, 32 * 256}}};
  std::vector<SceneTriangle> triangles{scene_triangle(p, {.1f, .2f, .3f}, 9)};
  triangles[0].snapped.v[1].x += 4 * 256;  // draws too much at its right corner
  ErrorOptions options;
  options.designs = {spec::kHighTile};
  options.baselines = false;
  options.maps = true;
  const ErrorMap map = study_errors(triangles, kFrame, options).subjects[0].map;
  ASSERT_EQ(map.coverage.size(), 96u * 80u);
  EXPECT_EQ(map.coverage[0], 0);
  EXPECT_GE(map.depth_ulp[0], 0.0f);
  EXPECT_EQ(map.coverage[33], 2);           // row 0, beyond the right triangle
  EXPECT_LT(map.depth_ulp[96 * 79], 0.0f);  // nothing there
}

// w of 1, 1 and 4: half way along the edge affine colour is 127.5, with perspective it is 255/5.
TEST(ErrorStudy, SaysHowFarAffineColoursAreFromPerspective) {
  const std::array<Point, 3> p{{{0, 0}, {64 * 256, 0}, {0, 64 * 256}}};
  SceneTriangle t = scene_triangle(p, {.5f, .5f, .5f}, 0);
  t.screen[1].w = 4;
  t.screen[1].rgba[0] = 255;
  t.snapped.v[1].attr[0] = 255;
  ErrorOptions options;
  options.designs = {spec::kHighTile};
  options.baselines = false;
  const ErrorStudy study = study_errors({t}, kFrame, options);
  EXPECT_NEAR(study.affine_lsb, 85, 2);  // largest at two thirds of the way
  EXPECT_TRUE(study.holds());
}

TEST(ErrorStudy, DesignsOfDifferentFormatsAreRefused) {
  ErrorOptions options;
  options.designs = {spec::kHighTile, spec::kHighTile};
  options.designs[1].subpixel_bits = 4;
  EXPECT_THROW(study_errors(some_triangles(1), kFrame, options), std::invalid_argument);
}

TEST(CountSamples, StopsBeyondTheLimit) {
  const auto triangles = some_triangles(60);
  const int64_t all = count_samples(triangles, kFrame, spec::kHighTile, int64_t{1} << 40);
  const int64_t some = count_samples(triangles, kFrame, spec::kHighTile, 1000);
  EXPECT_GT(some, 1000);
  EXPECT_LT(some, all);
}

// A second hit by the same triangle is one sample too many.
TEST(Scorer, CountsASampleThatIsHitTwice) {
  const std::array<Point, 3> p{{{0, 0}, {8 * 256, 0}, {0, 8 * 256}}};
  const SceneTriangle t = scene_triangle(p, {.5f, .5f, .5f}, 7);
  judge::ScreenTruth truth;
  truth.judge(
      exact::ScreenJudge(t.screen, judge::format_of(spec::kHighTile), judge::exact_frame(kFrame)));
  Subject result;
  Scorer scorer(&result, kFrame, spec::kHighTile, false);
  scorer.begin(truth);
  const exact::Sample& first = truth.samples().front();
  const judge::Drawn drawn{first.x, first.y, first.z.nearest, {7, 17, 200, 255}};
  for (int i = 0; i < 2; ++i) scorer.sample(drawn);
  scorer.end();
  EXPECT_EQ(result.extra, 1u);
  EXPECT_EQ(result.missing, truth.samples().size() - 1);
  EXPECT_EQ(result.depth.count(), 1u);
}

TEST(Distribution, OfKnownValues) {
  Distribution d;
  for (int i = 0; i < 998; ++i) d.add(i % 2 == 0 ? .25 : -.25, false);
  d.add(3, true);
  d.add(0, false);
  EXPECT_EQ(d.count(), 1000u);
  EXPECT_EQ(d.max(), 3);
  EXPECT_EQ(d.zeros(), 1u);
  EXPECT_DOUBLE_EQ(d.misrounded(), .001);
  EXPECT_NEAR(d.rms(), std::sqrt((998 * .0625 + 9) / 1000), 1e-12);
  EXPECT_NEAR(d.quantile(.999), .25, .016 * .25);
  EXPECT_GE(d.quantile(.999), .25);
  EXPECT_EQ(d.quantile(1), 3);
  EXPECT_EQ(d.quantile(.001), 0);
  const auto octaves = d.octaves();
  EXPECT_EQ(octaves.front().octave, -2);
  EXPECT_EQ(octaves.front().count, 998u);
  EXPECT_EQ(octaves.back().octave, 1);
  EXPECT_EQ(octaves.back().count, 1u);
}

TEST(Distribution, OfNothingIsZero) {
  const Distribution d;
  EXPECT_EQ(d.max(), 0);
  EXPECT_EQ(d.rms(), 0);
  EXPECT_EQ(d.quantile(.999), 0);
  EXPECT_EQ(d.misrounded(), 0);
  EXPECT_TRUE(d.octaves().empty());
}

}  // namespace
}  // namespace pineda::studies
