#include "model/scene/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace pineda::scene {

void set_scissor(int x_px, int y_px, int width_px, int height_px, spec::FrameState* frame) {
  // No frame reaches below 0 or beyond kNoScissorPx, so clamping changes nothing.
  const auto inside = [](int64_t px) {
    return static_cast<int>(std::clamp<int64_t>(px, 0, spec::kNoScissorPx));
  };
  frame->scissor_x0 = inside(x_px);
  frame->scissor_y0 = inside(y_px);
  frame->scissor_x1 = inside(int64_t{x_px} + width_px);
  frame->scissor_y1 = inside(int64_t{y_px} + height_px);
}

std::optional<int64_t> parse_bias_constant(const char* word, int depth_bits) {
  const char* end = word + std::strlen(word);
  const int64_t greatest = (int64_t{1} << depth_bits) - 1;
  int64_t value = 0;
  const auto result = std::from_chars(word, end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  if (value < -greatest || value > greatest) return std::nullopt;
  return value;
}

std::string expected_bias_constant(int depth_bits) {
  return fmt::format("a bias in whole depth codes from -{0} to {0}",
                     (int64_t{1} << depth_bits) - 1);
}

std::optional<BiasSlope> parse_bias_slope(const char* word) {
  char* end = nullptr;
  const double value = std::strtod(word, &end);
  if (end == word || *end != '\0' || !(value >= -128 && value < 128)) return std::nullopt;
  constexpr double kUnits = 1 << spec::kBiasFactorFractionBits;
  constexpr double kGreatest = (1 << (spec::kBiasSlopeBits - 1)) - 1;
  const double scaled = value * kUnits;
  const double rounded = std::min(std::nearbyint(scaled), kGreatest);
  return BiasSlope{static_cast<int32_t>(rounded), rounded != scaled};
}

std::optional<float> parse_clear_depth(const char* word) {
  char* end = nullptr;
  const float value = std::strtof(word, &end);
  if (end == word || *end != '\0' || !(value >= 0 && value <= 1)) return std::nullopt;
  return std::abs(value);  // -0 is 0
}

std::string unusual_state(const spec::FrameState& f) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (is_cut(f)) {
    add(fmt::format("scissor {},{},{},{} px", f.clip_x0(), f.clip_y0(),
                    std::max(f.clip_x1() - f.clip_x0(), 0),
                    std::max(f.clip_y1() - f.clip_y0(), 0)));
  }
  if (!f.depth_write) add("depth write off");
  if (f.has_bias()) {
    add(fmt::format("depth bias {},{}", f.bias_constant,
                    std::ldexp(static_cast<double>(f.bias_slope), -spec::kBiasFactorFractionBits)));
  }
  if (f.clear_depth != 1) {
    add(fmt::format("clear depth {}", static_cast<float>(f.clear_depth)));
  }
  if (f.shade != spec::Shade::kSmooth) add(std::string("shade ") + name_of(f.shade));
  return text;
}

}  // namespace pineda::scene
