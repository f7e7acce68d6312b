#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/error/error_pictures.h"
#include "studies/picture/numbers.h"
#include "studies/picture/svg.h"

namespace pineda::studies {
namespace {

constexpr double kWidthPx = 900;
constexpr double kHeadPx = 112;
constexpr double kRowPx = 38;
constexpr double kBarsPx = 30;  // the height of a share of 1
constexpr double kFootPx = 66;
constexpr double kNameRightPx = 168;
constexpr double kZeroPx = 16;  // the bar of exact values
constexpr double kHairlinePx = 1.5;
// Errors below 2^-9 share one bar: rounding alone makes a share of 2^-8 so small.
constexpr int kLeastOctave = -9;
constexpr int kFewestOctaves = 12;

// One column of the picture: depth or colour.
class Panel {
 public:
  Panel(const ErrorStudy& study, Quantity quantity, double left, double width)
      : quantity_(quantity), left_(left), width_(width) {
    for (const Subject& s : study.subjects) {
      const auto octaves = errors(s).octaves();
      if (!octaves.empty()) last_ = std::max(last_, octaves.back().octave);
      if (s.bounds) last_ = std::max(last_, static_cast<int>(std::floor(std::log2(bound(s)))));
    }
  }

  void draw_frame(Svg* svg, double bottom) const {
    const bool depth = quantity_ == Quantity::kDepth;
    svg->text({left_, kHeadPx - 14}, depth ? "depth error, ulp" : "colour error, LSB",
              {13, kInk, Anchor::kStart, true});
    svg->text({left_ + width_ + 46, kHeadPx - 14}, "largest", {11, kGrey, Anchor::kEnd});
    svg->text({left_ + kZeroPx / 2, bottom + 18}, "0", {11, kGrey, Anchor::kMiddle});
    for (int octave = kLeastOctave; octave <= last_ + 1; ++octave) {
      const double x = at(octave);
      const bool named = octave % step() == 0;
      svg->line({x, bottom}, {x, bottom + (named ? 6 : 3)}, {"none", kGrey});
      if (named) svg->text({x, bottom + 18}, power_of_two(octave), {11, kGrey, Anchor::kMiddle});
    }
    svg->line({at(-1), kHeadPx - 8}, {at(-1), bottom}, {"none", kInk, 1, "3 3"});
    svg->text({at(-1), bottom + 32}, "½", {12, kInk, Anchor::kMiddle});
  }

  void draw_row(Svg* svg, const Subject& s, double base) const {
    const Distribution& d = errors(s);
    svg->line({left_, base}, {left_ + width_, base}, {"none", kFaint});
    if (d.count() == 0) {
      svg->text({at(0), base - 8}, "nothing judged", {11, kGrey});
      return;
    }
    const char* color = s.is_design ? kDesignColor : kBaselineColor;
    const auto bar = [&](double x, double width, uint64_t count) {
      const double share = static_cast<double>(count) / static_cast<double>(d.count());
      const double height = std::max(kBarsPx * std::sqrt(share), kHairlinePx);
      if (count != 0) svg->rectangle({x + .5, base - height, width - 1, height}, {color});
    };
    bar(left_, kZeroPx, d.zeros());
    uint64_t small = 0;
    for (const auto& octave : d.octaves()) {
      if (octave.octave <= kLeastOctave) {
        small += octave.count;
      } else {
        bar(at(octave.octave), octave_px(), octave.count);
      }
    }
    bar(at(kLeastOctave), octave_px(), small);
    draw_bound(svg, s, base);
    svg->text({left_ + width_ + 46, base - 4}, figure(d.max()), {11, kInk, Anchor::kEnd});
  }

 private:
  const Distribution& errors(const Subject& s) const {
    return quantity_ == Quantity::kDepth ? s.depth : s.color;
  }

  double bound(const Subject& s) const {
    return quantity_ == Quantity::kDepth ? s.bounds->depth_ulp : s.bounds->attribute_lsb;
  }

  void draw_bound(Svg* svg, const Subject& s, double base) const {
    if (!s.bounds) return;
    const double x = at(std::log2(bound(s)));
    svg->line({x, base - kBarsPx}, {x, base + 3}, {"none", "#b3261e", 2});
  }

  double octave_px() const { return (width_ - kZeroPx - 6) / (last_ + 1 - kLeastOctave); }
  double at(double octave) const {
    return left_ + kZeroPx + 6 + (octave - kLeastOctave) * octave_px();
  }
  int step() const { return last_ - kLeastOctave < 14 ? 2 : last_ - kLeastOctave < 28 ? 4 : 8; }

  Quantity quantity_;
  double left_;
  double width_;
  int last_ = kLeastOctave + kFewestOctaves;
};

void draw_head(Svg* svg) {
  svg->text({24, 28}, "How large the errors are", {18, kInk, Anchor::kStart, true});
  svg->text({24, 48},
            "Height: share of the values with an error in that octave, as its square root. 0 is "
            "apart; the first octave holds all smaller ones.",
            {12, kGrey});
  double x = 24;
  const auto entry = [&](const Paint& paint, const std::string& text) {
    if (paint.stroke == std::string("none")) {
      svg->rectangle({x, 61, 12, 12}, paint);
    } else {
      svg->line({x + 6, 58}, {x + 6, 76}, paint);
    }
    svg->text({x + 18, 71}, text, {12, kInk});
    x += 18 + text_width(text, 12) + 18;
  };
  entry({kDesignColor}, "design of Pineda");
  entry({kBaselineColor}, "textbook baseline");
  entry({"none", "#b3261e", 2}, "bound of the design");
  entry({"none", kInk, 1, "3 3"}, "½: what the final rounding alone makes");
}

}  // namespace

std::string histogram_svg(const ErrorStudy& study) {
  const double bottom = kHeadPx + kRowPx * static_cast<double>(study.subjects.size());
  Svg svg(kWidthPx, bottom + kFootPx, "Histograms of depth and colour errors");
  draw_head(&svg);
  const Panel depth(study, Quantity::kDepth, kNameRightPx + 12, 350);
  const Panel color(study, Quantity::kColor, kNameRightPx + 12 + 350 + 70, 230);
  depth.draw_frame(&svg, bottom);
  color.draw_frame(&svg, bottom);
  double base = kHeadPx;
  for (const Subject& s : study.subjects) {
    base += kRowPx;
    svg.text({kNameRightPx, base - 8}, s.name,
             {12, s.is_design ? kDesignColor : kBaselineColor, Anchor::kEnd, s.is_design});
    depth.draw_row(&svg, s, base);
    color.draw_row(&svg, s, base);
  }
  return svg.file();
}

}  // namespace pineda::studies
