#include "vectors/grammar/cases.h"

namespace pineda::vectors {

const std::vector<Counter>& counters() {
#define PINEDA_COUNTER(label, member)                                    \
  Counter {                                                              \
    label, [](const core::FrameCounters& c) { return c.member; },        \
        [](core::FrameCounters& c, uint64_t value) { c.member = value; } \
  }
  static const std::vector<Counter> all{
      PINEDA_COUNTER("triangles", triangles),
      PINEDA_COUNTER("kept", dropped[static_cast<size_t>(core::Drop::kNone)]),
      PINEDA_COUNTER("zero_area", dropped[static_cast<size_t>(core::Drop::kZeroArea)]),
      PINEDA_COUNTER("facing", dropped[static_cast<size_t>(core::Drop::kFacing)]),
      PINEDA_COUNTER("no_sample", dropped[static_cast<size_t>(core::Drop::kNoSample)]),
      PINEDA_COUNTER("outside", dropped[static_cast<size_t>(core::Drop::kOutside)]),
      PINEDA_COUNTER("tiles_tested", tiles_tested),
      PINEDA_COUNTER("tiles_rejected", tiles_rejected),
      PINEDA_COUNTER("tiles_accepted", tiles_accepted),
      PINEDA_COUNTER("stamps", stamps),
      PINEDA_COUNTER("fragments", fragments),
      PINEDA_COUNTER("interpolated", interpolated),
      PINEDA_COUNTER("passed", passed),
  };
#undef PINEDA_COUNTER
  return all;
}

}  // namespace pineda::vectors
