// The table of counters: each counter is in it once, with its own name and place.
#include "model/timing/counted/counters.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace pineda::test {
namespace {

using core::Drop;
using core::FrameCounter;
using core::kFrameCounters;
using timing::Counter;

const spec::Contract kWide = spec::contract(*spec::find_design("wide"));  // stamps of 16 samples
const spec::Contract kFlat = spec::contract(*spec::find_design("flat"));  // no depth

// Sets every counter of a frame to a different value, `from` and up.
timing::FrameResult distinct(int64_t from) {
  timing::FrameResult result = timing::empty_result(kWide);
  timing::for_each_counter(kWide, result, [&](const Counter&, auto& count) {
    count = static_cast<std::decay_t<decltype(count)>>(from++);
  });
  return result;
}

std::map<std::string, Counter> rows(const spec::Contract& contract) {
  std::map<std::string, Counter> all;
  const timing::FrameResult none = timing::empty_result(contract);
  timing::for_each_counter(contract, none,
                           [&](const Counter& row, auto) { all.emplace(row.name, row); });
  return all;
}

TEST(CounterTable, HoldsEveryMemberOnceUnderANameOfItsOwn) {
  const timing::FrameResult result = distinct(1);
  const auto list = timing::counter_list(kWide, result);
  std::set<std::string> names;
  std::set<int64_t> counts;
  for (const auto& counter : list) {
    names.insert(counter.name);
    counts.insert(counter.count);
  }
  EXPECT_EQ(names.size(), list.size());
  EXPECT_EQ(counts.size(), list.size());
  // 1 + 5 units * 5 causes + levels of FIFOs of 2, 4 and 4 slots + 3 ports + 17 stamps + 2, and 14
  // of the frame.
  EXPECT_EQ(list.size(), 61u + 14u);
  EXPECT_EQ(*counts.begin(), 1);
  EXPECT_EQ(*counts.rbegin(), 75);
  // No member is missing in the table.
  EXPECT_GT(result.spent.drained, 0);
  for (const auto& unit : result.spent.units) {
    EXPECT_GT(*std::min_element(unit.spent.begin(), unit.spent.end()), 0);
  }
  for (const auto cycles : result.spent.port_stalls) EXPECT_GT(cycles, 0);
  for (const auto stamps : result.spent.stamps_by_samples) EXPECT_GT(stamps, 0u);
  EXPECT_GT(result.spent.samples_passed, 0u);
  EXPECT_GT(result.spent.samples_failed, 0u);
}

TEST(CounterTable, NamesAreThoseThatUsersKnow) {
  const auto all = rows(kWide);
  for (const char* name :
       {"drained", "setup.busy", "interp_ztest.hazard", "prims.level_0", "tiles.level_2",
        "depth_read.stalls", "stamps_of_16_samples", "samples_failed", "triangles", "kept",
        "dropped.zero_area", "tiles_hidden", "passed"}) {
    EXPECT_EQ(all.count(name), 1u) << name;
  }
  EXPECT_EQ(all.at("setup.busy").json, "/units/setup/busy");
  EXPECT_EQ(all.at("prims.level_0").json, "/fifos/prims/levels/0");
  EXPECT_EQ(all.at("depth_read.stalls").json, "/port_stalls/depth_read");
  EXPECT_EQ(all.at("stamps_of_16_samples").json, "/stamps_by_samples/16");
  EXPECT_EQ(all.at("samples_failed").json, "/depth_tests/failed");
  EXPECT_EQ(all.at("kept").json, "");
  EXPECT_EQ(all.at("tiles_hidden").json, "/counters/tiles/hidden");
}

TEST(CounterTable, EveryRowHasAPlaceAUnitAndAMeaning) {
  std::set<std::string> places;
  for (const auto& [name, row] : rows(kWide)) {
    EXPECT_TRUE(places.insert(row.json).second) << name;
    EXPECT_NE(std::string(row.unit), "") << name;
    EXPECT_NE(row.meaning, "") << name;
    EXPECT_EQ(row.rtl.empty(), name == "drained") << name;
  }
}

// docs/counters.md has the rows of high_tile, in their order.
TEST(CounterTable, IsTheOneInTheDocument) {
  const spec::Contract contract = spec::contract(spec::kHighTile);
  const auto code = [](const std::string& text) { return text.empty() ? "" : "`" + text + "`"; };
  std::vector<std::string> expected;
  const timing::FrameResult none = timing::empty_result(contract);
  timing::for_each_counter(contract, none, [&](const Counter& row, auto) {
    expected.push_back("| " + code(row.name) + " | " + code(row.json) + " | " + row.unit + " | " +
                       row.meaning + " |");
  });
  std::ifstream document(PINEDA_COUNTERS_DOCUMENT);
  ASSERT_TRUE(document);
  std::vector<std::string> got;
  for (std::string line; std::getline(document, line);) {
    if (line.rfind("| `", 0) == 0) got.push_back(line);
  }
  EXPECT_EQ(got, expected) << "docs/counters.md should have\n"
                           << fmt::format("{}", fmt::join(expected, "\n"));
}

TEST(CounterTable, DesignWithoutDepthHasNoRtlBehindItsDepthPorts) {
  const auto all = rows(kFlat);
  EXPECT_EQ(all.at("depth_read.stalls").rtl, "");
  EXPECT_EQ(all.at("depth_write.stalls").rtl, "");
  EXPECT_EQ(all.at("color_write.stalls").rtl, "color_write_stalls");
}

// An event of kind k is a stamp of k samples.
TEST(CounterTable, EventsOfTheRtlAreAddedAsTheRowSays) {
  const auto sum = [](const std::string& name) {
    const uint64_t events[] = {1000, 100, 10, 1};
    const core::RtlKinds kinds = rows(kWide).at(name).kinds;
    uint64_t total = 0;
    for (size_t kind = 0; kind < 4; ++kind) total += kinds.times(kind) * events[kind];
    return total;
  };
  EXPECT_EQ(sum("stamps"), 1111u);
  EXPECT_EQ(sum("fragments"), 0 * 1000u + 1 * 100 + 2 * 10 + 3 * 1);
  EXPECT_EQ(sum("interpolated"), 111u);
  EXPECT_EQ(sum("tiles_rejected"), 10u);
  EXPECT_EQ(sum("stamps_of_0_samples"), 1000u);
}

TEST(FrameCounterTable, ReadsAndWritesTheMemberOfEachRow) {
  core::FrameCounters counters;
  uint64_t value = 1000;
  for (const FrameCounter& row : kFrameCounters) row.of(counters) = ++value;
  EXPECT_EQ(counters.triangles, 1001u);
  EXPECT_EQ(counters.dropped, (std::array<uint64_t, 5>{1002, 1003, 1004, 1005, 1006}));
  EXPECT_EQ(counters.tiles_tested, 1007u);
  EXPECT_EQ(counters.tiles_rejected, 1008u);
  EXPECT_EQ(counters.tiles_accepted, 1009u);
  EXPECT_EQ(counters.tiles_hidden, 1010u);
  EXPECT_EQ(counters.stamps, 1011u);
  EXPECT_EQ(counters.fragments, 1012u);
  EXPECT_EQ(counters.interpolated, 1013u);
  EXPECT_EQ(counters.passed, 1014u);
}

// A drop's name, for people, has spaces; its key, for files, has underscores: the words are the
// same.
TEST(FrameCounterTable, DropsAreSpelledAsTheirNames) {
  for (int i = 1; i < core::kDropCauses; ++i) {
    std::string words = spec::name_of(static_cast<Drop>(i));
    std::replace(words.begin(), words.end(), '_', ' ');
    EXPECT_EQ(words, core::drop_name(static_cast<Drop>(i)));
  }
}

TEST(CounterDifferences, TheOneThatDiffersIsNamedWithBothCounts) {
  auto rtl = distinct(1);
  rtl.spent.units[0][timing::Cause::kBlocked] = -7;
  const auto model = timing::counter_list(kWide, distinct(1));
  const auto differences = timing::counter_differences(model, timing::counter_list(kWide, rtl));
  ASSERT_EQ(differences.size(), 1u);
  EXPECT_EQ(differences[0].name, "setup.blocked");
  EXPECT_EQ(differences[0].model, 4);
  EXPECT_EQ(differences[0].rtl, -7);
  EXPECT_TRUE(timing::counter_differences(model, model).empty());
}

// A counter that is counted wrongly is noticed, whichever it is.
TEST(CounterDifferences, EveryCounterIsCompared) {
  const auto model = timing::counter_list(kWide, distinct(1));
  for (size_t i = 0; i < model.size(); ++i) {
    auto rtl = distinct(1);
    size_t at = 0;
    timing::for_each_counter(kWide, rtl, [&](const Counter&, auto& count) {
      if (at++ == i) ++count;
    });
    const auto differences = timing::counter_differences(model, timing::counter_list(kWide, rtl));
    ASSERT_EQ(differences.size(), 1u) << model[i].name;
    EXPECT_EQ(differences[0].name, model[i].name);
    EXPECT_EQ(differences[0].rtl, differences[0].model + 1);
  }
}

TEST(CounterDifferences, OfAnotherDesignAreRefused) {
  auto deeper = distinct(1);
  deeper.spent.levels[0].push_back(0);
  const auto list = timing::counter_list(kWide, distinct(1));
  EXPECT_THROW(timing::counter_differences(list, timing::counter_list(kWide, deeper)),
               std::invalid_argument);
}

}  // namespace
}  // namespace pineda::test
