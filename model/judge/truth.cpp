#include "model/judge/truth.h"

#include <algorithm>
#include <cmath>

namespace pineda::judge {
namespace {

/// Halves round up, so the error of the nearest code lies in (-1/2, 1/2].
Error error_of(double units) { return {units, !(units > -.5 && units <= .5)}; }

}  // namespace

void ScreenTruth::judge(const exact::ScreenJudge& judge, exact::Span rows) {
  rows_ = rows;
  row_.clear();
  samples_.clear();
  affine_ = judge.affine() || !with_perspective_;
  depth_slope_ = judge.depth_slope();
  const std::vector<int>& first = judge.snapped().vertices()[0].attr;
  std::copy_n(first.begin(), std::min(first.size(), flat_.size()), flat_.begin());
  for (int y = rows_.first; y <= rows_.last; ++y) {
    row_.push_back({judge.span(y), samples_.size()});
    judge.row(y, !affine_, &samples_);
  }
}

const exact::Sample* ScreenTruth::find(int x, int y) const {
  if (y < rows_.first || y > rows_.last) return nullptr;
  const auto& [span, first] = row(y);
  if (x < span.first || x > span.last) return nullptr;
  return &samples_[first + static_cast<size_t>(x - span.first)];
}

exact::Value ScreenTruth::attribute(const exact::Sample& sample, size_t i, bool perspective) const {
  if (i >= sample.affine.size()) return {};  // attributes after r, g, b, a are 0
  return perspective && !affine_ ? sample.perspective[i] : sample.affine[i];
}

Errors ScreenTruth::errors(const Values& values, const Drawn& drawn) const {
  const exact::Sample& sample = *find(drawn.x, drawn.y);
  const auto against = [](const exact::Value& value, int64_t code) {
    return Error{value.error_of(code), code != value.nearest};
  };
  Errors errors;
  if (values.depth) errors.depth = against(sample.z, drawn.z);
  for (size_t i = 0; i < static_cast<size_t>(values.channels); ++i) {
    errors.attr[i] = i < static_cast<size_t>(values.smooth)
                         ? against(attribute(sample, i, values.perspective), drawn.attr[i])
                         : error_of(drawn.attr[i] - flat_[i]);
  }
  return errors;
}

Errors SnappedTruth::errors(const Values& values, const Drawn& drawn) const {
  Errors errors;
  if (values.depth) errors.depth = error_of(depth_error(drawn));
  for (size_t i = 0; i < static_cast<size_t>(values.channels); ++i) {
    const auto a = static_cast<int>(i);
    errors.attr[i] =
        error_of(a >= values.smooth   ? drawn.attr[i] - triangle_.v[0].attr[i]
                 : values.perspective ? perspective_error(drawn, i)
                                      : judge_.attribute_error(drawn.x, drawn.y, a, drawn.attr[i]));
  }
  return errors;
}

double SnappedTruth::depth_error(const Drawn& drawn) const {
  const double error = judge_.depth_error(drawn.x, drawn.y, drawn.z) - bias_codes_;
  const bool is_clamped = bias_codes_ > 0   ? drawn.z == top_code_ && error < 0
                          : bias_codes_ < 0 ? drawn.z == 0 && error > 0
                                            : false;
  return is_clamped ? 0 : error;
}

double SnappedTruth::perspective_error(const Drawn& drawn, size_t attribute) const {
  const auto weights = judge_.weights(drawn.x, drawn.y);
  long double sum = 0;
  long double total = 0;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& v = triangle_.v[i];
    const long double weight =
        std::ldexp(static_cast<long double>(weights[i]) * v.inverse_w, -v.inverse_w_shift);
    total += weight;
    sum += weight * judge_.vertices()[i].attr[attribute];
  }
  return static_cast<double>(static_cast<long double>(drawn.attr[attribute]) - sum / total);
}

}  // namespace pineda::judge
