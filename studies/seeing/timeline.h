// A frame's time as a timeline that trace viewers open.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "studies/seeing/spans.h"

namespace pineda::studies {

/// Chrome trace-event JSON, as Perfetto and chrome://tracing open it. A cycle is a microsecond.
///
/// A unit has two lanes. In the first, a slice is a triangle that the unit's cycles are put down
/// to, from the first such cycle to the last; its arguments are those cycles by cause, starved ones
/// between them among them, and add up to its length. Slices never overlap: where setup is frozen
/// by an output while the next triangle is in it, the earlier triangle has another slice. In the
/// second lane are the cycles that were not busy. Counters are the levels of the FIFOs.
///
/// In       spent(), slot(). Source: "Trace Event Format", the Chromium project.
/// Out      the file, written on the way; kept is one slice a unit and the slots of the FIFOs.
/// Errors   finish() is false when the file took not everything.
class Timeline final : public timing::Listener {
 public:
  /// `about`: a JSON object on what is shown. The file stays the caller's.
  Timeline(std::FILE* file, const Window& window, const std::string& about);

  void spent(timing::Unit unit, timing::Cause cause, timing::Cycle from, timing::Cycle until,
             uint32_t id) override;
  void slot(timing::Fifo fifo, timing::Cycle inserted, timing::Cycle freed) override;

  /// After the frame: ends the file.
  bool finish();
  /// Slices written, of triangles and of stalls.
  uint64_t slices() const { return slices_; }

 private:
  struct Lane {
    SpanJoiner spans;
    Span triangle;  // its slice; of no cycles: none
    timing::UnitCycles cycles;
  };

  void add(timing::Unit unit, const Span& span);
  void end_triangle(timing::Unit unit);
  void stall(timing::Unit unit, const Span& span);
  void slice(int lane, const std::string& name, const Span& span, const std::string& arguments);
  void level(timing::Fifo fifo, timing::Cycle cycle, int level);
  void counter(timing::Fifo fifo, timing::Cycle cycle, int level);
  void put(const std::string& text);

  std::FILE* file_;
  Window window_;
  std::array<Lane, timing::kUnits> lanes_;
  std::array<FifoLevel, timing::kFifos> levels_;
  std::array<int, timing::kFifos> first_levels_{};  // as the window begins
  uint64_t slices_ = 0;
  bool written_ = true;
};

}  // namespace pineda::studies
