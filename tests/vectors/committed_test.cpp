// The committed files against the functional model, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "vectors/grammar/file.h"

namespace pineda::vectors {
namespace {

template <class Case>
std::vector<std::string> committed() {
  std::vector<std::string> paths;
  const auto folder = std::filesystem::path(PINEDA_VECTORS) / spec::name_of(Case::kUnit);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// "sliver.3" -> "sliver"
template <class Case>
std::set<std::string> classes(const File<Case>& file) {
  std::set<std::string> names;
  for (const Case& c : file.cases) names.insert(c.name.substr(0, c.name.rfind('.')));
  return names;
}

template <class Case>
class Committed : public testing::Test {};
using Cases = testing::Types<SetupCase, TraversalCase, InterpZtestCase, FrameCase>;
struct UnitName {
  template <class Case>
  static std::string GetName(int) {
    return spec::name_of(Case::kUnit);
  }
};
TYPED_TEST_SUITE(Committed, Cases, UnitName);

TYPED_TEST(Committed, ModelReproducesEveryBit) {
  const auto paths = committed<TypeParam>();
  ASSERT_FALSE(paths.empty());
  for (const auto& path : paths) {
    const auto file = read<TypeParam>(path);
    ASSERT_FALSE(file.cases.empty()) << path;
    for (const auto& c : file.cases) {
      const auto text = difference(file.contract, c, run_model(file.contract, c));
      EXPECT_FALSE(text) << path << ": " << *text;
    }
  }
}

TYPED_TEST(Committed, HeaderStatesWhatTheFileHolds) {
  for (const auto& path : committed<TypeParam>()) {
    const Header header = read_header(path);
    EXPECT_EQ(header.unit, TypeParam::kUnit);
    EXPECT_EQ(header.level, 1);
    EXPECT_EQ(header.seed, 1u);
  }
}

TYPED_TEST(Committed, HoldsTheHardCasesOfEveryUnit) {
  std::set<std::string> present;
  for (const auto& path : committed<TypeParam>()) {
    present.merge(classes(read<TypeParam>(path)));
  }
  for (const char* name :
       {"mesh_jittered",  "mesh_half_pixel", "t_junction",      "fan",          "sliver",
        "sliver_long",    "zero_area",       "through_centers", "axis_aligned", "box_on_center",
        "huge_corners",   "huge_window",     "odd_frame",       "outside",      "no_sample",
        "tile_corner",    "tile_border",     "needle",          "micro",        "cull",
        "value_extremes", "format_extremes", "coplanar",        "equal_depth",  "depth_limits",
        "back_to_back",   "alternating",     "intersecting",    "depth_off",    "depth_function",
        "scissor",        "depth_bias",      "flat_shading",    "clear_depth"}) {
    EXPECT_EQ(present.count(name), 1u) << name;
  }
}

TEST(CommittedSetup, HoldsEveryCauseOfADrop) {
  std::set<core::Drop> causes;
  for (const auto& path : committed<SetupCase>()) {
    for (const auto& c : read<SetupCase>(path).cases) {
      causes.insert(c.drops.begin(), c.drops.end());
    }
  }
  EXPECT_EQ(causes.size(), static_cast<size_t>(core::kDropCauses));
}

TEST(CommittedInterpZtest, HoldsStampsBackToBackOnOneAddressThatFailAndThatPass) {
  int adjacent = 0;
  int rejected = 0;
  for (const auto& path : committed<InterpZtestCase>()) {
    for (const auto& c : read<InterpZtestCase>(path).cases) {
      for (size_t i = 1; i < c.in.size(); ++i) {
        adjacent += c.in[i].x == c.in[i - 1].x && c.in[i].y == c.in[i - 1].y ? 1 : 0;
      }
      rejected += static_cast<int>(c.in.size() - c.color.size());
    }
  }
  EXPECT_GE(adjacent, 50);
  EXPECT_GE(rejected, 50);
}

}  // namespace
}  // namespace pineda::vectors
