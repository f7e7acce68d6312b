// A memory behind one channel that several initiators share.
#pragma once

#include <tlm_utils/multi_passthrough_target_socket.h>

#include <systemc>
#include <tlm>
#include <vector>

#include "model/memory/channel_book.h"
#include "model/timing/counted/cycles.h"
#include "model/timing/ports/payload.h"

namespace pineda::timing {

struct SharedMemoryParameters {
  uint64_t bytes = uint64_t{1} << 20;
  sc_core::sc_time period{1, sc_core::SC_NS};
  unsigned bytes_per_cycle = 16;
  Cycle latency_cycles = 0;
};

/// What an initiator asked of a SharedMemory.
struct SharedMemoryCounters {
  uint64_t transactions = 0;
  uint64_t bytes = 0;
  Cycle waited = 0;  // cycles from the arrivals of its transactions to their turns
};

/// Serves one read or write after the other, as they arrive by their time stamps: simulated time
/// and the delay that comes with them. Of those of one instant the lower initiator, by the order in
/// which sockets were bound, goes first; a second one of an initiator in that instant comes behind
/// the first ones of all.
///
/// Bits     bytes from address 0 on; they move when the transaction comes, not in its turn.
/// In       blocking transport, byte enables; debug transport.
/// Out      the delay that is returned ends with the transaction. No direct access.
/// Rate     a transaction has the channel for data_length / bytes_per_cycle cycles, rounded up, and
///          ends latency_cycles after that, in which the channel serves others. Initiators may be
///          ahead of simulated time, by the global quantum times the share of time in which the
///          channel was free of late: who is further ahead waits within the call until the request
///          is on time. So where processes fight for the channel they do it in time, whatever the
///          quantum; one that has it for itself is never held.
/// Errors   beyond the memory: TLM_ADDRESS_ERROR_RESPONSE; a streaming width below the length:
///          TLM_BURST_ERROR_RESPONSE. Parameters of 0 bytes or no period: std::invalid_argument.
class SharedMemory final : public sc_core::sc_module {
 public:
  tlm_utils::multi_passthrough_target_socket<SharedMemory> socket{"socket"};

  SharedMemory(sc_core::sc_module_name name, const SharedMemoryParameters& parameters);

  /// Of the initiator that was bound as number `i`.
  const SharedMemoryCounters& counters(size_t i) const { return counters_.at(i); }
  /// Cycles in which the channel was in use.
  Cycle busy_cycles() const {
    return static_cast<Cycle>(book_.busy() / parameters_.period.value());
  }
  std::vector<unsigned char>& bytes() { return bytes_; }

 private:
  struct Request;
  void end_of_elaboration() override { counters_.resize(socket.size()); }
  void b_transport(int initiator, tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(int, tlm::tlm_generic_payload& payload) {
    return debug_bytes(payload, &bytes_);
  }
  bool get_direct_mem_ptr(int, tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi);
  void wait_for_turn(Request* request);
  void watch_load();
  void collect(Request* request);
  void book(Request* request);
  void book_waiting();

  SharedMemoryParameters parameters_;
  std::vector<unsigned char> bytes_;
  memory::ChannelBook book_;
  std::vector<SharedMemoryCounters> counters_;
  /// The load of late: in windows of simulated time.
  struct Load {
    uint64_t begun = 0;                        // the window
    uint64_t busy = 0;                         // all that was booked when it began
    sc_core::sc_process_b* process = nullptr;  // the last one that asked
    bool shared = false;                       // another one asked, too
    double free_share = 0;                     // of the last window, 1 if one process asked
  };
  Load load_;
  std::vector<Request*> waiting_;    // that came in one instant
  sc_dt::uint64 waiting_delta_ = 0;  // and in which delta cycle
};

}  // namespace pineda::timing
