// Where on the screen a frame's time goes.
#pragma once

#include <array>
#include <deque>
#include <utility>
#include <vector>

#include "studies/seeing/spans.h"

namespace pineda::studies {

/// Cycles by tile of the screen.
///
/// A stamp costs the cycles from interp_ztest's acceptance of the stamp before it (for the first
/// stamp: from the window's first cycle) to its own acceptance. The cost is added to the stamp's
/// tile: whatever holds a stamp up anywhere in the pipeline is counted where the stamp is drawn,
/// and all tiles add up to the time until the last acceptance.
///
/// In       stamp(), and slot() of the stamp FIFO, interleaved in any order.
class HeatMap final : public timing::Listener {
 public:
  HeatMap(const spec::Contract& contract, const spec::FrameState& frame, const Window& window);

  void stamp(timing::Cycle cycle, const spec::Stamp& stamp) override;
  void slot(timing::Fifo fifo, timing::Cycle inserted, timing::Cycle freed) override;

  struct Tile {
    int x = 0;
    int y = 0;
    timing::Cycle cycles = 0;
  };

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  timing::Cycle cycles(int x, int y) const { return cycles_[index(x, y)]; }
  timing::Cycle total() const { return total_; }
  /// The tile with the highest cost; the first of several equal ones.
  Tile hottest() const;
  /// Number of tiles with any cost.
  int touched() const;

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(columns_) + static_cast<size_t>(x);
  }
  void charge();

  Window window_;
  int x_log2_;  // stamps of a tile
  int y_log2_;
  int columns_;
  int rows_;
  std::vector<timing::Cycle> cycles_;
  timing::Cycle total_ = 0;
  timing::Cycle last_;                  // the last acceptance, or the window's begin
  std::deque<size_t> tiles_;            // tiles of stamps whose acceptance is not known yet
  std::deque<timing::Cycle> accepted_;  // acceptances whose stamps are not known yet
};

/// A picture, row-major, 8-bit red, green and blue.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;
};

/// The map over the frame's pixels (small frames magnified), each tile in the colour of its cycles;
/// black where no stamp was. The scale below it follows the square root of the cycles, so that a
/// few hot tiles do not hide the others.
Picture heat_map_picture(const HeatMap& map, const spec::Contract& contract,
                         const spec::FrameState& frame);

}  // namespace pineda::studies
