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
/// A stamp costs the cycles from the acceptance by interp_ztest of the stamp before it (from the
/// window's first cycle on for the first) until its own, and its tile pays. So what holds a stamp
/// up anywhere in the pipeline is paid where it is drawn, and all tiles together pay for the time
/// up to the last acceptance.
///
/// In       stamp() and slot() of the stamps' FIFO, in any order between the two.
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
  /// The tile that costs most, the first of them.
  Tile hottest() const;
  /// Tiles that cost anything.
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
  std::deque<size_t> tiles_;            // of stamps whose acceptance is not known yet
  std::deque<timing::Cycle> accepted_;  // of stamps that are not known yet
};

/// A picture, row-major, 8-bit red, green and blue.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgb;
};

/// The map over the frame's pixels (small frames magnified), each tile in the colour of its cycles;
/// black where no stamp was. Below it the scale: places grow with the square root of the cycles, so
/// that a few hot tiles do not hide the others.
Picture heat_map_picture(const HeatMap& map, const spec::Contract& contract,
                         const spec::FrameState& frame);

}  // namespace pineda::studies
