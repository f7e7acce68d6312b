// What happened to the triangles and samples of a frame.
#pragma once

#include "model/core/setup.h"

namespace pineda::core {

struct FrameCounters {
  uint64_t triangles = 0;
  std::array<uint64_t, kDropCauses> dropped{};  // by Drop
  uint64_t tiles_tested = 0;
  uint64_t tiles_rejected = 0;
  uint64_t tiles_accepted = 0;  // all three edges accept
  uint64_t tiles_hidden = 0;    // not rejected, but behind what is stored there: hierarchical z
  uint64_t stamps = 0;          // sent, so not empty
  uint64_t fragments = 0;       // covered samples sent
  uint64_t interpolated = 0;    // stamps with a sample that passed: whose attributes were needed
  uint64_t passed = 0;          // samples written
};

}  // namespace pineda::core
