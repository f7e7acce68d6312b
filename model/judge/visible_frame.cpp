#include "model/judge/visible_frame.h"

#include "model/spec/clear_depth.h"

namespace pineda::judge {

bool passes(spec::DepthFunc func, int order) {
  // Bit 0 less, bit 1 equal, bit 2 greater, in the order of DepthFunc.
  static constexpr unsigned kPasses[] = {1, 3, 7, 0, 2, 4, 5, 6, 7};
  return (kPasses[static_cast<size_t>(func)] >> (order + 1) & 1) != 0;
}

VisibleFrame::VisibleFrame(const spec::Design& design, const spec::FrameState& frame)
    : frame_(frame), clear_code_(spec::depth_code(frame.clear_depth, design.depth_bits)) {
  const auto func = design.depth_test ? frame.depth : spec::DepthFunc::kOff;
  less_passes_ = judge::passes(func, -1);
  equal_passes_ = judge::passes(func, 0);
  greater_passes_ = judge::passes(func, 1);
  clear();
}

void VisibleFrame::clear() {
  const size_t pixels = static_cast<size_t>(frame_.width) * static_cast<size_t>(frame_.height);
  z_.assign(pixels, clear_code_);
  rgba_.assign(pixels, {});
  drawn_.assign(pixels, 0);
}

}  // namespace pineda::judge
