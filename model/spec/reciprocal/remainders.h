// No reciprocal: planes are kept as exact quotients and remainders (core/exact_planes.h).
#pragma once

#include "model/spec/reciprocal/scheme.h"

namespace pineda::spec::remainders {

constexpr int no_cycles(const Design&, int) { return 0; }
constexpr int no_steps(const Design&) { return 0; }
inline double error_bound(const Design&) { return 0; }
inline std::string invalid_reason(const Design&) { return {}; }
inline std::vector<Constant> constants(const Design&) { return {}; }
constexpr int64_t logic_bits(const Design&, int) { return 0; }

inline constexpr Scheme kScheme{ReciprocalScheme::kNone,
                                "none",
                                "NONE",
                                false,
                                false,
                                false,
                                no_cycles,
                                no_steps,
                                error_bound,
                                invalid_reason,
                                constants,
                                logic_bits};

}  // namespace pineda::spec::remainders
