// InFlight compared with a cycle kept for every stamp.
#include "model/timing/units/in_flight.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/spec/design.h"
#include "model/spec/random.h"

namespace pineda::test {
namespace {

using timing::Cycle;
using timing::InFlight;

spec::Design design_of(int tile_log2, int stamp_width_log2, int stamp_height_log2) {
  spec::Design d;
  d.tile_log2 = tile_log2;
  d.stamp_width_log2 = stamp_width_log2;
  d.stamp_height_log2 = stamp_height_log2;
  return d;
}

// A tile with some stamps, at least one.
fast::TileCover random_cover(const spec::Contract& c, spec::Random* random) {
  const auto below = [&](int n) { return random->between(0, n - 1); };
  fast::TileCover cover(c);
  cover.x = below(3);
  cover.y = below(2);
  const int columns = 1 << cover.box.columns_log2;
  const int rows = 1 << (c.design.tile_log2 - c.design.stamp_height_log2);
  cover.box.column0 = below(columns);
  cover.box.columns = 1 + below(columns - cover.box.column0);
  cover.box.row0 = below(rows);
  cover.box.rows = 1 + below(rows - cover.box.row0);
  std::vector<int> places;
  for (int row = 0; row < cover.box.rows; ++row) {
    for (int column = 0; column < cover.box.columns; ++column) {
      const bool is_last = row + 1 == cover.box.rows && column + 1 == cover.box.columns;
      if (below(2) == 0 && !(is_last && places.empty())) continue;
      places.push_back((cover.box.row0 + row) * columns + cover.box.column0 + column);
    }
  }
  for (const int place : places) {
    cover.covered.stamps[static_cast<size_t>(place) / 64] |= uint64_t{1} << (place % 64);
  }
  cover.covered.count = static_cast<int>(places.size());
  cover.covered.first = places.front();
  cover.covered.last = places.back();
  return cover;
}

constexpr Cycle kFlight = 9;  // from a stamp taken until it retires

// Runs and single stamps of six tiles; returns how many stamps were compared, -1 if one differed.
// `late`: the mutant, by how many cycles the expected side lets runs retire later.
int compare(const spec::Contract& c, uint32_t seed, Cycle late) {
  spec::Random random(seed);
  InFlight in_flight(c.design);
  in_flight.begin_frame(6);
  const size_t stamps = size_t{1} << fast::stamps_log2(c.design);
  std::vector<std::vector<Cycle>> expected(6, std::vector<Cycle>(stamps));
  std::vector<Cycle> since(6);  // cycles before the last run do not matter
  int compared = 0, overlaps = 0;
  Cycle now = 0;
  for (int step = 0; step < 200; ++step) {
    now += random.between(0, 4);
    const fast::TileCover cover = random_cover(c, &random);
    const auto tile = static_cast<size_t>(3 * cover.y + cover.x);
    auto& of_tile = expected[tile];
    bool is_free = true;
    Cycle comes = now;
    cover.covered.for_each_stamp(
        [&](int place) { is_free = is_free && of_tile[static_cast<size_t>(place)] <= comes++; });
    if (in_flight.takes_run(tile, cover.covered, now) != is_free) return -1;
    if (random.coin() && is_free) {
      overlaps += in_flight.tile_free(tile) > now ? 1 : 0;
      in_flight.run(tile, cover.covered, now, now + kFlight);
      since[tile] = now;
      cover.covered.for_each_stamp(
          [&](int place) { of_tile[static_cast<size_t>(place)] = now++ + kFlight + 1 + late; });
      if (in_flight.tile_free(tile) != now + kFlight) return -1;
      continue;
    }
    bool same = true;
    cover.covered.for_each_stamp([&](int place) {
      Cycle& free = of_tile[static_cast<size_t>(place)];
      const Cycle got = in_flight.stamp_free(tile, place);
      same = same && std::max(got, since[tile]) == std::max(free, since[tile]);
      now = std::max(now, got) + 1;
      free = now + kFlight;
      in_flight.stamp(tile, place, free);
      ++compared;
    });
    if (!same || in_flight.tile_free(tile) != now + kFlight) return -1;
  }
  return overlaps > 0 ? compared : -1;
}

TEST(InFlight, KnowsTheCycleOfEachStamp) {
  for (const spec::Design& d : {design_of(3, 1, 1), design_of(3, 2, 2), design_of(2, 0, 1),
                                design_of(4, 0, 0), design_of(5, 1, 0)}) {
    const auto c = spec::contract(d);
    for (uint32_t seed = 0; seed < 20; ++seed) EXPECT_GT(compare(c, seed, 0), 50) << seed;
  }
}

TEST(InFlight, RunThatRetiresLaterIsSeen) {
  EXPECT_EQ(compare(spec::contract(design_of(3, 1, 1)), 1, 1), -1);
}

TEST(InFlight, FrameBeginsWithNoneInFlight) {
  const auto c = spec::contract(design_of(3, 1, 1));
  spec::Random random(3);
  const fast::TileCover cover = random_cover(c, &random);
  InFlight in_flight(c.design);
  in_flight.begin_frame(1);
  in_flight.run(0, cover.covered, 90, 100);
  in_flight.begin_frame(1);
  EXPECT_EQ(in_flight.tile_free(0), 0);
  EXPECT_EQ(in_flight.stamp_free(0, cover.covered.first), 0);
}

}  // namespace
}  // namespace pineda::test
