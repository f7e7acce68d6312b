// What this machine can do at most of what the quick model does: moving memory, multiplying.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pineda::bench {

/// Products of 64 bits that one call makes, none of which waits for more than one other.
inline constexpr size_t kWordProducts = size_t{1} << 16;
uint64_t multiply_words(uint64_t factor);

/// The same of 32-bit lanes, in the vectors of the selected level; a call makes so many products.
size_t lane_products();
uint32_t multiply_lanes(uint32_t factor);

}  // namespace pineda::bench
