// Random numbers that are the same on every machine and with every library, unlike those of the
// distributions in <random>.
#pragma once

#include <cstdint>
#include <type_traits>

namespace pineda::spec {

/// SplitMix64, with the interface of an engine of <random> as far as it is needed here.
///
/// Source   Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014.
class SplitMix64 {
 public:
  explicit constexpr SplitMix64(uint64_t seed) : state_(seed) {}

  constexpr uint64_t operator()() { return mixed(state_ += kStep); }
  /// The result of the n-th call for `seed`, counted from 1, without making the calls before it.
  static constexpr uint64_t at(uint64_t seed, uint64_t n) { return mixed(seed + n * kStep); }

 private:
  static constexpr uint64_t kStep = 0x9e3779b97f4a7c15u;

  static constexpr uint64_t mixed(uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  uint64_t state_;
};

/// Draws from the 64-bit numbers of an engine. Draw in braces or in separate statements: the order
/// in which a call's arguments are evaluated differs among compilers.
template <class Engine>
class RandomFrom {
 public:
  explicit RandomFrom(uint64_t seed) : engine_(seed) {}

  uint64_t bits() { return engine_(); }
  /// A number from low to high, both included; fewer than 2^64 values. Taking the remainder favours
  /// some values slightly, which is negligible for ranges far smaller than 2^64.
  template <class Low, class High>
  std::common_type_t<Low, High> between(Low low, High high) {
    using Integer = std::common_type_t<Low, High>;
    static_assert(std::is_integral_v<Integer> && std::is_signed_v<Integer>);
    const auto values = static_cast<uint64_t>(high) - static_cast<uint64_t>(low) + 1;
    return static_cast<Integer>(static_cast<uint64_t>(low) + bits() % values);
  }
  bool coin() { return (bits() >> 63) != 0; }
  /// In [low, high); 24 random bits.
  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(bits() >> 40) * 0x1p-24f;
  }
  /// In [0, 1); 53 random bits.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  Engine engine_;
};

/// The project's generator. Another engine is used only where published figures were drawn with it.
using Random = RandomFrom<SplitMix64>;

}  // namespace pineda::spec
