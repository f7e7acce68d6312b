// The reciprocal of the doubled area, quickly.
#pragma once

#include "model/core/reciprocal.h"

namespace pineda::fast {

/// Bits     those of core::reciprocal().
core::Reciprocal reciprocal(const spec::Contract& contract, int64_t area2);

}  // namespace pineda::fast
