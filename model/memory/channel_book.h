// When a channel that several share is busy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

namespace pineda::memory {

/// Books times of a channel that serves one request after the other. A request is booked in the
/// earliest gap at or after its arrival that is long enough, whatever was booked before: one that
/// arrives earlier and is heard of later still gets a gap that was left. Times are in any unit.
class ChannelBook {
 public:
  using Time = uint64_t;

  /// Returns the start of the booked time, `arrival` or later.
  Time book(Time arrival, Time duration);
  /// No request will arrive before that time: what lies there need not be kept. One that does
  /// arrive counts as arriving then.
  void forget(Time before);

  /// All that was ever booked.
  Time busy() const { return total_; }
  /// The stretches of busy time that are kept.
  size_t kept() const { return busy_.size(); }

 private:
  std::map<Time, Time> busy_;  // the end of each stretch, by its start; gaps lie between them
  Time forgotten_ = 0;
  Time total_ = 0;
};

}  // namespace pineda::memory
