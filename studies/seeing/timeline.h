// A frame's time as a timeline that trace viewers open.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "studies/seeing/spans.h"

namespace pineda::studies {

/// Chrome trace-event JSON, as Perfetto and chrome://tracing open it. A cycle is a microsecond.
///
/// A unit has two lanes. In the first, a slice is a triangle, from the first to the last cycle that
/// the unit spent on it. Its arguments are the cycles by cause, starved ones in between included;
/// they add up to the slice's length. Slices never overlap: where an output freezes setup while the
/// next triangle is in it, the output's triangle gets a further slice. The second lane shows the
/// cycles that were not busy. Counters are the levels of the FIFOs.
///
/// In       spent(), slot(). Source: "Trace Event Format", the Chromium project.
/// Out      the file, written as the frame runs; kept in memory are one slice a unit and the FIFOs'
///          slots.
/// Errors   finish() is false when the file could not be written completely.
class Timeline final : public timing::Listener {
 public:
  /// `about`: a JSON object on what is shown. The caller owns the file.
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
    Span triangle;  // its slice; empty: none
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
