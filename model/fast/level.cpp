#include "model/fast/level.h"

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

void set_level(Level level) { detail::level = level; }

namespace {
[[maybe_unused]] const bool kIsSet = (set_level(levels().back()), true);
}

}  // namespace pineda::fast
