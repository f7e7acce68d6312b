#include "model/core/frame_buffer.h"

#include <algorithm>
#include <cstddef>

namespace pineda::core {

using spec::Contract;

FrameBuffer::FrameBuffer(const Contract& c, const spec::FrameState& frame)
    : width(frame.width),
      height(frame.height),
      channels(spec::channels(c.design)),
      clear_depth(spec::cleared_depth(c.design, frame)) {
  clear();
}

void FrameBuffer::clear() {
  const size_t samples = index(0, height);
  depth.assign(samples, clear_depth);
  color.assign(samples * static_cast<size_t>(channels), 0);
  hits.assign(samples, 0);
}

spec::DepthData FrameBuffer::read(const Contract& c, int x, int y, uint32_t mask) const {
  spec::DepthData data;
  for_each_lane(c, x, y, mask, [&](size_t lane, size_t sample) { data.z[lane] = depth[sample]; });
  return data;
}

void FrameBuffer::write(const Contract& c, const spec::DepthWrite& w) {
  for_each_lane(c, w.x, w.y, w.mask,
                [&](size_t lane, size_t sample) { depth[sample] = w.z[lane]; });
}

void FrameBuffer::write(const Contract& c, const spec::ColorWrite& w) {
  const auto n = static_cast<size_t>(channels);
  for_each_lane(c, w.x, w.y, w.mask, [&](size_t lane, size_t sample) {
    const auto to = color.begin() + static_cast<std::ptrdiff_t>(sample * n);
    const auto flat = std::copy_n(w.attr[lane].begin(), c.design.attributes, to);
    std::copy_n(w.flat.begin(), c.design.flat_attributes, flat);
  });
}

void FrameBuffer::count_hits(const Contract& c, const spec::Stamp& stamp) {
  for_each_lane(c, stamp.x, stamp.y, stamp.mask, [&](size_t, size_t sample) {
    if (hits[sample] != UINT16_MAX) ++hits[sample];
  });
}

}  // namespace pineda::core
