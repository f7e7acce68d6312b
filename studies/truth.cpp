#include "studies/truth.h"

namespace pineda::studies {

exact::Format format_of(const spec::Design& d) {
  return {d.subpixel_bits, d.guard_bits, d.depth_bits, d.attributes, d.attribute_bits};
}

exact::Frame exact_frame(const spec::FrameState& frame) {
  static constexpr exact::Cull kCull[] = {exact::Cull::kNone, exact::Cull::kBack,
                                          exact::Cull::kFront};
  return {frame.width, frame.height, kCull[static_cast<int>(frame.cull)]};
}

void Truth::judge(const exact::ScreenJudge& judge) {
  rows_ = judge.rows();
  row_.clear();
  samples_.clear();
  for (int y = rows_.first; y <= rows_.last; ++y) {
    row_.push_back({judge.span(y), samples_.size()});
    judge.row(y, !judge.affine(), &samples_);
  }
}

int64_t Truth::find(int x, int y) const {
  if (y < rows_.first || y > rows_.last) return -1;
  const Row& row = row_[static_cast<size_t>(y - rows_.first)];
  if (x < row.span.first || x > row.span.last) return -1;
  return static_cast<int64_t>(row.first) + (x - row.span.first);
}

VisibleFrame::VisibleFrame(const spec::Design& design, const spec::FrameState& frame)
    : frame_(frame), clear_code_(static_cast<uint32_t>((uint64_t{1} << design.depth_bits) - 1)) {
  clear();
}

void VisibleFrame::clear() {
  const size_t pixels = static_cast<size_t>(frame_.width) * static_cast<size_t>(frame_.height);
  z_.assign(pixels, clear_code_);
  rgba_.assign(pixels, {});
  drawn_.assign(pixels, 0);
}

}  // namespace pineda::studies
