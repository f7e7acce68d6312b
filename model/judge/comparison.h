// The one comparison: drawn samples with the exact ones, value by value with the bounds that apply.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/judge/truth.h"
#include "model/spec/bounds.h"

namespace pineda::judge {

/// What a sample turns out to be: one of the triangle's, none of its, or one that was drawn before.
enum class Found { kRight, kExtra, kTwice };

/// Which samples of a triangle have been drawn.
///
/// In       memory: a byte a sample of the triangle.
class Seen {
 public:
  void begin(const Truth& truth);
  Found draw(int x, int y);
  /// Calls visit(x, y) for each sample that was not drawn, row by row.
  template <class Visit>
  void for_each_missing(Visit&& visit) const;

 private:
  struct Row {
    exact::Span span;
    size_t first;  // index of its first sample
  };
  int first_row_ = 0;
  std::vector<Row> row_;
  std::vector<uint8_t> seen_;
};

/// Where something differs first.
struct Difference {
  int x = 0, y = 0;       // px
  uint32_t triangle = 0;  // its number
  std::string what;
};

/// Drawn samples before exact arithmetic.
struct Verdict {
  uint64_t samples = 0;      // drawn
  uint64_t missing = 0;      // exact covers, they do not
  uint64_t extra = 0;        // they cover, exact does not; a second time counts too
  uint64_t beyond = 0;       // right ones with a value beyond the bounds
  double max_depth_ulp = 0;  // of right ones
  double max_color_lsb = 0;
  std::optional<Difference> first;  // in the order in which they come, missing ones last

  bool holds() const { return missing == 0 && extra == 0 && beyond == 0; }
};

/// The bounds of one triangle's depths and interpolated attributes: the design's, that of depth
/// with what a bias adds to it; a flat attribute must be right. `depth_slope` as ScreenTruth has
/// it.
spec::ErrorBounds triangle_bounds(const spec::Design& design, const spec::FrameState& frame,
                                  double depth_slope);

/// A value of a sample: depth, or the attribute of this number.
inline constexpr int kDepth = -1;
/// The first value beyond its bounds; nothing if all keep them.
std::optional<int> first_beyond(const Values& values, const spec::ErrorBounds& bounds,
                                const Errors& errors);
/// "depth at (3, 4) is -0.7 codes off"
std::string text_of(int value, const Errors& errors, const Drawn& drawn);

/// Compares one triangle after another and adds what it finds to a verdict.
class Comparison {
 public:
  Comparison(const Values& values, Verdict* to) : values_(values), to_(*to) {}

  /// `truth` is looked at until end().
  void begin(const Truth& truth, const spec::ErrorBounds& bounds, uint32_t triangle);
  Found sample(const Drawn& drawn);
  void end();

 private:
  void add(const Errors& errors, const Drawn& drawn);
  template <class Text>
  void note(int x, int y, Text&& text);

  Values values_;
  Verdict& to_;
  const Truth* truth_ = nullptr;
  spec::ErrorBounds bounds_{};
  uint32_t triangle_ = 0;
  Seen seen_;
};

/// The same for samples that come by rows of tiles, from the floats of a scene on: in memory for
/// the exact samples of one row of tiles. A sample of a row of tiles that has gone by is one too
/// many.
class TileRowComparison {
 public:
  TileRowComparison(const Values& values, int tile_log2, Verdict* to)
      : tile_log2_(tile_log2), truth_(values.perspective), comparison_(values, to) {}

  /// `judge` is looked at until end().
  void begin(const exact::ScreenJudge& judge, const spec::ErrorBounds& bounds, uint32_t triangle);
  void sample(const Drawn& drawn);
  void end();

 private:
  void next_tile_row();

  int tile_log2_;
  ScreenTruth truth_;
  Comparison comparison_;
  const exact::ScreenJudge* judge_ = nullptr;
  spec::ErrorBounds bounds_{};
  uint32_t triangle_ = 0;
  exact::Span rows_;  // the triangle's that are judged, or gone by
};

template <class Visit>
void Seen::for_each_missing(Visit&& visit) const {
  for (size_t i = 0; i < row_.size(); ++i) {
    const auto& [span, first] = row_[i];
    for (int x = span.first; x <= span.last; ++x) {
      if (seen_[first + static_cast<size_t>(x - span.first)] != 0) continue;
      visit(x, first_row_ + static_cast<int>(i));
    }
  }
}

}  // namespace pineda::judge
