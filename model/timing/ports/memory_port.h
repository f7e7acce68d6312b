// A memory port of the rasterizer as a TLM-2.0 initiator.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <array>
#include <exception>
#include <functional>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "model/memory/layout.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// Ready and valid, for targets that model them. Cycles are those of the frame. Ignorable: a read or
/// a write with it is served as one without it. A target that knows it can also be asked, by
/// TLM_IGNORE_COMMAND with no byte enabled, when it would accept a request; one that does not know
/// it leaves ready_from as it is, and is not asked again.
struct HandshakeExtension final : tlm::tlm_extension<HandshakeExtension> {
  Cycle offered = -1;  // by the initiator: the request is there in this cycle
  tlm::tlm_command asked = tlm::TLM_IGNORE_COMMAND;  // by the initiator: what it asks about
  // By the target, asked: the first cycle from `offered` on in which it accepts such a request.
  Cycle ready_from = -1;
  Cycle accepted = -1;  // by the target, of a read or write: the cycle in which it accepted it

  tlm::tlm_extension_base* clone() const override { return new HandshakeExtension(*this); }
  void copy_from(const tlm::tlm_extension_base& other) override {
    *this = static_cast<const HandshakeExtension&>(other);
  }
};

/// Thrown where a frame ends that was stopped.
struct Stopped final : std::exception {
  const char* what() const noexcept override { return "the frame was stopped"; }
};

/// Reads and writes stamps through a socket.
///
/// In       a request and the cycle in which it is offered. Requests come in the order of their
///          cycles where the target's time depends on order.
/// Out      blocking transport, local time as its delay: the cycle times the period, from where the
///          simulation stood when the frame began. A stamp is one burst with byte enables, at the
///          address that memory::FrameLayout says, from a base on. In a process, no transaction is
///          further ahead of simulated time than the global quantum; with a quantum of 0 it is
///          issued in its cycle.
/// Rate     a target that knows HandshakeExtension says when it accepts. Of any other, reads are
///          accepted when they are offered, writes when the transaction is over; reads are
///          answered then, the earliest one cycle after they were accepted and after the last one.
///          A transaction takes as long as the target waits, and the delay that it adds. Where a
///          target grants direct access there are no transactions any more, and no time passes:
///          tlm_dmi's latencies are those of a transaction.
/// Errors   a response that is not TLM_OK_RESPONSE: SC_REPORT_ERROR "pineda/memory/response". Where
///          the handler does not throw, the request counts as served.
class MemorySocket {
 public:
  /// The first cycle from the second one on in which a target takes such a request.
  using Ask = std::function<Cycle(tlm::tlm_command, Cycle)>;
  /// Either the request was accepted, or it is to be offered again in `retry_from`.
  struct Taken {
    Cycle accepted = -1;
    Cycle response = -1;  // of a read
    Cycle retry_from = -1;
  };

  tlm_utils::simple_initiator_socket_optional<MemorySocket> socket;

  /// `sample_bytes`: memory::kDepthBytes or memory::color_bytes().
  MemorySocket(const char* name, const spec::Contract& contract, int sample_bytes);
  ~MemorySocket() { payload_.clear_extension(&handshake_); }
  MemorySocket(const MemorySocket&) = delete;
  MemorySocket& operator=(const MemorySocket&) = delete;

  /// Where the frame lies, and the length of a cycle; from the next frame on.
  void set_base(uint64_t base);
  void set_period(const sc_core::sc_time& period) { period_ = period; }
  /// The target is a part of the rasterizer: it is asked in C++, and nobody waits for its time.
  void set_inside(Ask ask) { inside_ = std::move(ask); }

  /// Finds out whether the target behind the base can be asked. Before a frame begins: a target
  /// that waits even then does not delay its cycles.
  void get_to_know(const spec::FrameState& frame);
  /// Cycle 0 is now.
  void begin_frame(const spec::FrameState& frame);
  /// The next transaction of this frame is not issued: whoever asks for it gets Stopped.
  void stop() { stopped_ = true; }

  Taken read(int x, int y, uint32_t mask, Cycle offered, spec::DepthData* data);
  Taken write(const spec::DepthWrite& write, Cycle offered);
  Taken write(const spec::ColorWrite& write, Cycle offered);

 private:
  // The bytes of the largest stamp of any design.
  static constexpr size_t kMaxStampBytes = size_t{spec::kMaxLanes} * 2 * spec::kMaxAttributes;
  using Bytes = std::array<unsigned char, kMaxStampBytes>;

  enum class Knows : uint8_t { kUnknown, kNothing, kHandshake };  // the target

  Taken transfer(tlm::tlm_command command, int x, int y, uint32_t mask, Cycle offered);
  Taken transport(tlm::tlm_command command, uint64_t address, uint32_t mask, Cycle offered);
  void wait_for_quantum(Cycle offered) const;
  Cycle ask(tlm::tlm_command command, uint64_t address, Cycle offered);
  // The cycles that the transaction takes whose attributes are set.
  Cycle issue(tlm::tlm_command command, uint64_t address, Cycle offered);
  void report_error() const;
  // The stamp's bytes, if the target granted direct access to them.
  unsigned char* direct(uint64_t address) const;
  void enable(uint32_t mask);
  void ask_for_direct_access();
  void invalidate(sc_dt::uint64 start, sc_dt::uint64 end);
  sc_core::sc_time time_of(Cycle cycle) const;
  // Cycles in so much time, rounded up.
  Cycle cycles_in(const sc_core::sc_time& time) const;
  Cycle ordered(Cycle response);

  spec::Contract contract_;
  int sample_bytes_;
  uint64_t base_ = 0;
  sc_core::sc_time period_{1, sc_core::SC_NS};
  sc_core::sc_time begun_;
  Ask inside_;
  Knows knows_ = Knows::kUnknown;
  bool in_process_ = false;  // simulated time can pass
  bool stopped_ = false;
  memory::FrameLayout layout_;
  Cycle last_response_ = -1;
  tlm::tlm_generic_payload payload_;
  HandshakeExtension handshake_;
  Bytes data_{};
  Bytes enabled_{};
  tlm::tlm_dmi dmi_;
  bool has_dmi_ = false;
  Cycle direct_read_cycles_ = 0, direct_write_cycles_ = 0;
};

}  // namespace pineda::timing
