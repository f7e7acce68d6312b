// Coverage that only time shows: FIFOs, stalls, resets in flight, told by the timing model.
#pragma once

#include <array>
#include <memory>
#include <type_traits>

#include "model/timing/raster_top.h"
#include "vectors/coverage/coverage.h"
#include "vectors/coverage/points.h"
#include "vectors/coverage/table.h"

namespace pineda::vectors {

/// A frame of a case in time.
struct SeenTimedFrame {
  const spec::Contract& contract;
  const FrameCase& frame_case;
  const timing::FrameResult& result;
  // If the case is reset on the way: what works, which FIFOs hold something, what is written, when it is.
  std::array<bool, timing::kUnits> works_at_reset{};
  std::array<bool, timing::kFifos> holds_at_reset{};
  bool writes_depth_at_reset = false, writes_color_at_reset = false;
};

template <>
const std::vector<Point<SeenTimedFrame>>& points<SeenTimedFrame>();

inline constexpr int64_t kTimedSamples = 1 << 22;

/// Collects the bins that frames hit in time, with an ideal memory of the design's latency.
///
/// In       frames in the formats of the design, whose ports stall as they say.
/// Out      points(), as those of Coverage.
/// Rate     elaborates the SystemC model, which is possible once per process.
class TimedCoverage {
 public:
  explicit TimedCoverage(const spec::Contract& contract);

  void see(const FrameCase& value);
  std::vector<PointHits> points() const;
  /// Frames of more than kTimedSamples, which were not drawn: the model's memories are whole.
  uint64_t too_large() const { return too_large_; }

 private:
  spec::Contract contract_;
  timing::RasterTop top_;
  Table<SeenTimedFrame> table_;
  uint64_t too_large_ = 0;
};

/// Coverage of the cases of a unit, of frames in time too.
class WholeCoverage {
 public:
  WholeCoverage(Unit unit, const spec::Contract& contract);

  template <class Case>
  void see(const Case& value) {
    coverage_.see(value);
    if constexpr (std::is_same_v<Case, FrameCase>) in_time_->see(value);
  }
  std::vector<PointHits> points() const;
  /// Frames that were not seen in time: TimedCoverage::too_large.
  uint64_t not_timed() const { return in_time_ ? in_time_->too_large() : 0; }

 private:
  Coverage coverage_;
  std::unique_ptr<TimedCoverage> in_time_;  // of frames
};

}  // namespace pineda::vectors
