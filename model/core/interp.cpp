#include "model/core/interp.h"

#include <algorithm>

namespace pineda::core {

using spec::ColorWrite;
using spec::Contract;
using spec::DepthFunc;
using spec::DepthWrite;
using spec::Fragment;
using spec::kMaxLanes;
using spec::Plane;
using spec::round_half_up;
using spec::Stamp;
using spec::wrap;

namespace {

// A plane's value at pixel (i, j) of its tile, rounded and clamped to [0, 2^out_bits - 1].
int64_t value(const Plane& p, int i, int j, int plane_bits, int fraction_bits, int out_bits) {
  const int64_t wrapped = wrap(p.ref + i * p.dx + j * p.dy, plane_bits);
  const int64_t top = (int64_t{1} << out_bits) - 1;
  return std::clamp<int64_t>(round_half_up(wrapped, fraction_bits), 0, top);
}

template <class Write>
Write addressed(const Stamp& stamp, uint32_t mask) {
  Write write;
  write.id = stamp.id;
  write.x = stamp.x;
  write.y = stamp.y;
  write.mask = mask;
  return write;
}

}  // namespace

void interpolate(const Contract& c, const Stamp& stamp, Fragment* fragment) {
  const spec::Design& d = c.design;
  const int tile_mask = (1 << d.tile_log2) - 1;
  const int x = (stamp.x << d.stamp_width_log2) & tile_mask;
  const int y = (stamp.y << d.stamp_height_log2) & tile_mask;
  const auto attributes = static_cast<size_t>(d.attributes);
  for (int lane = 0; lane < c.width.lanes; ++lane) {
    const auto l = static_cast<size_t>(lane);
    if ((stamp.mask >> lane & 1) == 0) {
      fragment->z[l] = 0;
      std::fill_n(fragment->attr[l].begin(), attributes, 0);
      continue;
    }
    const int i = x + (lane & ((1 << d.stamp_width_log2) - 1));
    const int j = y + (lane >> d.stamp_width_log2);
    fragment->z[l] = static_cast<uint32_t>(
        value(stamp.planes.z, i, j, c.width.depth_tile_plane, d.tile_fraction_bits, d.depth_bits));
    for (size_t a = 0; a < attributes; ++a) {
      fragment->attr[l][a] =
          static_cast<int32_t>(value(stamp.planes.attr[a], i, j, c.width.attr_tile_plane,
                                     d.tile_fraction_bits, d.attribute_bits));
    }
  }
}

uint32_t depth_test(const Contract& c, DepthFunc func, uint32_t mask,
                    const std::array<uint32_t, kMaxLanes>& z,
                    const std::array<uint32_t, kMaxLanes>& stored) {
  if (func == DepthFunc::kOff) return mask;
  uint32_t passed = 0;
  for (int lane = 0; lane < c.width.lanes; ++lane) {
    const auto l = static_cast<size_t>(lane);
    const bool pass = z[l] < stored[l] || (func == DepthFunc::kLequal && z[l] == stored[l]);
    passed |= static_cast<uint32_t>(pass) << lane;
  }
  return passed & mask;
}

DepthWrite depth_write(const Contract& c, const Stamp& stamp, const Fragment& fragment,
                       uint32_t passed) {
  auto write = addressed<DepthWrite>(stamp, passed);
  for (int lane = 0; lane < c.width.lanes; ++lane) {
    const auto l = static_cast<size_t>(lane);
    if ((passed >> lane & 1) != 0) write.z[l] = fragment.z[l];
  }
  return write;
}

ColorWrite color_write(const Contract& c, const Stamp& stamp, const Fragment& fragment,
                       uint32_t passed) {
  auto write = addressed<ColorWrite>(stamp, passed);
  for (int lane = 0; lane < c.width.lanes; ++lane) {
    const auto l = static_cast<size_t>(lane);
    if ((passed >> lane & 1) != 0) write.attr[l] = fragment.attr[l];
  }
  return write;
}

}  // namespace pineda::core
