// Compares drawn samples with the exact ones: coverage, and each value against its error bound.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/judge/truth.h"
#include "model/spec/bounds.h"

namespace pineda::judge {

/// Whether a drawn sample is right: covered by the triangle, not covered, or drawn a second time.
enum class Found { kRight, kExtra, kTwice };

/// Which samples of a triangle have been drawn.
///
/// In       memory: one byte for each sample of the triangle.
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

/// The first place where something differs.
struct Difference {
  int x = 0, y = 0;       // px
  uint32_t triangle = 0;  // its number
  std::string what;
};

/// The result of comparing drawn samples with the exact ones.
struct Verdict {
  uint64_t samples = 0;      // drawn
  uint64_t missing = 0;      // covered but not drawn
  uint64_t extra = 0;        // drawn but not covered, or drawn a second time
  uint64_t beyond = 0;       // covered and drawn, with a value beyond its bound
  double max_depth_ulp = 0;  // greatest error of samples covered and drawn
  double max_color_lsb = 0;
  std::optional<Difference> first;  // in drawing order, missing samples after all others

  bool holds() const { return missing == 0 && extra == 0 && beyond == 0; }
};

/// The error bounds of one triangle's depths and interpolated attributes: those of the design, plus
/// what a depth bias adds to that of depth. With flat shading attributes must be exact.
/// `depth_slope`: see ScreenTruth::depth_slope().
spec::ErrorBounds triangle_bounds(const spec::Design& design, const spec::FrameState& frame,
                                  double depth_slope);

/// The number of depth among a sample's values; attributes have the numbers from 0 on.
inline constexpr int kDepth = -1;
/// The number of the first value beyond its bound; nothing if there is none.
std::optional<int> first_beyond(const Values& values, const spec::ErrorBounds& bounds,
                                const Errors& errors);
/// "depth at (3, 4) is -0.7 codes off"
std::string text_of(int value, const Errors& errors, const Drawn& drawn);

/// Compares one triangle after another and adds the results to a verdict.
class Comparison {
 public:
  Comparison(const Values& values, Verdict* to) : values_(values), to_(*to) {}

  /// `truth` must live until end().
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

/// The same against a ScreenJudge, for samples that come by rows of tiles: it holds the exact
/// samples of one row of tiles only. A sample of a row of tiles that is already done counts as
/// extra.
class TileRowComparison {
 public:
  TileRowComparison(const Values& values, int tile_log2, Verdict* to)
      : tile_log2_(tile_log2), truth_(values.perspective), comparison_(values, to) {}

  /// `judge` must live until end().
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
  exact::Span rows_;  // rows of the current row of tiles
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
