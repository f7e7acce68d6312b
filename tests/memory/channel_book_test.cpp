// Booking times of a channel by time stamp.
#include "model/memory/channel_book.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "model/spec/random.h"

namespace pineda::memory {
namespace {

TEST(ChannelBook, ServesOneAfterTheOther) {
  ChannelBook book;
  EXPECT_EQ(book.book(10, 4), 10u);
  EXPECT_EQ(book.book(10, 4), 14u);
  EXPECT_EQ(book.book(11, 4), 18u);
  EXPECT_EQ(book.book(30, 4), 30u);
  EXPECT_EQ(book.busy(), 16u);
}

// Heard of later, arrived earlier: the gap before what is booked already.
TEST(ChannelBook, EarlierArrivalGetsTheEarlierGap) {
  ChannelBook book;
  book.book(100, 10);
  book.book(120, 10);
  EXPECT_EQ(book.book(50, 10), 50u);
  EXPECT_EQ(book.book(95, 10), 110u);  // the gap before 100 is too short, that before 120 is not
  EXPECT_EQ(book.book(95, 6), 130u);
  EXPECT_EQ(book.book(95, 5), 95u);
  EXPECT_EQ(book.kept(), 2u);  // 50 .. 60 and 95 .. 136
}

TEST(ChannelBook, NoTimeTakesNone) {
  ChannelBook book;
  book.book(10, 10);
  EXPECT_EQ(book.book(12, 0), 20u);
  EXPECT_EQ(book.book(5, 0), 5u);
  EXPECT_EQ(book.book(20, 3), 20u);
}

TEST(ChannelBook, WhatHasPassedIsForgotten) {
  ChannelBook book;
  for (ChannelBook::Time t = 0; t < 100'000; t += 10) {
    book.book(t, 4);
    book.forget(t > 100 ? t - 100 : 0);
    ASSERT_LE(book.kept(), 12u);
  }
  EXPECT_EQ(book.busy(), 40'000u);
  EXPECT_EQ(book.book(0, 1), 99'894u);  // as if it had come at the time that is remembered
}

// The mutant in mind: a book that serves in the order of calls. Against one tick a bit.
TEST(ChannelBook, IsThatOfABitATick) {
  spec::SplitMix64 random(7);
  for (int round = 0; round < 50; ++round) {
    ChannelBook book;
    std::vector<bool> busy(6000);
    for (int i = 0; i < 400; ++i) {
      const uint64_t arrival = random() % 2000;
      const uint64_t duration = 1 + random() % 9;
      uint64_t start = arrival;
      const auto free = [&](uint64_t at) {
        const auto first = busy.begin() + static_cast<long>(at);
        return std::none_of(first, first + static_cast<long>(duration), [](bool b) { return b; });
      };
      while (!free(start)) ++start;
      std::fill_n(busy.begin() + static_cast<long>(start), duration, true);
      ASSERT_EQ(book.book(arrival, duration), start);
    }
  }
}

}  // namespace
}  // namespace pineda::memory
