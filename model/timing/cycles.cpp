#include "model/timing/cycles.h"

namespace pineda::timing {

const char* unit_name(Unit unit) {
  static constexpr const char* kNames[kUnits] = {"setup", "tiles", "stamps", "interp_ztest"};
  return kNames[static_cast<size_t>(unit)];
}

const char* cause_name(Cause cause) {
  static constexpr const char* kNames[kCauses] = {"busy", "starved", "blocked", "hazard", "memory"};
  return kNames[static_cast<size_t>(cause)];
}

const char* fifo_name(Fifo fifo) {
  static constexpr const char* kNames[kFifos] = {"prims", "tiles", "stamps"};
  return kNames[static_cast<size_t>(fifo)];
}

}  // namespace pineda::timing
