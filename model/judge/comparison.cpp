#include "model/judge/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pineda::judge {

void Seen::begin(const Truth& truth) {
  const exact::Span rows = truth.rows();
  first_row_ = rows.first;
  row_.clear();
  size_t samples = 0;
  for (int y = rows.first; y <= rows.last; ++y) {
    const exact::Span span = truth.span(y);
    row_.push_back({span, samples});
    samples += static_cast<size_t>(std::max(0, span.last - span.first + 1));
  }
  seen_.assign(samples, 0);
}

Found Seen::draw(int x, int y) {
  if (y < first_row_ || y - first_row_ >= static_cast<int>(row_.size())) return Found::kExtra;
  const auto& [span, first] = row_[static_cast<size_t>(y - first_row_)];
  if (x < span.first || x > span.last) return Found::kExtra;
  uint8_t& seen = seen_[first + static_cast<size_t>(x - span.first)];
  const Found found = seen == 0 ? Found::kRight : Found::kTwice;
  seen = 1;
  return found;
}

spec::ErrorBounds triangle_bounds(const spec::Design& design, const spec::FrameState& frame,
                                  double depth_slope) {
  const double slope = std::ldexp(frame.bias_slope, -spec::kBiasFactorFractionBits);
  spec::ErrorBounds bounds = spec::error_bounds(design);
  bounds.depth_ulp += spec::depth_bias_error_bound(design, slope, depth_slope);
  if (frame.shade == spec::Shade::kFlat) bounds.attribute_lsb = 0;
  return bounds;
}

std::optional<int> first_beyond(const Values& values, const spec::ErrorBounds& bounds,
                                const Errors& errors) {
  if (std::abs(errors.depth.units) > bounds.depth_ulp) return kDepth;
  for (int i = 0; i < values.channels; ++i) {
    const double bound = i < values.smooth ? bounds.attribute_lsb : 0;
    if (std::abs(errors.attr[static_cast<size_t>(i)].units) > bound) return i;
  }
  return std::nullopt;
}

std::string text_of(int value, const Errors& errors, const Drawn& drawn) {
  if (value == kDepth) {
    return fmt::format("depth at ({}, {}) is {} codes off", drawn.x, drawn.y, errors.depth.units);
  }
  return fmt::format("attribute {} at ({}, {}) is {} LSB off", value, drawn.x, drawn.y,
                     errors.attr[static_cast<size_t>(value)].units);
}

void Comparison::begin(const Truth& truth, const spec::ErrorBounds& bounds, uint32_t triangle) {
  truth_ = &truth;
  bounds_ = bounds;
  triangle_ = triangle;
  seen_.begin(truth);
}

template <class Text>
void Comparison::note(int x, int y, Text&& text) {
  if (!to_.first) to_.first = {x, y, triangle_, text()};
}

Found Comparison::sample(const Drawn& drawn) {
  ++to_.samples;
  const Found found = seen_.draw(drawn.x, drawn.y);
  if (found == Found::kRight) {
    add(truth_->errors(values_, drawn), drawn);
    return found;
  }
  ++to_.extra;
  note(drawn.x, drawn.y, [&] {
    return fmt::format("sample ({}, {}) is {}", drawn.x, drawn.y,
                       found == Found::kTwice ? "drawn twice" : "not covered");
  });
  return found;
}

void Comparison::end() {
  seen_.for_each_missing([this](int x, int y) {
    ++to_.missing;
    note(x, y, [&] { return fmt::format("sample ({}, {}) is missing", x, y); });
  });
}

void Comparison::add(const Errors& errors, const Drawn& drawn) {
  to_.max_depth_ulp = std::max(to_.max_depth_ulp, std::abs(errors.depth.units));
  for (size_t i = 0; i < static_cast<size_t>(values_.channels); ++i) {
    to_.max_color_lsb = std::max(to_.max_color_lsb, std::abs(errors.attr[i].units));
  }
  const auto beyond = first_beyond(values_, bounds_, errors);
  if (!beyond) return;
  ++to_.beyond;
  note(drawn.x, drawn.y, [&] { return text_of(*beyond, errors, drawn); });
}

void TileRowComparison::begin(const exact::ScreenJudge& judge, const spec::ErrorBounds& bounds,
                              uint32_t triangle) {
  judge_ = &judge;
  bounds_ = bounds;
  triangle_ = triangle;
  const int first = judge.rows().first;
  rows_ = {first, first - 1};
  truth_.judge(judge, rows_);
  comparison_.begin(truth_, bounds_, triangle_);
}

void TileRowComparison::sample(const Drawn& drawn) {
  while (drawn.y > rows_.last && rows_.last < judge_->rows().last) next_tile_row();
  comparison_.sample(drawn);
}

void TileRowComparison::end() {
  while (rows_.last < judge_->rows().last) next_tile_row();
  comparison_.end();
}

void TileRowComparison::next_tile_row() {
  comparison_.end();
  const int first = rows_.last + 1;
  rows_ = {first, std::min(judge_->rows().last, first | ((1 << tile_log2_) - 1))};
  truth_.judge(*judge_, rows_);
  comparison_.begin(truth_, bounds_, triangle_);
}

}  // namespace pineda::judge
