#include "model/timing/units/hierarchical_z.h"

#include <algorithm>
#include <cstddef>

#include "model/spec/clear_depth.h"

namespace pineda::timing {
namespace {

// Stamps of a tile, log2.
int stamps_log2(const spec::Design& d) {
  return 2 * d.tile_log2 - d.stamp_width_log2 - d.stamp_height_log2;
}

}  // namespace

void HierarchicalZ::begin_frame(const spec::FrameState& frame) {
  const spec::Design& d = contract_.design;
  pending_.clear();
  active_ = d.hierarchical_z &&
            (frame.depth == spec::DepthFunc::kLess || frame.depth == spec::DepthFunc::kLequal);
  if (!active_) return;
  columns_ = ((frame.width - 1) >> d.tile_log2) + 1;
  const int rows = ((frame.height - 1) >> d.tile_log2) + 1;
  const size_t tiles = std::min(index(0, rows), static_cast<size_t>(d.hierarchical_z_tiles));
  greatest_.assign(tiles << stamps_log2(d), 0);
  // What lies outside the frame hides nothing.
  const uint32_t cleared = spec::cleared_depth(d, frame) >> (d.depth_bits - d.hierarchical_z_bits);
  for (int y = 0; y <= (frame.height - 1) >> d.stamp_height_log2; ++y) {
    for (int x = 0; x <= (frame.width - 1) >> d.stamp_width_log2; ++x) apply({x, y, cleared});
  }
}

void HierarchicalZ::update(Cycle accepted, const spec::DepthMax& depth) {
  if (!active_) return;
  pending_.push_back({accepted + contract_.design.hierarchical_z_delay_cycles, depth});
}

void HierarchicalZ::apply(const spec::DepthMax& depth) {
  const spec::Design& d = contract_.design;
  const int x_log2 = d.tile_log2 - d.stamp_width_log2;
  const int y_log2 = d.tile_log2 - d.stamp_height_log2;
  const size_t stamp = static_cast<size_t>(depth.y & ((1 << y_log2) - 1)) << x_log2 |
                       static_cast<size_t>(depth.x & ((1 << x_log2) - 1));
  const size_t at = (index(depth.x >> x_log2, depth.y >> y_log2) << stamps_log2(d)) + stamp;
  if (at < greatest_.size()) greatest_[at] = static_cast<uint16_t>(depth.z);
}

bool HierarchicalZ::hides(Cycle cycle, int tile_x, int tile_y, uint32_t floor) {
  if (!active_) return false;
  catch_up_(cycle);
  for (; !pending_.empty() && pending_.front().visible <= cycle; pending_.pop_front()) {
    apply(pending_.front().depth);
  }
  const size_t stamps = size_t{1} << stamps_log2(contract_.design);
  const size_t at = index(tile_x, tile_y) * stamps;
  if (at >= greatest_.size()) return false;
  const auto first = greatest_.begin() + static_cast<std::ptrdiff_t>(at);
  return floor > *std::max_element(first, first + static_cast<std::ptrdiff_t>(stamps));
}

}  // namespace pineda::timing
