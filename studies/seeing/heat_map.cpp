#include "studies/seeing/heat_map.h"

#include <algorithm>

namespace pineda::studies {

using timing::Cycle;

HeatMap::HeatMap(const spec::Contract& contract, const spec::FrameState& frame,
                 const Window& window)
    : window_(window),
      x_log2_(contract.design.tile_log2 - contract.design.stamp_width_log2),
      y_log2_(contract.design.tile_log2 - contract.design.stamp_height_log2),
      columns_(((frame.width - 1) >> contract.design.tile_log2) + 1),
      rows_(((frame.height - 1) >> contract.design.tile_log2) + 1),
      cycles_(static_cast<size_t>(columns_) * static_cast<size_t>(rows_)),
      last_(window.from) {}

void HeatMap::stamp(Cycle, const spec::Stamp& stamp) {
  tiles_.push_back(index(stamp.x >> x_log2_, stamp.y >> y_log2_));
  charge();
}

void HeatMap::slot(timing::Fifo fifo, Cycle, Cycle freed) {
  if (fifo != timing::Fifo::kStamps) return;
  accepted_.push_back(freed);
  charge();
}

void HeatMap::charge() {
  while (!tiles_.empty() && !accepted_.empty()) {
    const Cycle accepted = window_.clamped(accepted_.front());
    cycles_[tiles_.front()] += accepted - last_;
    total_ += accepted - last_;
    last_ = accepted;
    tiles_.pop_front();
    accepted_.pop_front();
  }
}

HeatMap::Tile HeatMap::hottest() const {
  const auto most = std::max_element(cycles_.begin(), cycles_.end());
  const auto at = static_cast<int>(most - cycles_.begin());
  return {at % columns_, at / columns_, *most};
}

int HeatMap::touched() const {
  return static_cast<int>(
      std::count_if(cycles_.begin(), cycles_.end(), [](Cycle cycles) { return cycles > 0; }));
}

}  // namespace pineda::studies
