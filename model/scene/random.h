// Random numbers for built-in scenes: the same everywhere, unlike the distributions of <random>.
#pragma once

#include <cstdint>

namespace pineda::scene {

/// SplitMix64. Draw in braces or in separate statements: the order in which a call's arguments are
/// evaluated differs among compilers.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  uint64_t bits() {
    uint64_t x = state_ += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  /// In [low, high); 24 random bits.
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(bits() >> 40) * 0x1p-24f;
  }
  /// In [low, high], both included.
  int in(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<uint64_t>(high - low + 1));
  }
  bool coin() { return (bits() & 1) != 0; }

 private:
  uint64_t state_;
};

}  // namespace pineda::scene
