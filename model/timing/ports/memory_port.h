// A memory port of the rasterizer as a TLM-2.0 initiator.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <array>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/memory/layout.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// Ready and valid, for targets that model them; ignorable. Cycles are those of the frame.
struct HandshakeExtension final : tlm::tlm_extension<HandshakeExtension> {
  Cycle offered = -1;  // by the initiator: the request is there in this cycle
  // By the target, one of them: the cycle in which it accepted the request; or the request was not
  // served, and will not be accepted before that cycle, in which it is to be offered again.
  Cycle accepted = -1;
  Cycle retry_from = -1;

  tlm::tlm_extension_base* clone() const override { return new HandshakeExtension(*this); }
  void copy_from(const tlm::tlm_extension_base& other) override {
    *this = static_cast<const HandshakeExtension&>(other);
  }
};

/// Reads and writes stamps through a socket.
///
/// In       a request and the cycle in which it is offered. Requests come in the order of their
///          cycles where the target's time depends on order.
/// Out      blocking transport, local time as its delay: the cycle times the period, from where the
///          simulation stood when the frame began. A stamp is one burst with byte enables, at the
///          address that memory::FrameLayout says, from a base on.
/// Rate     a target that knows HandshakeExtension says when it accepts. Of any other, reads are
///          accepted when they are offered, writes when the delay it returns is over; reads are
///          answered then, the earliest one cycle after they were accepted and after the last one.
///          Where a target grants direct access it is not called any more: tlm_dmi's latencies are
///          those of a transaction.
/// Errors   a response that is not TLM_OK_RESPONSE: SC_REPORT_FATAL "pineda/memory/response".
class MemorySocket {
 public:
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
  void set_base(uint64_t base) { base_ = base; }
  void set_period(const sc_core::sc_time& period) { period_ = period; }

  /// Cycle 0 is now.
  void begin_frame(const spec::FrameState& frame);

  Taken read(int x, int y, uint32_t mask, Cycle offered, spec::DepthData* data);
  Taken write(const spec::DepthWrite& write, Cycle offered);
  Taken write(const spec::ColorWrite& write, Cycle offered);

 private:
  // The bytes of the largest stamp of any design.
  static constexpr size_t kMaxStampBytes = size_t{spec::kMaxLanes} * 2 * spec::kMaxAttributes;
  using Bytes = std::array<unsigned char, kMaxStampBytes>;

  Taken transfer(tlm::tlm_command command, int x, int y, uint32_t mask, Cycle offered);
  Taken transport(tlm::tlm_command command, uint64_t address, Cycle offered);
  // The stamp's bytes, if the target granted direct access to them.
  unsigned char* direct(uint64_t address) const;
  void enable(uint32_t mask);
  void ask_for_direct_access();
  void invalidate(sc_dt::uint64 start, sc_dt::uint64 end);
  // Cycles from the frame's start, rounded up.
  Cycle cycles_until(const sc_core::sc_time& time) const;
  Cycle ordered(Cycle response);

  spec::Contract contract_;
  int sample_bytes_;
  uint64_t base_ = 0;
  sc_core::sc_time period_{1, sc_core::SC_NS};
  sc_core::sc_time begun_;
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
