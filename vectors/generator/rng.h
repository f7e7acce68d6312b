// The generator's own random numbers: the same on every machine and with every library.
#pragma once

#include <cstdint>

namespace pineda::vectors {

/// splitmix64 (Steele, Lea, Flood, OOPSLA 2014). Not std::: its distributions differ by library.
class Rng {
 public:
  explicit Rng(uint64_t seed) : state_(seed) {}

  uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// low to high, both included. The bias of the remainder (below 2^-20 here) does not matter.
  int64_t between(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(next() % (static_cast<uint64_t>(high - low) + 1));
  }

  bool coin() { return (next() >> 63) != 0; }

 private:
  uint64_t state_;
};

}  // namespace pineda::vectors
