// Samples side by side, for the loops over blocks of a tile.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "model/fast/level.h"

namespace pineda::fast {

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

}  // namespace pineda::fast
