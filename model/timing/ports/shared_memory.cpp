#include "model/timing/ports/shared_memory.h"

#include <algorithm>
#include <stdexcept>

namespace pineda::timing {

using sc_core::sc_time;

// A transaction until it has its time of the channel. It lies on the stack of its process, so it
// goes with that if the process is killed.
struct SharedMemory::Request {
  Request(SharedMemory* memory, int who, uint64_t when, uint64_t length)
      : owner(*memory), initiator(who), arrival(when), duration(length) {}
  ~Request() {
    auto& all = owner.waiting_;
    all.erase(std::remove(all.begin(), all.end(), this), all.end());
  }
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;

  SharedMemory& owner;
  int initiator;
  uint64_t arrival, duration;
  uint64_t start = 0;
  bool booked = false;
};

SharedMemory::SharedMemory(sc_core::sc_module_name name, const SharedMemoryParameters& parameters)
    : sc_module(name), parameters_(parameters), bytes_(parameters.bytes) {
  if (parameters.bytes == 0 || parameters.bytes_per_cycle == 0 || parameters.latency_cycles < 0 ||
      parameters.period == sc_core::SC_ZERO_TIME) {
    throw std::invalid_argument("shared memory: expected bytes, bytes a cycle and a period");
  }
  socket.register_b_transport(this, &SharedMemory::b_transport);
  socket.register_transport_dbg(this, &SharedMemory::transport_dbg);
  socket.register_get_direct_mem_ptr(this, &SharedMemory::get_direct_mem_ptr);
}

bool SharedMemory::get_direct_mem_ptr(int, tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
  dmi.init();  // no access at any address: what goes around the channel would not be counted
  return false;
}

void SharedMemory::b_transport(int initiator, tlm::tlm_generic_payload& payload, sc_time& delay) {
  payload.set_dmi_allowed(false);
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  if (!payload.is_read() && !payload.is_write()) return;
  payload.set_response_status(checked_range(payload, bytes_.size()));
  if (payload.is_response_error()) return;
  const uint64_t length = payload.get_data_length();
  const uint64_t cycles = (length + parameters_.bytes_per_cycle - 1) / parameters_.bytes_per_cycle;
  const uint64_t period = parameters_.period.value();
  const uint64_t arrival = sc_core::sc_time_stamp().value() + delay.value();
  Request request(this, initiator, arrival, cycles * period);
  wait_for_turn(&request);
  move_bytes(payload, bytes_.data() + payload.get_address());
  SharedMemoryCounters& counters = counters_[static_cast<size_t>(initiator)];
  ++counters.transactions;
  counters.bytes += length;
  counters.waited += static_cast<Cycle>((request.start - request.arrival) / period);
  const uint64_t latency = static_cast<uint64_t>(parameters_.latency_cycles) * period;
  delay = sc_time::from_value(request.start + request.duration + latency -
                              sc_core::sc_time_stamp().value());
}

void SharedMemory::wait_for_turn(Request* request) {
  const auto process = sc_core::sc_get_current_process_handle();
  const bool can_wait = sc_core::sc_get_status() == sc_core::SC_RUNNING && process.valid() &&
                        process.proc_kind() != sc_core::SC_METHOD_PROC_;
  if (!can_wait) return book(request);
  watch_load();
  const auto ahead = sc_time::from_value(request->arrival - sc_core::sc_time_stamp().value());
  const sc_time& quantum = tlm::tlm_global_quantum::instance().get();
  if (ahead > quantum * load_.free_share) {
    sc_core::wait(ahead);
  } else if (ahead > sc_core::SC_ZERO_TIME) {
    return book(request);
  }
  collect(request);
}

// Long enough for a mean, short enough to follow a frame.
void SharedMemory::watch_load() {
  constexpr uint64_t kWindowCycles = 512;
  sc_core::sc_process_b* const process = sc_core::sc_get_current_process_b();
  load_.shared |= load_.process != nullptr && load_.process != process;
  load_.process = process;
  const uint64_t now = sc_core::sc_time_stamp().value();
  const uint64_t passed = now - load_.begun;
  if (passed < kWindowCycles * parameters_.period.value()) return;
  const double busy = static_cast<double>(book_.busy() - load_.busy) / static_cast<double>(passed);
  const double free = std::max(1 - busy, 0.);
  const double free_share = load_.shared ? free * free : 1;
  load_ = {now, book_.busy(), process, false, free_share};
}

// Requests of one instant come in the order in which the kernel runs their processes. So those that
// are on time are collected for a delta cycle, and then booked by initiator.
void SharedMemory::collect(Request* request) {
  const sc_dt::uint64 delta = sc_core::sc_delta_count();
  if (waiting_delta_ != delta) book_waiting();
  waiting_delta_ = delta;
  waiting_.push_back(request);
  sc_core::wait(sc_core::SC_ZERO_TIME);
  if (!request->booked) book_waiting();
}

void SharedMemory::book_waiting() {
  std::stable_sort(waiting_.begin(), waiting_.end(),
                   [](const Request* a, const Request* b) { return a->initiator < b->initiator; });
  for (Request* request : waiting_) book(request);
  waiting_.clear();
}

void SharedMemory::book(Request* request) {
  // Nobody asks for a time that has passed.
  book_.forget(sc_core::sc_time_stamp().value());
  request->start = book_.book(request->arrival, request->duration);
  request->booked = true;
}

}  // namespace pineda::timing
