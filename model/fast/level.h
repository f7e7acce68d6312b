// One source of a kernel for several vector units, and which of them this machine has.
#pragma once

#include <vector>

namespace pineda::fast {

/// What a kernel is compiled for; the bits are the same at every level. The base is what every
/// processor has, and of Highway's kernels the best one below AVX2: SSE4 or NEON.
enum class Level { kBase, kAvx2, kAvx512 };

/// "base" (on ARM "neon"), "avx2", "avx512".
const char* level_name(Level level);

/// The levels that this machine can run, kBase first.
std::vector<Level> levels();

/// Selects the level; must not be called while another thread draws. During start-up the level is
/// kBase, then the greatest of levels() unless a test selects another one.
void set_level(Level level);

namespace detail {
extern Level level;  // whose kernels are called
}

/// No vector is passed in a call: functions that take vectors are inlined into a kernel.
#define PINEDA_INLINE inline __attribute__((always_inline))
#define PINEDA_INLINED __attribute__((always_inline))  // for lambdas

/// PINEDA_KERNEL(RESULT, NAME, (PARAMETERS), (ARGUMENTS)) { ... } defines a function that is
/// compiled for each level and calls the version of the selected level: with GCC and clang, under
/// the sanitizers, too.
#if defined(__x86_64__)
#define PINEDA_KERNEL(result, name, parameters, arguments)                           \
  PINEDA_INLINE result name##_body parameters;                                       \
  static result name##_base parameters { return name##_body arguments; }             \
  __attribute__((target("arch=x86-64-v3"))) static result name##_avx2 parameters {   \
    return name##_body arguments;                                                    \
  }                                                                                  \
  __attribute__((target("arch=x86-64-v4"))) static result name##_avx512 parameters { \
    return name##_body arguments;                                                    \
  }                                                                                  \
  result name parameters {                                                           \
    switch (::pineda::fast::detail::level) {                                         \
      case ::pineda::fast::Level::kAvx512:                                           \
        return name##_avx512 arguments;                                              \
      case ::pineda::fast::Level::kAvx2:                                             \
        return name##_avx2 arguments;                                                \
      case ::pineda::fast::Level::kBase:                                             \
        break;                                                                       \
    }                                                                                \
    return name##_base arguments;                                                    \
  }                                                                                  \
  PINEDA_INLINE result name##_body parameters
#else
#define PINEDA_KERNEL(result, name, parameters, arguments) result name parameters
#endif

}  // namespace pineda::fast
