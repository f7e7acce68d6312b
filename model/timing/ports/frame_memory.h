// Depth and colour of a frame behind TLM-2.0 target sockets, as fast as a MemoryTiming says.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <memory>
#include <vector>

#include "model/core/frame.h"
#include "model/memory/timing.h"
#include "model/timing/ports/memory.h"
#include "model/timing/ports/memory_port.h"

namespace pineda::timing {

/// The memories that are shipped: ideal or DRAM, see memory::MemoryTiming. For the rasterizer or
/// any other initiator.
///
/// Bits     bytes at the addresses of memory::FrameLayout, from 0 on.
/// In       blocking transport, byte enables; debug transport. With a HandshakeExtension a request
///          is one stamp, offered in the cycle that it says, and a port can be asked when it takes
///          one. Without it a request may be any range: its stamps are accessed one after the
///          other. The delay that comes back ends with the last one's response or acceptance.
///          Colours are read at the port that writes them.
/// Rate     that of the timing, in the cycles in which the ports do not stall. A memory of fixed
///          latency that does not stall grants direct access.
/// Errors   beyond the frame: TLM_ADDRESS_ERROR_RESPONSE; a streaming width below the length:
///          TLM_BURST_ERROR_RESPONSE.
class FrameMemory final : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket_optional<FrameMemory> depth_socket{"depth_socket"};
  tlm_utils::simple_target_socket_optional<FrameMemory> color_socket{"color_socket"};

  FrameMemory(sc_core::sc_module_name name, const spec::Contract& contract,
              std::shared_ptr<memory::MemoryTiming> timing,
              const sc_core::sc_time& period = {1, sc_core::SC_NS});

  /// From the next frame on.
  void set_timing(std::shared_ptr<memory::MemoryTiming> timing) { next_ = std::move(timing); }
  void set_period(const sc_core::sc_time& period) { period_ = period; }
  void set_ready(Ready ready) {
    ready_ = std::move(ready);
    answer_ = {};
  }
  const memory::MemoryTiming& timing() const { return *timing_; }
  /// In the next frame no request waits and every read takes fixed_latency(), whatever the order.
  bool is_transparent() const { return next_->fixed_latency() > 0 && !ready_; }
  Cycle fixed_latency() const { return next_->fixed_latency(); }
  /// The first cycle from `from` on in which a port takes a request.
  Cycle ready_from(memory::MemoryPort port, Cycle from);

  // Time alone, for whoever keeps the bytes:
  /// A frame of this size.
  void begin_timing(const spec::FrameState& frame);
  /// A request on the stamp in column x, row y, in the order that DepthMemory states.
  Reply ask(memory::MemoryPort port, Cycle offered, int x, int y);

  /// Clears both for a frame of this size, whose cycle 0 is now. Gives back granted direct access.
  void begin_frame(const spec::FrameState& frame);
  /// What they hold, sample by sample; hits are not counted.
  core::FrameBuffer buffer() const;

 private:
  struct Side {
    memory::MemoryPort write_port;
    memory::FrameLayout layout;
    std::vector<unsigned char> bytes;
  };
  void depth_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  void color_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  bool depth_direct(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& dmi);
  bool color_direct(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& dmi);
  unsigned depth_debug(tlm::tlm_generic_payload& payload);
  unsigned color_debug(tlm::tlm_generic_payload& payload);

  void transport(Side* side, tlm::tlm_generic_payload* payload, sc_core::sc_time* delay);
  void handshake(Side* side, tlm::tlm_generic_payload* payload, HandshakeExtension* extension,
                 sc_core::sc_time* delay);
  void access(Side* side, tlm::tlm_generic_payload* payload, sc_core::sc_time* delay);
  bool grant(Side* side, tlm::tlm_dmi* dmi);
  memory::MemoryPort port_of(const Side& side, tlm::tlm_command command) const;
  // The cycle in which a request ends that is accepted in `cycle`.
  Cycle accept(const Side& side, const tlm::tlm_generic_payload& payload, Cycle cycle,
               uint64_t address);

  spec::Contract contract_;
  std::shared_ptr<memory::MemoryTiming> timing_, next_;
  sc_core::sc_time period_;
  sc_core::sc_time begun_;
  spec::FrameState frame_;
  Ready ready_;
  Side depth_{memory::MemoryPort::kDepthWrite, {}, {}};
  Side color_{memory::MemoryPort::kColorWrite, {}, {}};
  bool granted_ = false;
  bool waits_ = true;         // the timing is not always ready
  Cycle last_response_ = -1;  // of ask()
  /// The last answer of ready_from(): a request comes right after the question about it. It holds
  /// for all cycles of it until a request is accepted.
  struct {
    memory::MemoryPort port{};
    Cycle from = -1, cycle = -1;
  } answer_;
};

}  // namespace pineda::timing
