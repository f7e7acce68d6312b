#include "model/judge/exact_terms.h"

namespace pineda::judge {

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

exact::Judge exact_judge(const spec::Design& design, const spec::FrameState& frame,
                         const spec::Triangle& triangle) {
  exact::Triangle exact;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& v = triangle.v[i];
    const auto& attr = (frame.shade == spec::Shade::kFlat ? triangle.v[0] : v).attr;
    exact[i] = {v.x, v.y, v.z, {attr.begin(), attr.begin() + design.attributes}};
  }
  return {exact, design.subpixel_bits, exact_frame(frame)};
}

}  // namespace pineda::judge
