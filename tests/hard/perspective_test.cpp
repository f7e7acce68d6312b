// The right answers of the cases of perspective.
#include <algorithm>
#include <cmath>

#include "model/judge/drawing.h"
#include "model/judge/truth.h"
#include "model/scene/snap.h"
#include "model/spec/bounds.h"
#include "studies/judge/stated.h"
#include "tests/hard/support.h"

namespace pineda::hard {
namespace {

/// The greatest colour error of a design with perspective; with `affine`, against affine colours.
struct Worst {
  double lsb = 0;
  uint64_t samples = 0;
};

Worst worst_color(const spec::Design& design, const std::string& name, bool perspective) {
  const spec::Contract contract = spec::contract(design);
  const scene::HardCase& c = hard_case(name);
  scene::SnappedSource source(contract, std::make_unique<scene::ListReader>(c.make()));
  Worst worst;
  judge::ScreenTruth truth;
  judge::Values values = judge::values_of(design);
  values.perspective = perspective;
  for (spec::Triangle t; source.next(&t);) {
    truth.judge(exact::ScreenJudge(studies::stated(source.screen()), judge::format_of(design),
                                   judge::exact_frame(c.frame)));
    judge::for_each_sample(contract, c.frame, t, [&](const judge::Drawn& drawn) {
      ASSERT_NE(truth.find(drawn.x, drawn.y), nullptr);
      ++worst.samples;
      for (const judge::Error& error : truth.errors(values, drawn).attr) {
        worst.lsb = std::max(worst.lsb, std::abs(error.units));
      }
    });
  }
  return worst;
}

struct Ratio {
  const char* name;
  double ratio;
};
constexpr Ratio kRatios[] = {{"perspective_ratio_4", 4},
                             {"perspective_ratio_64", 64},
                             {"perspective_ratio_1e3", 1e3},
                             {"perspective_ratio_1e6", 1e6}};

TEST(PerspectiveRatio, IsThatOfEveryTriangle) {
  for (const Ratio& r : kRatios) {
    for (const auto& t : hard_case(r.name).make()) {
      const auto [low, high] = std::minmax({t.v[0].w, t.v[1].w, t.v[2].w});
      EXPECT_NEAR(double{high} / low, r.ratio, 1e-6 * r.ratio) << r.name;
    }
  }
}

TEST(PerspectiveRatio, ErrorsDoNotGrowWithIt) {
  const spec::Design& persp = *spec::find_design("persp");
  EXPECT_LE(spec::error_bounds(persp).attribute_lsb, .66);
  for (const Ratio& r : kRatios) {
    const Worst worst = worst_color(persp, r.name, true);
    EXPECT_LE(worst.lsb, .66) << r.name;
    EXPECT_GT(worst.lsb, .4) << r.name;
    EXPECT_GT(worst.samples, 10000u) << r.name;
  }
}

// The mutants: affine colours differ, and so do w's of few bits.
TEST(PerspectiveRatioMutant, AffineColoursAndShortWsAreSeen) {
  spec::Design fine = *spec::find_design("persp");
  fine.attribute_bits = 12;
  spec::Design coarse = fine;
  coarse.inverse_w_bits = 8;
  for (const Ratio& r : kRatios) {
    EXPECT_GT(worst_color(spec::kHighTile, r.name, true).lsb, 20) << r.name;
    EXPECT_LE(worst_color(spec::kHighTile, r.name, false).lsb, .66) << r.name;
    EXPECT_LE(worst_color(fine, r.name, true).lsb, spec::error_bounds(fine).attribute_lsb);
    const double lsb = worst_color(coarse, r.name, true).lsb;
    EXPECT_GT(lsb, 2 * spec::error_bounds(fine).attribute_lsb) << r.name;
    EXPECT_LE(lsb, spec::error_bounds(coarse).attribute_lsb) << r.name;
  }
}

TEST(NearPlaneVertex, LiesJustBeforeThePlaneAndNothingIsCut) {
  const auto triangles = hard_case("near_plane_vertex").make();
  ASSERT_EQ(triangles.size(), 24u);
  double greatest = 0;
  for (size_t i = 0; i < triangles.size(); ++i) {
    EXPECT_EQ(triangles[i].id, i);  // pieces of a cut one would share theirs
    const auto& v = triangles[i].v;
    EXPECT_NEAR(v[0].w, .1, .0002);
    EXPECT_GT(v[0].z, 0);
    EXPECT_LT(v[0].z, .003);
    EXPECT_GT(std::min(v[1].w, v[2].w), .99);
    greatest = std::max(greatest, double{std::max(v[1].w, v[2].w)} / v[0].w);
  }
  EXPECT_GT(greatest, 800);
  const Worst worst = worst_color(*spec::find_design("persp"), "near_plane_vertex", true);
  EXPECT_LE(worst.lsb, .66);
  EXPECT_GT(worst.samples, 1000u);
}

}  // namespace
}  // namespace pineda::hard
