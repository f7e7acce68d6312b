// The memory ports, and the cycles in which they move.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pineda::memory {

/// A cycle of the frame. Cycle 0 is the first clock edge after reset: the frame is taken.
using Cycle = int64_t;

/// The memory ports, in the order in which they are served within a cycle.
enum class MemoryPort : uint8_t { kDepthRead, kDepthWrite, kColorWrite };
inline constexpr size_t kMemoryPorts = 3;
const char* port_name(MemoryPort port);  // "depth_read", "depth_write", "color_write"

}  // namespace pineda::memory
