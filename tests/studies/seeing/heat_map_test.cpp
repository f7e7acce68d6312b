// Cycles by tile of the screen, and their picture.
#include "studies/seeing/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pineda::test {
namespace {

using studies::HeatMap;
using studies::Picture;
using studies::Window;
using timing::Cycle;
using timing::Fifo;

constexpr spec::Contract kContract = spec::contract(spec::kHighTile);  // 8x8 px, stamps of 2x2
constexpr spec::FrameState kFrame{20, 12};                             // 3 x 2 tiles

spec::Stamp stamp_at(int x_px, int y_px) {
  spec::Stamp stamp;
  stamp.x = x_px / 2;
  stamp.y = y_px / 2;
  return stamp;
}

// Three stamps: two in the first tile, one in the last.
void feed(HeatMap* map) {
  map->stamp(9, stamp_at(0, 0));
  map->slot(Fifo::kStamps, 9, 10);
  map->stamp(10, stamp_at(19, 11));
  map->slot(Fifo::kStamps, 10, 40);
  map->stamp(11, stamp_at(7, 7));
  map->slot(Fifo::kStamps, 11, 41);
}

void expect_fed(const HeatMap& map) {
  EXPECT_EQ(map.cycles(0, 0), 11);
  EXPECT_EQ(map.cycles(2, 1), 30);
  EXPECT_EQ(map.cycles(1, 0), 0);
  EXPECT_EQ(map.total(), 41);
  EXPECT_EQ(map.touched(), 2);
}

TEST(HeatMap, TilePaysFromTheAcceptanceBeforeToItsStamps) {
  HeatMap map(kContract, kFrame, {});
  feed(&map);
  expect_fed(map);
  EXPECT_EQ(map.columns(), 3);
  EXPECT_EQ(map.rows(), 2);
  EXPECT_EQ(map.hottest().x, 2);
  EXPECT_EQ(map.hottest().y, 1);
  EXPECT_EQ(map.hottest().cycles, 30);
}

TEST(HeatMap, StampsAndSlotsNeedNotTakeTurns) {
  HeatMap map(kContract, kFrame, {});
  map.slot(Fifo::kStamps, 9, 10);
  map.slot(Fifo::kTiles, 9, 99);  // a slot of another FIFO than the stamps'
  map.slot(Fifo::kStamps, 10, 40);
  map.stamp(9, stamp_at(0, 0));
  map.stamp(10, stamp_at(19, 11));
  map.stamp(11, stamp_at(7, 7));
  map.slot(Fifo::kStamps, 11, 41);
  expect_fed(map);
}

TEST(HeatMap, WindowLeavesOutWhatLiesOutside) {
  HeatMap map(kContract, kFrame, Window{20, 35});
  feed(&map);
  EXPECT_EQ(map.cycles(0, 0), 0);
  EXPECT_EQ(map.cycles(2, 1), 15);
  EXPECT_EQ(map.total(), 15);
}

// The tiles' cycles add up to the time of the last acceptance, whatever the stamps.
TEST(HeatMap, TilesAddUpToTheLastAcceptance) {
  HeatMap map(kContract, kFrame, {});
  Cycle accepted = 5;
  for (int i = 0; i < 1000; ++i) {
    map.stamp(accepted - 1, stamp_at(i * 7 % 20, i * 5 % 12));
    map.slot(Fifo::kStamps, accepted - 1, accepted);
    accepted += 1 + i % 4;
  }
  Cycle sum = 0;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) sum += map.cycles(x, y);
  }
  EXPECT_EQ(sum, accepted - 1 - 999 % 4);
  EXPECT_EQ(map.total(), sum);
}

using Color = std::array<int, 3>;

Color pixel(const Picture& picture, int x, int y) {
  const auto at =
      3 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x));
  return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

int luminance(const Color& color) { return 2 * color[0] + 7 * color[1] + color[2]; }

TEST(HeatMapPicture, ShowsTilesOverTheFrameHotterOnesLighter) {
  HeatMap map(kContract, kFrame, {});
  feed(&map);
  const Picture picture = heat_map_picture(map, kContract, kFrame);
  ASSERT_EQ(picture.width % kFrame.width, 0);
  const int zoom = picture.width / kFrame.width;
  EXPECT_GT(picture.height, kFrame.height * zoom);
  EXPECT_EQ(picture.rgb.size(),
            size_t{3} * static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
  const Color first = pixel(picture, 8 * zoom - 1, 8 * zoom - 1);
  const Color last = pixel(picture, picture.width - 1, kFrame.height * zoom - 1);
  EXPECT_EQ(first, pixel(picture, 0, 0));
  EXPECT_EQ(last, pixel(picture, 16 * zoom, 8 * zoom));
  EXPECT_GT(luminance(last), luminance(first));
  EXPECT_EQ(pixel(picture, 8 * zoom, 0), (Color{0, 0, 0}));
}

TEST(HeatMapPicture, ScaleEndsInTheColorOfTheHottestTile) {
  HeatMap map(kContract, kFrame, {});
  feed(&map);
  const Picture picture = heat_map_picture(map, kContract, kFrame);
  const int zoom = picture.width / kFrame.width;
  const Color hottest = pixel(picture, 16 * zoom, 8 * zoom);
  int nearest = 1 << 20;
  for (int y = kFrame.height * zoom; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Color color = pixel(picture, x, y);
      int distance = 0;
      for (size_t i = 0; i < 3; ++i) distance += std::abs(color[i] - hottest[i]);
      nearest = std::min(nearest, distance);
    }
  }
  EXPECT_LE(nearest, 3);
}

TEST(HeatMapPicture, LargeFrameIsNotMagnifiedAndNothingDrawnIsBlack) {
  constexpr spec::FrameState kLarge{641, 479};
  const HeatMap map(kContract, kLarge, {});
  const Picture picture = heat_map_picture(map, kContract, kLarge);
  EXPECT_EQ(picture.width, 641);
  EXPECT_EQ(map.hottest().cycles, 0);
  EXPECT_EQ(pixel(picture, 640, 478), (Color{0, 0, 0}));
  EXPECT_EQ(pixel(picture, 640, 479), (Color{255, 255, 255}));
}

}  // namespace
}  // namespace pineda::test
