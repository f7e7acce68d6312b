#include "model/core/frame_buffer.h"

#include <algorithm>
#include <cstddef>

#include "model/core/tiled_buffer.h"

namespace pineda::core {

using spec::Contract;

template <class Order>
SampleMemories<Order>::SampleMemories(const Contract& c, const spec::FrameState& frame)
    : Order(c.design, frame),
      channels(spec::channels(c.design)),
      clear_depth(spec::cleared_depth(c.design, frame)) {
  clear();
}

template <class Order>
void SampleMemories<Order>::clear() {
  const size_t samples = this->samples();
  depth.assign(samples, clear_depth);
  color.assign(samples * static_cast<size_t>(channels), 0);
  hits.assign(samples, 0);
}

template <class Order>
spec::DepthData SampleMemories<Order>::read(const Contract& c, int x, int y, uint32_t mask) const {
  spec::DepthData data;
  for_each_lane(c, x, y, mask, [&](size_t lane, size_t sample) { data.z[lane] = depth[sample]; });
  return data;
}

template <class Order>
void SampleMemories<Order>::write(const Contract& c, const spec::DepthWrite& w) {
  for_each_lane(c, w.x, w.y, w.mask,
                [&](size_t lane, size_t sample) { depth[sample] = w.z[lane]; });
}

template <class Order>
void SampleMemories<Order>::write(const Contract& c, const spec::ColorWrite& w) {
  const size_t attributes = static_cast<size_t>(c.design.attributes);
  const auto n = static_cast<size_t>(channels);
  for_each_lane(c, w.x, w.y, w.mask, [&](size_t lane, size_t sample) {
    const auto to = color.begin() + static_cast<std::ptrdiff_t>(sample * n);
    const auto flat = std::copy_n(w.attr[lane].begin(), attributes, to);
    std::copy_n(w.flat.begin(), n - attributes, flat);
  });
}

template <class Order>
void SampleMemories<Order>::count_hits(const Contract& c, const spec::Stamp& stamp) {
  for_each_lane(c, stamp.x, stamp.y, stamp.mask, [&](size_t, size_t sample) {
    if (hits[sample] != UINT16_MAX) ++hits[sample];
  });
}

template struct SampleMemories<RowMajor>;
template struct SampleMemories<Tiled>;

}  // namespace pineda::core
