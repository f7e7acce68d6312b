// Samples side by side, for the loops over blocks of a tile.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

namespace pineda::core {

typedef int32_t Int32x8 __attribute__((vector_size(32)));
typedef uint32_t Uint32x8 __attribute__((vector_size(32)));
typedef int64_t Int64x8 __attribute__((vector_size(64)));
typedef int64_t Int64x16 __attribute__((vector_size(128)));
typedef uint64_t Uint64x8 __attribute__((vector_size(64)));
typedef int32_t Int32x16 __attribute__((vector_size(64)));
typedef uint32_t Uint32x16 __attribute__((vector_size(64)));
typedef uint16_t Uint16x16 __attribute__((vector_size(32)));
typedef uint64_t Uint64x2 __attribute__((vector_size(16)));
typedef uint32_t Uint32x4 __attribute__((vector_size(16)));
typedef int32_t Int32x4 __attribute__((vector_size(16)));  // four attributes
typedef int64_t Int64x4 __attribute__((vector_size(32)));
typedef uint64_t Uint64x4 __attribute__((vector_size(32)));

inline constexpr Int32x8 kLaneNumbers = {0, 1, 2, 3, 4, 5, 6, 7};
inline constexpr Int32x16 kRowNumbers = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
inline constexpr Int32x16 kLeftHalf = {0, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1, -1, -1, -1, -1, -1};
inline constexpr Uint32x8 kLaneBits = {1, 2, 4, 8, 16, 32, 64, 128};

/// Vectors cross no call: what takes one is inlined into a function of PINEDA_CLONES.
#define PINEDA_INLINE inline __attribute__((always_inline))
#define PINEDA_INLINED __attribute__((always_inline))  // of a lambda

/// Compiles a function for several vector units of one architecture and picks one at start-up; the
/// bits are the same. Not under the sanitizers, whose own start-up comes later than that choice.
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__clang__)
#define PINEDA_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PINEDA_CLONES
#endif

}  // namespace pineda::core
