#include "studies/judge/truth.h"

#include <initializer_list>

#include "model/spec/clear_depth.h"

namespace pineda::studies {

exact::Format format_of(const spec::Design& d) {
  return {d.subpixel_bits, d.guard_bits, d.depth_bits, spec::channels(d), d.attribute_bits};
}

exact::Frame exact_frame(const spec::FrameState& frame) {
  static constexpr exact::Cull kCull[] = {exact::Cull::kNone, exact::Cull::kBack,
                                          exact::Cull::kFront};
  exact::Frame exact{frame.width, frame.height, kCull[static_cast<int>(frame.cull)]};
  exact.x0 = frame.scissor_x0;
  exact.y0 = frame.scissor_y0;
  exact.x1 = frame.scissor_x1;
  exact.y1 = frame.scissor_y1;
  exact.flat = frame.shade == spec::Shade::kFlat;
  exact.bias_constant = frame.bias_constant;
  exact.bias_slope = frame.bias_slope;
  return exact;
}

void Truth::judge(const exact::ScreenJudge& judge, exact::Span rows) {
  rows_ = rows;
  row_.clear();
  samples_.clear();
  affine_ = judge.affine();
  depth_slope_ = judge.depth_slope();
  const std::vector<int>& first = judge.snapped().vertices()[0].attr;
  std::copy_n(first.begin(), std::min(first.size(), flat_.size()), flat_.begin());
  for (int y = rows_.first; y <= rows_.last; ++y) {
    row_.push_back({judge.span(y), samples_.size()});
    judge.row(y, !affine_, &samples_);
  }
}

int64_t Truth::find(int x, int y) const {
  if (y < rows_.first || y > rows_.last) return -1;
  const Row& row = row_[static_cast<size_t>(y - rows_.first)];
  if (x < row.span.first || x > row.span.last) return -1;
  return static_cast<int64_t>(row.first) + (x - row.span.first);
}

VisibleFrame::VisibleFrame(const spec::Design& design, const spec::FrameState& frame)
    : frame_(frame), clear_code_(spec::depth_code(frame.clear_depth, design.depth_bits)) {
  using spec::DepthFunc;
  const DepthFunc func = design.depth_test ? frame.depth : DepthFunc::kOff;
  const auto is = [func](std::initializer_list<DepthFunc> list) {
    return std::find(list.begin(), list.end(), func) != list.end();
  };
  const bool all = is({DepthFunc::kOff, DepthFunc::kAlways});
  less_passes_ = all || is({DepthFunc::kLess, DepthFunc::kLequal, DepthFunc::kNotequal});
  equal_passes_ = all || is({DepthFunc::kEqual, DepthFunc::kLequal, DepthFunc::kGequal});
  greater_passes_ = all || is({DepthFunc::kGreater, DepthFunc::kGequal, DepthFunc::kNotequal});
  clear();
}

void VisibleFrame::clear() {
  const size_t pixels = static_cast<size_t>(frame_.width) * static_cast<size_t>(frame_.height);
  z_.assign(pixels, clear_code_);
  rgba_.assign(pixels, {});
  drawn_.assign(pixels, 0);
}

}  // namespace pineda::studies
