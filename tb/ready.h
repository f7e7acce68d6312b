// The stalls of the benches, as the cycle model takes them.
#pragma once

#include "model/timing/ports/memory.h"

namespace pineda::tb {

/// Empty where nobody stalls.
inline timing::Ready ready_of(const memory::Stalls& stalls) {
  if (!stalls.any()) return {};
  return memory::Moving(stalls);
}

}  // namespace pineda::tb
