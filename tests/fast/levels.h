// Tests of fast run at each level of vectors that the machine has.
#pragma once

#include <gtest/gtest.h>

#include "model/fast/level.h"

namespace pineda::test {

/// Calls work() with the kernels of each level; afterwards they are those of the greatest one.
template <class Work>
void for_each_level(Work&& work) {
  for (const fast::Level level : fast::levels()) {
    SCOPED_TRACE(testing::Message() << "level " << fast::level_name(level));
    fast::set_level(level);
    work();
  }
}

}  // namespace pineda::test
