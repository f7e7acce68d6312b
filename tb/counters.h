// What the RTL counts of a frame, as the model names it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/timing/counted/counters.h"
#include "tb/rtl.h"

namespace pineda::tb {

/// The counters inside the Verilated top. They run on from frame to frame, so a frame has the
/// difference between its start and its end.
///
/// Errors   RtlError: the plug-in lacks an array of events that a counter adds up.
class Counters {
 public:
  explicit Counters(const RtlUnit& top);

  /// The coming clock edge is the frame's first.
  void start();
  /// The coming clock edge ends cycle `drained` of the frame, in which it has drained. All but the
  /// frame's cycles, which no array counts.
  timing::FrameResult read(timing::Cycle drained) const;

 private:
  /// Events by kind, where they lie and as the frame began.
  class Events {
   public:
    explicit Events(PortData port);
    void start();
    /// Those since the start that a counter adds up.
    uint64_t counted(const core::RtlKinds& kinds) const;

   private:
    PortData port_;
    std::vector<uint64_t> first_;
  };

  const spec::Contract& contract_;
  std::map<std::string, Events> events_;  // by the name of the array
};

}  // namespace pineda::tb
