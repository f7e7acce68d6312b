#include "model/fast/level.h"

#include <hwy/targets.h>

namespace pineda::fast {

namespace detail {
Level level = Level::kBase;
}

std::vector<Level> levels() {
  std::vector<Level> all{Level::kBase};
#if defined(__x86_64__)
  // Checks some of what x86-64-v3 and v4 add; processors with these features have the others, too.
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi2") ||
      !__builtin_cpu_supports("fma")) {
    return all;
  }
  all.push_back(Level::kAvx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    all.push_back(Level::kAvx512);
  }
#endif
  return all;
}

const char* level_name(Level level) {
  switch (level) {
    case Level::kAvx512:
      return "avx512";
    case Level::kAvx2:
      return "avx2";
    case Level::kBase:
      break;
  }
#if defined(__aarch64__)
  return "neon";
#else
  return "base";
#endif
}

#if defined(__x86_64__)
namespace {

// The targets of Highway that a level may use. Better ones have lower bits.
int64_t targets_of(Level level) {
  switch (level) {
    case Level::kAvx512:
      break;
    case Level::kAvx2:
      return ~(HWY_AVX2 - 1);
    case Level::kBase:
      return ~(HWY_SSE4 - 1);
  }
  return ~int64_t{0};
}

}  // namespace
#endif

void set_level(Level level) {
  detail::level = level;
#if defined(__x86_64__)  // elsewhere Highway has one target, and no choice
  hwy::GetChosenTarget().Update(hwy::SupportedTargets() & targets_of(level));
#endif
}

namespace {
[[maybe_unused]] const bool kIsSet = (set_level(levels().back()), true);
}

}  // namespace pineda::fast
