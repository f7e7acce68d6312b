#include "model/scene/read_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <new>
#include <string>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// Fills in 0, 1, 2, ... up to `count`, and says how many are filled.
auto numbers(int count, std::atomic<int>* filled) {
  return [count, filled](int* item) {
    if (*filled == count) return false;
    *item = (*filled)++;
    return true;
  };
}

TEST(ReadAhead, KeepsTheOrderAndEndsWhereTheItemsEnd) {
  for (const size_t items : {2u, 3u, 7u}) {
    for (const int count : {0, 1, 2, 3, 10000}) {
      std::atomic<int> filled{0};
      ReadAhead<int> ahead(items, numbers(count, &filled));
      int expected = 0;
      for (const int* item = ahead.next(); item != nullptr; item = ahead.next()) {
        ASSERT_EQ(*item, expected++);
      }
      EXPECT_EQ(expected, count);
      EXPECT_EQ(ahead.next(), nullptr);
    }
  }
}

TEST(ReadAhead, ReadsWhileTheCallerWorksAndNoFurtherThanItsItems) {
  std::atomic<int> filled{0};
  ReadAhead<int> ahead(3, numbers(1000, &filled));
  for (int i = 0; i < 5; ++i) {
    const int* const mine = ahead.next();
    while (filled < i + 3) wait_a_little();  // reads on without another call
    for (int wait = 0; wait < 5; ++wait) wait_a_little();
    EXPECT_EQ(filled, i + 3);  // not into the one that the caller has
    EXPECT_EQ(*mine, i);
  }
}

TEST(ReadAhead, ReusesItsItems) {
  std::atomic<int> filled{0};
  ReadAhead<int> ahead(3, numbers(30, &filled));
  const int* const first = ahead.next();
  for (int i = 1; i < 30; ++i) EXPECT_EQ(ahead.next() == first, i % 3 == 0) << i;
}

TEST(ReadAhead, ThrowsWhatReadingThrewAfterTheItemsBefore) {
  ReadAhead<int> ahead(3, [n = 0](int* item) mutable {
    if (n == 5) throw InputError("file", "expected six");
    *item = n++;
    return true;
  });
  for (int i = 0; i < 5; ++i) EXPECT_EQ(*ahead.next(), i);
  for (int again = 0; again < 2; ++again) {
    try {
      ahead.next();
      FAIL() << "expected an exception";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), InputError("file", "expected six").what());
    }
  }
  ReadAhead<int> full(2, [](int*) -> bool { throw std::bad_alloc(); });
  EXPECT_THROW(full.next(), std::bad_alloc);
}

TEST(ReadAhead, ErrorThatNobodyAsksForIsDropped) {
  const ReadAhead<int> ahead(2, [](int*) -> bool { throw std::bad_alloc(); });
}

TEST(ReadAhead, EndsWithACallerThatStopsEarly) {
  for (const int taken : {0, 1, 4}) {
    auto owned = std::make_shared<int>(0);
    const std::weak_ptr<int> alive = owned;
    {
      ReadAhead<int> ahead(3, [owned = std::move(owned)](int* item) {
        *item = (*owned)++;
        return true;  // without end
      });
      for (int i = 0; i < taken; ++i) EXPECT_EQ(*ahead.next(), i);
    }
    EXPECT_TRUE(alive.expired());
  }
}

TEST(ReadAhead, EndsWithACallerThatThrows) {
  std::atomic<int> filled{0};
  const auto work = [&] {
    ReadAhead<int> ahead(3, numbers(1000, &filled));
    ahead.next();
    throw std::bad_alloc();
  };
  EXPECT_THROW(work(), std::bad_alloc);
  const int then = filled;
  wait_a_little();
  EXPECT_EQ(filled, then);
  EXPECT_LE(then, 4);
}

}  // namespace
}  // namespace pineda::scene
