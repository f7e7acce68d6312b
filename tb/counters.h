// What the RTL counts of a frame, as the model names it.
#pragma once

#include <vector>

#include "model/timing/cycles.h"
#include "tb/rtl.h"

namespace pineda::tb {

/// The counters inside the Verilated top. They run on from frame to frame, so a frame has the
/// difference between its start and its end.
///
/// Errors   RtlError: the plug-in has no counters.
class Counters {
 public:
  explicit Counters(const RtlUnit& top);

  /// The coming clock edge is the frame's first.
  void start();
  /// The coming clock edge ends cycle `drained` of the frame, in which it has drained. Both
  /// results are empty before.
  void read(timing::Cycle drained, timing::CycleCounters* spent,
            core::FrameCounters* counters) const;

 private:
  /// Counts by kind, where they lie and as the frame began.
  class Group {
   public:
    Group(const RtlUnit& top, const std::string& name);
    void start();
    size_t kinds() const { return first_.size(); }
    uint64_t operator[](size_t kind) const { return now(kind) - first_[kind]; }

   private:
    uint64_t now(size_t kind) const;

    PortData port_;
    std::vector<uint64_t> first_;
  };

  void read_cycles(timing::CycleCounters* spent) const;
  void read_work(timing::CycleCounters* spent, core::FrameCounters* counters) const;

  std::vector<Group> units_;      // by Unit: cycles by Cause
  std::vector<Group> levels_;     // by Fifo: cycles by level
  std::vector<Group> stalls_;     // by MemoryPort; a design without depth has that of colour alone
  Group drops_;                   // by Drop
  Group tests_;                   // of tiles: kept, accepted whole, rejected, hidden
  Group sent_, passed_, failed_;  // stamps by samples
};

}  // namespace pineda::tb
