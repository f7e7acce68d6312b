#include "model/memory/port.h"

namespace pineda::memory {

const char* port_name(MemoryPort port) {
  static constexpr const char* kNames[kMemoryPorts] = {"depth_read", "depth_write", "color_write"};
  return kNames[static_cast<size_t>(port)];
}

}  // namespace pineda::memory
