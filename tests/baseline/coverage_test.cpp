// Every baseline against the exact judge: coverage, depth and colour over the six classes.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

struct ShapeCase {
  const char* name;
  Shape shape;
  int count;
  int64_t least_samples;
};
constexpr ShapeCase kShapes[] = {
    {"Tiny16Px", Shape::k16Px, 1500, 20000},   {"Size256Px", Shape::k256Px, 60, 20000},
    {"Size8192Px", Shape::k8192Px, 60, 50000}, {"GuardBand", Shape::kGuardBand, 60, 50000},
    {"Needle", Shape::kNeedle, 1500, 15000},   {"Sliver", Shape::kSliver, 6000, 1500},
};

void record_all(const Verdict& v) {
  record("wanted", static_cast<double>(v.wanted));
  record("missing", static_cast<double>(v.missing));
  record("extra", static_cast<double>(v.extra));
  record("wrong", static_cast<double>(v.wrong));
  record("triangles", static_cast<double>(v.triangles));
  record("depth_ulp", v.depth_ulp);
  record("color_lsb", v.color_lsb);
}

using Param = std::tuple<std::string, ShapeCase>;
std::string name_of(const testing::TestParamInfo<Param>& info) {
  return std::get<0>(info.param) + std::get<1>(info.param).name;
}

class ExactBaseline : public testing::TestWithParam<Param> {};
INSTANTIATE_TEST_SUITE_P(OnEveryShape, ExactBaseline,
                         testing::Combine(testing::ValuesIn(exact_baselines()),
                                          testing::ValuesIn(kShapes)),
                         name_of);

// Largest error of the values, rounding included: what each algorithm has, not what it should have.
double depth_bound(const std::string& name, Shape shape) {
  const bool sliver = shape == Shape::kSliver;
  if (name == "edge_flat") return 1 << 24;
  // (|x| + |y| + 2) * 2^-13 + 1/2, on frames of 16384 px and of 67.
  if (name == "edge_smooth") return sliver || shape == Shape::k16Px ? 4.51 : .52;
  // Doubles: a sliver's planes from the origin, or its spans of some 2^-16 px.
  if (name == "fp64" || name == "painter") return sliver ? 1000 : .51;
  if (name == "edge_walk") return sliver ? 2000 : .51;
  if (name == "barycentric_incremental") return sliver ? 1.5 : .51;
  return .501;
}

double color_bound(const std::string& name, Shape shape) {
  if (name == "edge_flat") return 1 << 8;
  return name == "edge_smooth" ? depth_bound(name, shape) : .51;
}

TEST_P(ExactBaseline, HitsEverySampleOnce) {
  const auto& [name, shape] = GetParam();
  const Verdict v = judge_random(name, shape.shape, shape.count, 61);
  record_all(v);
  EXPECT_EQ(v.missing, 0);
  EXPECT_EQ(v.extra, 0);
  EXPECT_EQ(v.twice, 0);
  EXPECT_GE(v.wanted, shape.least_samples);
  EXPECT_LE(v.depth_ulp, depth_bound(name, shape.shape));
  EXPECT_LE(v.color_lsb, color_bound(name, shape.shape));
}

// Errors that the bounds above allow occur: 12 fraction bits from the origin at 16384 px, and one
// colour a triangle.
TEST(BaselineError, IsThereToBeSeen) {
  const Verdict smooth = judge_random("edge_smooth", Shape::k16Px, 1500, 61);
  EXPECT_GT(smooth.depth_ulp, 3);
  EXPECT_GT(smooth.color_lsb, 3);
  const Verdict flat = judge_random("edge_flat", Shape::k256Px, 30, 61);
  EXPECT_GT(flat.depth_ulp, 1e6);
  EXPECT_GT(flat.color_lsb, 100);
}

struct Failure {
  const char* name;
  double tiny_share;    // least share drawn wrong, of 16 px in 16384 px
  double sliver_share;  // the same of areas of 1 to 4 units; extra ones count, too
  double depth_ulp;     // largest error on needles, at least
};

