#include "model/core/frame.h"

#include <algorithm>
#include <cstddef>

namespace pineda::core {

using spec::Contract;

namespace {

struct NoSink {
  void prim(const spec::SetupPrim&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp&, const spec::Fragment&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
};

}  // namespace

FrameBuffer::FrameBuffer(const Contract& c, const spec::FrameState& frame)
    : width(frame.width), height(frame.height), attributes(c.design.attributes) {
  clear(c);
}

void FrameBuffer::clear(const Contract& c) {
  const size_t samples = static_cast<size_t>(width) * static_cast<size_t>(height);
  depth.assign(samples, static_cast<uint32_t>((uint64_t{1} << c.design.depth_bits) - 1));
  color.assign(samples * static_cast<size_t>(attributes), 0);
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
  const auto n = static_cast<size_t>(attributes);
  for_each_lane(c, w.x, w.y, w.mask, [&](size_t lane, size_t sample) {
    std::copy_n(w.attr[lane].begin(), n, color.begin() + static_cast<std::ptrdiff_t>(sample * n));
  });
}

void FrameBuffer::count_hits(const Contract& c, const spec::Stamp& stamp) {
  for_each_lane(c, stamp.x, stamp.y, stamp.mask, [&](size_t, size_t sample) {
    if (hits[sample] != UINT16_MAX) ++hits[sample];
  });
}

Drop Renderer::draw(const spec::Triangle& triangle) { return draw(triangle, NoSink{}); }

}  // namespace pineda::core
