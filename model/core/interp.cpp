#include "model/core/interp.h"

#include <algorithm>

#include "model/core/lanes.h"
#include "model/core/perspective.h"

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

// A plane's value at pixel (i, j) of its tile.
int64_t value(const Plane& p, int i, int j, int plane_bits) {
  return wrap(p.ref + i * p.dx + j * p.dy, plane_bits);
}

// Rounds to a code, the only rounding of a value, and clamps to [0, 2^out_bits - 1].
int64_t code(int64_t value, int fraction_bits, int out_bits) {
  const int64_t top = (int64_t{1} << out_bits) - 1;
  return std::clamp<int64_t>(round_half_up(value, fraction_bits), 0, top);
}

// Depth at pixel (i, j) of the tile, with its bias.
uint32_t depth_code(const Contract& c, const spec::PlaneSet& planes, int i, int j) {
  const int tile_f = c.design.tile_fraction_bits;
  const int f = std::max(tile_f, spec::kBiasFractionBits);
  const int64_t z = value(planes.z, i, j, c.width.depth_tile_plane);
  const int64_t sum = z * (int64_t{1} << (f - tile_f)) +
                      planes.z_bias * (int64_t{1} << (f - spec::kBiasFractionBits));
  return static_cast<uint32_t>(code(sum, f, c.design.depth_bits));
}

// Calls visit(lane, i, j) for each lane of `lanes`; i, j: px from the corner of the stamp's tile.
template <class Visitor>
void for_each_place(const Contract& c, const Stamp& stamp, uint32_t lanes, Visitor&& visit) {
  const spec::Design& d = c.design;
  const int tile_mask = (1 << d.tile_log2) - 1;
  const int x = (stamp.x << d.stamp_width_log2) & tile_mask;
  const int y = (stamp.y << d.stamp_height_log2) & tile_mask;
  for_each_lane(d, lanes, [&](size_t lane, int i, int j) { visit(lane, x + i, y + j); });
}

template <class Write>
void address(const Stamp& stamp, uint32_t mask, Write* write) {
  write->id = stamp.id;
  write->x = stamp.x;
  write->y = stamp.y;
  write->mask = mask;
}

}  // namespace

PassesWhen passes_when(DepthFunc func) {
  switch (func) {
    case DepthFunc::kLess:
      return {true, false, false};
    case DepthFunc::kLequal:
      return {true, true, false};
    case DepthFunc::kEqual:
      return {false, true, false};
    case DepthFunc::kGreater:
      return {false, false, true};
    case DepthFunc::kNotequal:
      return {true, false, true};
    case DepthFunc::kGequal:
      return {false, true, true};
    case DepthFunc::kOff:
    case DepthFunc::kAlways:
      return {true, true, true};
    case DepthFunc::kNever:
      break;
  }
  return {false, false, false};
}

void interpolate_depth(const Contract& c, const Stamp& stamp, Fragment* fragment) {
  const spec::Design& d = c.design;
  std::fill_n(fragment->z.begin(), c.width.lanes, 0);
  if (!d.depth_test) return;
  for_each_place(c, stamp, stamp.mask, [&](size_t lane, int i, int j) {
    fragment->z[lane] = depth_code(c, stamp.planes, i, j);
  });
}

uint32_t depth_floor(const Contract& c, const spec::PlaneSet& planes) {
  if (planes.z_steep) return 0;
  const int last = (1 << c.design.tile_log2) - 1;
  const uint32_t least =
      depth_code(c, planes, planes.z.dx < 0 ? last : 0, planes.z.dy < 0 ? last : 0);
  return least >> (c.design.depth_bits - c.design.hierarchical_z_bits);
}

uint32_t depth_ceiling(const Contract& c, const Fragment& fragment, uint32_t passed,
                       const std::array<uint32_t, kMaxLanes>& stored) {
  uint32_t greatest = 0;
  for (size_t lane = 0; lane < static_cast<size_t>(c.width.lanes); ++lane) {
    greatest = std::max(greatest, (passed >> lane & 1) != 0 ? fragment.z[lane] : stored[lane]);
  }
  return greatest >> (c.design.depth_bits - c.design.hierarchical_z_bits);
}

void interpolate_attributes(const Contract& c, const Stamp& stamp, uint32_t lanes,
                            Fragment* fragment) {
  const spec::Design& d = c.design;
  const auto attributes = static_cast<size_t>(d.attributes);
  for (size_t lane = 0; lane < static_cast<size_t>(c.width.lanes); ++lane) {
    if ((lanes >> lane & 1) == 0) std::fill_n(fragment->attr[lane].begin(), attributes, 0);
  }
  for_each_place(c, stamp, lanes, [&](size_t lane, int i, int j) {
    if (d.perspective) {
      perspective_attributes(c, stamp, i, j, &fragment->attr[lane]);
      return;
    }
    for (size_t a = 0; a < attributes; ++a) {
      const int64_t v = value(stamp.planes.attr[a], i, j, c.width.attr_tile_plane);
      fragment->attr[lane][a] =
          static_cast<int32_t>(code(v, d.tile_fraction_bits, d.attribute_bits));
    }
  });
}

bool tests_depth(const Contract& c, const spec::FrameState& frame) {
  return c.design.depth_test && frame.depth != DepthFunc::kOff;
}

uint32_t depth_test(const Contract& c, DepthFunc func, uint32_t mask,
                    const std::array<uint32_t, kMaxLanes>& z,
                    const std::array<uint32_t, kMaxLanes>& stored) {
  if (!c.design.depth_test || func == DepthFunc::kOff) return mask;
  const PassesWhen when = passes_when(func);
  uint32_t passed = 0;
  for (int lane = 0; lane < c.width.lanes; ++lane) {
    const auto l = static_cast<size_t>(lane);
    const bool pass = z[l] < stored[l] ? when.less : z[l] == stored[l] ? when.equal : when.greater;
    passed |= static_cast<uint32_t>(pass) << lane;
  }
  return passed & mask;
}

DepthWrite depth_write(const Contract& c, const Stamp& stamp, const Fragment& fragment,
                       uint32_t passed) {
  DepthWrite write;
  address(stamp, passed, &write);
  for_each_lane(c.design, passed, [&](size_t lane, int, int) { write.z[lane] = fragment.z[lane]; });
  return write;
}

ColorWrite color_write(const Contract& c, const Stamp& stamp, const Fragment& fragment,
                       uint32_t passed) {
  ColorWrite write;
  color_write(c, stamp, fragment, passed, &write);
  return write;
}

void color_write(const Contract& c, const Stamp& stamp, const Fragment& fragment, uint32_t passed,
                 ColorWrite* write) {
  address(stamp, passed, write);
  const auto attributes = static_cast<size_t>(c.design.attributes);
  for (size_t lane = 0; lane < static_cast<size_t>(c.width.lanes); ++lane) {
    auto& attr = write->attr[lane];
    if ((passed >> lane & 1) != 0) {
      std::copy_n(fragment.attr[lane].begin(), attributes, attr.begin());
    } else {
      std::fill_n(attr.begin(), attributes, 0);
    }
  }
  std::copy_n(stamp.planes.flat.begin(), c.design.flat_attributes, write->flat.begin());
}

}  // namespace pineda::core