class SinglePrecision : public testing::TestWithParam<Failure> {};
INSTANTIATE_TEST_SUITE_P(Setup, SinglePrecision,
                         testing::Values(Failure{"edge_fp32_determinant", .7, 1, 1000},
                                         Failure{"edge_fp32_vertex", .003, 1, 1000},
                                         Failure{"edge_fp32_average", .003, 1, 1000},
                                         Failure{"fp32", .7, 1, 1000}),
                         [](const auto& c) { return std::string(c.param.name); });

double wrong_share(const Verdict& v) {
  return static_cast<double>(v.wrong) / static_cast<double>(v.triangles);
}

TEST_P(SinglePrecision, DrawsTrianglesWrongFarFromTheOrigin) {
  const Verdict v = judge_random(GetParam().name, Shape::k16Px, 1500, 62);
  record_all(v);
  EXPECT_GT(wrong_share(v), GetParam().tiny_share);
  EXPECT_GT(v.missing, 0);
  EXPECT_GT(v.extra, 0);
}

TEST_P(SinglePrecision, LosesSliversAndDrawsThemWhereTheyAreNot) {
  const Verdict v = judge_random(GetParam().name, Shape::kSliver, 6000, 62);
  record_all(v);
  EXPECT_GT(wrong_share(v), GetParam().sliver_share);
  EXPECT_GT(v.missing, v.wanted / 2);
  EXPECT_GT(v.extra, 500);
}

TEST_P(SinglePrecision, LosesTheDepthOfNeedles) {
  const Verdict v = judge_random(GetParam().name, Shape::kNeedle, 1500, 62);
  record_all(v);
  EXPECT_GT(v.depth_ulp, GetParam().depth_ulp);
}

// In the far corner of the guard band the determinant form of C loses the triangle to rounding, the
// one-vertex form does not.
TEST(SinglePrecisionGuardBand, DeterminantLosesATriangleThatTheVertexFormKeeps) {
  const int far = 16380 * kPx;
  const spec::Triangle t = triangle({far + 13, far + 101}, {far + 3 * kPx + 55, far + 7},
                                    {far + 31, far + 3 * kPx + 99});
  ASSERT_GE(judge(kHugeFrame, t).samples(), 3);
  Verdict determinant;
  judge_samples(kHugeFrame, t, samples_of("edge_fp32_determinant", kHugeFrame, t), &determinant);
  Verdict vertex;
  judge_samples(kHugeFrame, t, samples_of("edge_fp32_vertex", kHugeFrame, t), &vertex);
  EXPECT_GT(determinant.faults(), 0);
  EXPECT_EQ(vertex.faults(), 0);
}

// The judge can fail a baseline: shifted samples are extra and missing at once.
TEST(BaselineMutant, ShiftedDoubledAndLostSamplesAreCaught) {
  const spec::FrameState frame{64, 64, spec::Cull::kNone, spec::DepthFunc::kLess};
  const spec::Triangle t = triangle({4 * kPx, 5 * kPx}, {50 * kPx, 20 * kPx}, {9 * kPx, 60 * kPx});
  const auto right = samples_of("edge_walk", frame, t);
  const auto verdict = [&](const std::vector<baseline::Sample>& samples) {
    Verdict v;
    judge_samples(frame, t, samples, &v);
    return v;
  };
  EXPECT_EQ(verdict(right).faults(), 0);
  auto shifted = right;
  for (auto& s : shifted) ++s.x;
  EXPECT_GT(verdict(shifted).extra, 10);
  EXPECT_GT(verdict(shifted).missing, 10);
  auto doubled = right;
  doubled.push_back(right[7]);
  EXPECT_EQ(verdict(doubled).twice, 1);
  auto lost = right;
  lost.pop_back();
  EXPECT_EQ(verdict(lost).missing, 1);
  auto deep = right;
  deep[3].z += 2;
  EXPECT_GT(verdict(deep).depth_ulp, 1.4);
  auto red = right;
  red[3].rgba[0] += 2;
  EXPECT_GT(verdict(red).color_lsb, 1.4);
}

}  // namespace
}  // namespace pineda::test
