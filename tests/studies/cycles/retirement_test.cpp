// Finds where two sides first differ, on records made by hand.
#include "studies/cycles/retirement.h"

#include <gtest/gtest.h>

namespace pineda::studies {
namespace {

// A triangle of three stamps, of which the last is hidden.
ByBoundary<int64_t> cycles() { return {{{20}, {30, 31, 32}, {40, 41}, {41, 42}}}; }

std::vector<int64_t>& at(ByBoundary<int64_t>* cycles, Boundary boundary) {
  return (*cycles)[static_cast<size_t>(boundary)];
}

TEST(RetireCycles, LastWriteOfEitherKindCounts) {
  RetireCycles retired;
  retired.note(40, 2);
  retired.note(44, 2);
  retired.note(43, 2);
  retired.note(9, 0);
  EXPECT_EQ(retired.cycles(), (std::vector<int64_t>{9, -1, 44}));
}

TEST(FirstRetireDifference, NoneWhereAllAreAlike) {
  EXPECT_FALSE(first_retire_difference({40, -1, 17}, {40, -1, 17}));
  // Triangles at the end that wrote nothing may be missing in one of the lists.
  EXPECT_FALSE(first_retire_difference({40}, {40, -1}));
}

TEST(FirstRetireDifference, IsFirstByNumberNotByCycle) {
  const auto found = first_retire_difference({90, 50, 13}, {90, 51, 12});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->triangle, 1u);
  EXPECT_EQ(found->model, 50);
  EXPECT_EQ(found->rtl, 51);
}

TEST(FirstRetireDifference, MayBeMissingOnOneSide) {
  const auto found = first_retire_difference({5}, {5, -1, 8});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->triangle, 2u);
  EXPECT_EQ(found->model, -1);
  EXPECT_EQ(found->rtl, 8);
}

TEST(FirstTokenDifference, NoneWhereAllAreAlike) {
  EXPECT_FALSE(first_token_difference(cycles(), cycles()));
}

// Each boundary differs alone, so that no other one can be found.
TEST(FirstTokenDifference, NamesTheUnitBeforeTheBoundary) {
  for (const auto& [boundary, unit] : {std::pair(Boundary::kPrim, "setup"),
                                       {Boundary::kStamp, "traversal"},
                                       {Boundary::kDepthWrite, "interp_ztest"},
                                       {Boundary::kColorWrite, "interp_ztest"}}) {
    auto rtl = cycles();
    at(&rtl, boundary).back() += 3;
    const auto found = first_token_difference(cycles(), rtl);
    ASSERT_TRUE(found) << unit;
    EXPECT_EQ(found->boundary, boundary);
    EXPECT_STREQ(unit_before(found->boundary), unit);
    EXPECT_EQ(found->index, at(&rtl, boundary).size() - 1);
    EXPECT_EQ(found->rtl, found->model + 3);
    EXPECT_EQ(found->cycle(), found->model);
  }
}

// The depth test is late, and holds up stamps afterwards: it is named, not traversal.
TEST(FirstTokenDifference, LateUnitIsNamedNotTheOneThatItHoldsUp) {
  auto rtl = cycles();
  at(&rtl, Boundary::kDepthWrite) = {40, 44};
  at(&rtl, Boundary::kStamp) = {30, 31, 45};
  auto model = cycles();
  at(&model, Boundary::kStamp) = {30, 31, 43};
  const auto found = first_token_difference(model, rtl);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->boundary, Boundary::kDepthWrite);
  EXPECT_EQ(found->model, 41);
}

TEST(FirstTokenDifference, OfOneCycleUpThePipelineComesFirst) {
  auto rtl = cycles();
  at(&rtl, Boundary::kDepthWrite) = {40, 43};
  at(&rtl, Boundary::kColorWrite) = {43, 44};
  const auto found = first_token_difference(cycles(), rtl);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->boundary, Boundary::kDepthWrite);
}

TEST(FirstTokenDifference, TokenTooManyNeverComesOnTheOtherSide) {
  auto rtl = cycles();
  at(&rtl, Boundary::kStamp).push_back(33);
  const auto found = first_token_difference(cycles(), rtl);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->index, 3u);
  EXPECT_EQ(found->model, -1);
  EXPECT_EQ(found->rtl, 33);
  EXPECT_EQ(found->cycle(), 33);
  EXPECT_EQ(first_token_difference(rtl, cycles())->cycle(), 33);
}

TEST(TokensAround, AreTwoBeforeAndThreeFromThere) {
  std::vector<Token> tokens;
  for (uint32_t i = 0; i < 9; ++i) tokens.push_back({10 * int64_t{i}, i});
  const auto first_and_count = [&tokens](int64_t cycle) {
    const auto near = tokens_around(tokens, cycle);
    return std::pair(near.empty() ? -1 : int64_t{near.front().triangle}, near.size());
  };
  EXPECT_EQ(first_and_count(40), std::pair(int64_t{2}, size_t{5}));
  EXPECT_EQ(first_and_count(41), std::pair(int64_t{3}, size_t{5}));
  EXPECT_EQ(first_and_count(0), std::pair(int64_t{0}, size_t{3}));
  EXPECT_EQ(first_and_count(99), std::pair(int64_t{7}, size_t{2}));
  tokens.clear();
  EXPECT_EQ(first_and_count(5), std::pair(int64_t{-1}, size_t{0}));
}

}  // namespace
}  // namespace pineda::studies
