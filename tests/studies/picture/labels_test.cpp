#include "studies/picture/labels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pineda::studies {
namespace {

constexpr Box kBounds{0, 0, 800, 430};
constexpr double kMarkerPx = 6.5;

using Boxes = std::vector<std::optional<Box>>;

testing::AssertionResult are_apart(const std::vector<Label>& labels, const Boxes& boxes) {
  for (size_t i = 0; i < labels.size(); ++i) {
    if (!boxes[i]) return testing::AssertionFailure() << "label " << i << " has no place";
    if (boxes[i]->width != labels[i].width || boxes[i]->height != labels[i].height) {
      return testing::AssertionFailure() << "label " << i << " has another size";
    }
    if (!kBounds.holds(*boxes[i])) return testing::AssertionFailure() << i << " is cut";
    for (size_t j = 0; j < labels.size(); ++j) {
      const Point p = labels[j].at;
      const Box marker{p.x - kMarkerPx, p.y - kMarkerPx, 2 * kMarkerPx, 2 * kMarkerPx};
      if (boxes[i]->overlaps(marker)) {
        return testing::AssertionFailure() << "label " << i << " lies on point " << j;
      }
      if (j < i && boxes[i]->overlaps(*boxes[j])) {
        return testing::AssertionFailure() << "labels " << j << " and " << i << " overlap";
      }
    }
  }
  return testing::AssertionSuccess();
}

// Points as a plot has them: 21, two thirds of them in two clusters, one of which is in a corner.
std::vector<Label> clustered() {
  std::vector<Label> labels;
  for (int i = 0; i < 21; ++i) {
    const double angle = 2.4 * i;
    const double radius = 2. * i;
    const Point center = i % 3 == 0 ? Point{400, 200} : Point{760, 400};
    const Point at = i % 3 == 2 ? Point{30. + 35 * i, 60}
                                : Point{center.x + radius * .5 * std::cos(angle),
                                        center.y + radius * .5 * std::sin(angle)};
    labels.push_back({at, 60. + 7 * (i % 12), i % 2 == 0 ? 14. : 26.});
  }
  return labels;
}

TEST(Labels, TwentyOneClusteredPointsAreNamedWithoutOverlap) {
  EXPECT_TRUE(are_apart(clustered(), place_labels(clustered(), kBounds, kMarkerPx)));
}

TEST(Labels, PointsOnOneAnotherAreNamedWithoutOverlap) {
  const std::vector<Label> labels(13, {{790, 425}, 140, 26});
  EXPECT_TRUE(are_apart(labels, place_labels(labels, kBounds, kMarkerPx)));
}

TEST(Labels, MutantsThatOverlapAreSeen) {
  const auto labels = clustered();
  const Boxes good = place_labels(labels, kBounds, kMarkerPx);
  Boxes on_another = good;
  on_another[3]->left = good[4]->left + 1 - labels[3].width;
  on_another[3]->top = good[4]->top;
  EXPECT_FALSE(are_apart(labels, on_another));
  Boxes on_a_point = good;
  on_a_point[3]->left = labels[7].at.x - 1;
  on_a_point[3]->top = labels[7].at.y - 1;
  EXPECT_FALSE(are_apart(labels, on_a_point));
}

TEST(Labels, ALonelyPointHasItsNameBesideItToTheRight) {
  const auto boxes = place_labels({{{100, 100}, 80, 14}}, kBounds, kMarkerPx);
  ASSERT_TRUE(boxes[0]);
  EXPECT_NEAR(boxes[0]->left, 100 + kMarkerPx, 4);
  EXPECT_NEAR(boxes[0]->top + 7, 100, 2);
}

TEST(Labels, WhatHasNoRoomIsLeftOut) {
  const auto boxes = place_labels({{{50, 50}, 900, 14}, {{300, 50}, 90, 14}}, kBounds, kMarkerPx);
  EXPECT_FALSE(boxes[0]);
  EXPECT_TRUE(boxes[1]);
  EXPECT_TRUE(place_labels({}, kBounds, kMarkerPx).empty());
}

TEST(Labels, NearestPointIsOnTheBox) {
  const Box box{10, 10, 20, 5};
  EXPECT_EQ(nearest_point(box, {0, 0}).x, 10);
  EXPECT_EQ(nearest_point(box, {15, 40}).x, 15);
  EXPECT_EQ(nearest_point(box, {15, 40}).y, 15);
}

}  // namespace
}  // namespace pineda::studies
