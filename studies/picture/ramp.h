// Colours along a scale, of pictures made of pixels.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pineda::studies {

using Rgb = std::array<uint8_t, 3>;

/// The colour at a place of the ramp. Two stops at one place: a jump.
struct Stop {
  double at;
  Rgb color;
};

/// The colour at `at`, 0 to 1, between the stops on both sides of it.
template <size_t N>
Rgb color_along(const std::array<Stop, N>& ramp, double at) {
  for (size_t i = 1; i < N; ++i) {
    const Stop& low = ramp[i - 1];
    const Stop& high = ramp[i];
    if (at > high.at || low.at >= high.at) continue;
    const double share = (at - low.at) / (high.at - low.at);
    Rgb color{};
    for (size_t k = 0; k < color.size(); ++k) {
      const double step = share * (high.color[k] - low.color[k]);
      color[k] = static_cast<uint8_t>(std::lround(low.color[k] + step));
    }
    return color;
  }
  return ramp[N - 1].color;
}

}  // namespace pineda::studies
