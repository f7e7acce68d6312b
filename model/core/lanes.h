// Eight samples side by side, for the loops over blocks of a tile.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

namespace pineda::core {

typedef int32_t Int32x8 __attribute__((vector_size(32)));
typedef uint32_t Uint32x8 __attribute__((vector_size(32)));
typedef int64_t Int64x8 __attribute__((vector_size(64)));
typedef int32_t Int32x4 __attribute__((vector_size(16)));  // four attributes
typedef int64_t Int64x4 __attribute__((vector_size(32)));
typedef uint64_t Uint64x4 __attribute__((vector_size(32)));

inline constexpr Int32x8 kLaneNumbers = {0, 1, 2, 3, 4, 5, 6, 7};
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

/// Gathers the rows of a block, each a vector of lanes that are all ones or zeros, to its 64 bits.
class BlockBits {
 public:
  PINEDA_INLINE void add(int row, const Uint32x8& lanes) {
    if (row < 4) {
      low_ |= lanes & (kLaneBits << (8 * row));
    } else {
      high_ |= lanes & (kLaneBits << (8 * (row - 4)));
    }
  }
  PINEDA_INLINE uint64_t bits() const { return fold(low_) | fold(high_) << 32; }

 private:
  PINEDA_INLINE static uint64_t fold(const Uint32x8& v) {
    std::array<uint64_t, 4> word;
    std::memcpy(word.data(), &v, sizeof v);
    const uint64_t both = word[0] | word[1] | word[2] | word[3];
    return static_cast<uint32_t>(both | both >> 32);
  }
  Uint32x8 low_ = {};
  Uint32x8 high_ = {};
};

}  // namespace pineda::core
