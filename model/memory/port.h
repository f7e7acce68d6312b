// The memory ports, and the type of a clock cycle's number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "model/spec/names.h"

namespace pineda::memory {

/// The number of a clock cycle in a frame. Cycle 0 is the first clock edge after reset, when the
/// frame's state is sampled.
using Cycle = int64_t;

/// The memory ports, in the order in which they are served within a cycle.
enum class MemoryPort : uint8_t { kDepthRead, kDepthWrite, kColorWrite };

inline constexpr spec::Name<MemoryPort> kMemoryPortNames[] = {
    {MemoryPort::kDepthRead, "depth_read"},
    {MemoryPort::kDepthWrite, "depth_write"},
    {MemoryPort::kColorWrite, "color_write"},
};
constexpr const auto& names(MemoryPort) { return kMemoryPortNames; }
inline constexpr size_t kMemoryPorts = std::size(kMemoryPortNames);

constexpr const char* port_name(MemoryPort port) { return spec::name_of(port); }

}  // namespace pineda::memory
