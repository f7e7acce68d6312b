// The depth and colour memories behind a Verilated unit, as fast as a MemoryTiming says.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/core/frame.h"
#include "model/memory/stalls.h"
#include "model/memory/timing.h"
#include "model/timing/counted/listener.h"
#include "tb/paged_buffer.h"
#include "tb/stream.h"

namespace pineda::tb {

using memory::kStallModes;
using memory::MemoryPort;
using memory::MemoryTiming;
using memory::Port;
using memory::stall_mode_name;
using memory::StallMode;
using memory::Stalls;
using timing::Cycle;
using timing::Listener;

/// A stamp's address and lanes in a packed struct. The memories work on packed words: unpacking
/// every field of every write would cost more than the RTL does.
class StampWords {
 public:
  template <class T>
  StampWords(const spec::Contract& c, const PayloadPort<T>& port) : words_(port.words()) {
    x_ = {port.packer().position("x"), c.width.stamp_x};
    y_ = {port.packer().position("y"), c.width.stamp_y};
    mask_ = {port.packer().position("mask"), c.width.lanes};
  }

  int x() const { return static_cast<int>(x_.get(words_)); }
  int y() const { return static_cast<int>(y_.get(words_)); }
  uint32_t mask() const { return static_cast<uint32_t>(mask_.get(words_)); }
  /// Element `i`, of `bits` bits, of the field that lies at `position`.
  uint64_t element(int position, size_t i, int bits) const {
    return spec::get_bits(words_, position + static_cast<int>(i) * bits, bits);
  }

 private:
  struct Place {
    int position = 0;
    int bits = 0;
    uint64_t get(const uint32_t* words) const { return spec::get_bits(words, position, bits); }
  };
  const uint32_t* words_;
  Place x_, y_, mask_;
};

/// Serves the memory ports of a unit, cycle by cycle: `timing` says when they take requests, as far
/// as they do not stall, and when reads are answered. A read sees the writes accepted in earlier
/// cycles; nothing outside the frame exists. A response waits until it is taken. A design without depth has colour writes alone.
/// Errors   RtlError: responses that do not come in order, one a cycle.
class MemoryEnd {
 public:
  MemoryEnd(const RtlUnit& unit, std::shared_ptr<MemoryTiming> timing);

  /// A frame whose cycle 0 is `cycle`.
  void start(const spec::FrameState& frame, PagedBuffer buffer, Cycle cycle);
  /// The depth of every sample, as the unit asks for it at the start of a frame.
  void clear_depth(uint32_t code);
  /// Before settle: ready signals and a due response.
  void drive(const Stalls& stalls, Cycle cycle);
  /// After settle: takes reads and writes. True when a write was accepted.
  bool sample(Cycle cycle, Listener* listener);
  /// Forgets everything under way, as after a reset.
  void forget();

  void count_hits(const spec::Stamp& stamp);
  const PagedBuffer& memories() const { return buffer_; }

 private:
  struct Response {
    Cycle cycle = 0;
    spec::Packed words;
  };
  /// The ports of the depth memory.
  struct Depth {
    explicit Depth(const RtlUnit& unit);
    SinkEnd<spec::DepthRead> reads;
    SinkEnd<spec::DepthWrite> writes;
    StampWords read_words, write_words;
    int z;  // position of the write's depths
    PortData response_valid, response_ready;
    PayloadPort<spec::DepthData> response;
  };
  bool ready(const Stalls& stalls, MemoryPort port, Cycle cycle) const;
  Cycle accept(MemoryPort port, Cycle cycle, const StampWords& request);
  void read(Cycle cycle);
  void write_depth();
  void write_color();

  const spec::Contract& contract_;
  std::optional<Depth> depth_;
  SinkEnd<spec::ColorWrite> color_writes_;
  StampWords color_words_;
  int attr_ = 0, flat_ = 0;  // positions of the fields
  std::shared_ptr<MemoryTiming> timing_;
  Cycle start_ = 0;                  // the frame's cycle 0
  std::vector<Response> due_;        // read n's is at n modulo its size
  size_t asked_ = 0, answered_ = 0;  // reads
  Cycle last_response_ = -1;
  PagedBuffer buffer_;
};

}  // namespace pineda::tb
