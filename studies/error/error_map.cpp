#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "studies/error/error_pictures.h"
#include "studies/picture/ramp.h"
#include "studies/picture/svg.h"

namespace pineda::studies {
namespace {

constexpr double kRounding = .5;       // ulp or LSB: what the final rounding alone may make
constexpr double kRoundingShare = .2;  // of the ramp
constexpr Rgb kNothing{0, 0, 0};
constexpr Rgb kMissing{0, 255, 255};
constexpr Rgb kExtra{255, 0, 255};

// Lightness grows throughout, so that the map can be read without hues. The hue jumps where errors
// exceed those of final rounding.
constexpr std::array<Stop, 7> kRamp{{{0, {10, 20, 56}},
                                     {kRoundingShare, {24, 62, 130}},
                                     {kRoundingShare, {142, 26, 112}},
                                     {.45, {196, 58, 80}},
                                     {.65, {237, 105, 37}},
                                     {.82, {251, 165, 10}},
                                     {1, {252, 255, 180}}}};

Rgb ramp(double at) { return color_along(kRamp, at); }

std::string hex(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

const Distribution& errors_of(const Subject& s, Quantity quantity) {
  return quantity == Quantity::kDepth ? s.depth : s.color;
}

}  // namespace

ErrorScale::ErrorScale(const ErrorStudy& study, Quantity quantity) : quantity_(quantity) {
  double greatest = 0;
  for (const Subject& s : study.subjects) {
    greatest = std::max(greatest, errors_of(s, quantity).max());
  }
  while (greatest_ < greatest && greatest_ < 1e12) greatest_ *= 10;
}

double ErrorScale::at(double error) const {
  if (error <= kRounding) return kRoundingShare * std::max(error, 0.) / kRounding;
  const double octaves = std::log(error / kRounding) / std::log(greatest_ / kRounding);
  return kRoundingShare + (1 - kRoundingShare) * std::min(octaves, 1.);
}

std::vector<uint8_t> error_map_rgb(const ErrorMap& map, const ErrorScale& scale) {
  const auto& errors = scale.quantity() == Quantity::kDepth ? map.depth_ulp : map.color_lsb;
  std::vector<uint8_t> pixels;
  pixels.reserve(3 * errors.size());
  for (size_t i = 0; i < errors.size(); ++i) {
    const double error = errors[i];
    const bool drawn = error >= 0;  // neither negative nor NaN
    Rgb color = drawn ? ramp(scale.at(error)) : kNothing;
    if ((map.coverage[i] & 2) != 0) color = kExtra;
    if ((map.coverage[i] & 1) != 0) color = kMissing;
    pixels.insert(pixels.end(), color.begin(), color.end());
  }
  return pixels;
}

std::string error_scale_svg(const ErrorScale& scale) {
  constexpr Box kStrip{12, 24, 460, 16};
  constexpr int kSteps = 230;
  constexpr double kTextY = kStrip.top + kStrip.height + 16;
  const bool depth = scale.quantity() == Quantity::kDepth;
  Svg svg(900, 64, "Colours of the error maps");
  svg.text({kStrip.left, 15},
           depth ? "largest depth error of a pixel, ulp; blue: final rounding alone"
                 : "largest colour error of a pixel, LSB; blue: final rounding alone",
           {12, kGrey});
  for (int i = 0; i < kSteps; ++i) {
    const double width = kStrip.width / kSteps;
    const std::string color = hex(ramp((i + .5) / kSteps));
    // Each rectangle extends under the next one, so that no seams show.
    svg.rectangle(
        {kStrip.left + i * width, kStrip.top, std::min(2, kSteps - i) * width, kStrip.height},
        {color.c_str()});
  }
  const auto tick = [&](double error, const std::string& text) {
    const double x = kStrip.left + kStrip.width * scale.at(error);
    svg.line({x, kStrip.bottom()}, {x, kStrip.bottom() + 4}, {"none", kGrey});
    svg.text({x, kTextY}, text, {11, kGrey, Anchor::kMiddle});
  };
  tick(0, "0");
  tick(kRounding, "½");
  const int decades = static_cast<int>(std::lround(std::log10(scale.greatest())));
  for (int decade = decades; decade > 0; decade -= decades > 6 ? 2 : 1) {
    tick(std::pow(10, decade), power_of_ten(decade));
  }
  double x = kStrip.right() + 30;
  const std::array<std::pair<Rgb, const char*>, 3> swatches{
      {{kMissing, "sample missing"}, {kExtra, "one too many"}, {kNothing, "nothing drawn"}}};
  for (const auto& [color, text] : swatches) {
    svg.rectangle({x, kStrip.top, 16, 16}, {hex(color).c_str(), kGrey});
    svg.text({x + 22, kStrip.top + 12}, text, {12, kInk});
    x += 22 + text_width(text, 12) + 14;
  }
  return svg.file();
}

std::string map_file(const Subject& subject) {
  std::string name = subject.name;
  for (char& c : name) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isalnum(u) == 0 && c != '_' && c != '-' && c != '.') c = '_';
  }
  return "maps/" + name + ".png";
}

}  // namespace pineda::studies
