#include "model/timing/ports/memory_port.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace pineda::timing {

namespace {

void put(unsigned char* to, uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to[i] = static_cast<unsigned char>(value >> (8 * i));
}

uint32_t get(const unsigned char* from, int bytes) {
  uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value |= uint32_t{from[i]} << (8 * i);
  return value;
}

// Calls visit(lane, offset of its sample) for each lane of a mask.
template <class Visitor>
void for_each_lane(uint32_t mask, int sample_bytes, Visitor&& visit) {
  for (; mask != 0; mask &= mask - 1) {
    const auto lane = static_cast<size_t>(__builtin_ctz(mask));
    visit(lane, lane * static_cast<size_t>(sample_bytes));
  }
}

}  // namespace

MemorySocket::MemorySocket(const char* name, const spec::Contract& contract, int sample_bytes)
    : socket(name), contract_(contract), sample_bytes_(sample_bytes) {
  socket.register_invalidate_direct_mem_ptr(this, &MemorySocket::invalidate);
  payload_.set_extension(&handshake_);
  payload_.set_data_ptr(data_.data());
}

void MemorySocket::set_base(uint64_t base) {
  if (base != base_) knows_ = Knows::kUnknown;  // another target may lie there
  base_ = base;
}

void MemorySocket::get_to_know(const spec::FrameState& frame) {
  if (knows_ != Knows::kUnknown || inside_ || socket.size() == 0) return;
  layout_ = {contract_, frame, sample_bytes_};
  begun_ = sc_core::sc_time_stamp();
  ask(tlm::TLM_WRITE_COMMAND, base_, 0);
  knows_ = handshake_.ready_from >= 0 ? Knows::kHandshake : Knows::kNothing;
}

void MemorySocket::begin_frame(const spec::FrameState& frame) {
  layout_ = {contract_, frame, sample_bytes_};
  begun_ = sc_core::sc_time_stamp();
  last_response_ = -1;
  in_process_ = !inside_ && sc_core::sc_get_status() == sc_core::SC_RUNNING;
  stopped_ = false;
}

MemorySocket::Taken MemorySocket::read(int x, int y, uint32_t mask, Cycle offered,
                                       spec::DepthData* data) {
  const uint64_t address = base_ + layout_.offset(x, y);
  const unsigned char* from = direct(address);
  Taken taken;
  if (from != nullptr) {
    taken = {offered, ordered(offered + direct_read_cycles_), -1};
  } else {
    taken = transfer(tlm::TLM_READ_COMMAND, x, y, mask, offered);
    from = data_.data();
  }
  if (taken.retry_from >= 0) return taken;
  *data = {};
  for_each_lane(mask, sample_bytes_, [&](size_t lane, size_t offset) {
    data->z[lane] = get(from + offset, memory::kDepthBytes);
  });
  return taken;
}

MemorySocket::Taken MemorySocket::write(const spec::DepthWrite& write, Cycle offered) {
  unsigned char* const direct_to = direct(base_ + layout_.offset(write.x, write.y));
  unsigned char* const to = direct_to != nullptr ? direct_to : data_.data();
  for_each_lane(write.mask, sample_bytes_, [&](size_t lane, size_t offset) {
    put(to + offset, write.z[lane], memory::kDepthBytes);
  });
  if (direct_to != nullptr) return {offered + direct_write_cycles_, -1, -1};
  return transfer(tlm::TLM_WRITE_COMMAND, write.x, write.y, write.mask, offered);
}

MemorySocket::Taken MemorySocket::write(const spec::ColorWrite& write, Cycle offered) {
  const spec::Design& d = contract_.design;
  const auto attributes = static_cast<size_t>(d.attributes);
  const auto flat = static_cast<size_t>(d.flat_attributes);
  const int bytes = d.attribute_bits > 8 ? 2 : 1;
  unsigned char* const direct_to = direct(base_ + layout_.offset(write.x, write.y));
  unsigned char* const first = direct_to != nullptr ? direct_to : data_.data();
  for_each_lane(write.mask, sample_bytes_, [&](size_t lane, size_t offset) {
    unsigned char* to = first + offset;
    if (attributes + flat == 0) *to = 0xff;
    for (size_t a = 0; a < attributes; ++a, to += bytes) put(to, write.attr[lane][a], bytes);
    for (size_t a = 0; a < flat; ++a, to += bytes) put(to, write.flat[a], bytes);
  });
  if (direct_to != nullptr) return {offered + direct_write_cycles_, -1, -1};
  return transfer(tlm::TLM_WRITE_COMMAND, write.x, write.y, write.mask, offered);
}

MemorySocket::Taken MemorySocket::transfer(tlm::tlm_command command, int x, int y, uint32_t mask,
                                           Cycle offered) {
  return transport(command, base_ + layout_.offset(x, y), mask, offered);
}

MemorySocket::Taken MemorySocket::transport(tlm::tlm_command command, uint64_t address,
                                            uint32_t mask, Cycle offered) {
  wait_for_quantum(offered);
  if (stopped_) throw Stopped();
  if (inside_ || knows_ == Knows::kHandshake) {
    const Cycle ready =
        inside_ ? inside_(command, offered) : std::max(ask(command, address, offered), offered);
    if (ready > offered) return {-1, -1, ready};
  }
  enable(mask);
  const Cycle done = offered + issue(command, address, offered);
  if (payload_.is_response_error()) report_error();
  const bool read = command == tlm::TLM_READ_COMMAND;
  const Cycle otherwise = read ? offered : done;
  const Cycle accepted = handshake_.accepted >= 0 ? handshake_.accepted : otherwise;
  if (payload_.is_dmi_allowed() && !has_dmi_) ask_for_direct_access();
  return {accepted, read ? ordered(std::max(done, accepted + 1)) : -1, -1};
}

// As a quantum keeper does: whoever is too far ahead waits until simulated time has caught up.
void MemorySocket::wait_for_quantum(Cycle offered) const {
  if (!in_process_) return;
  const sc_core::sc_time due = time_of(offered);
  const sc_core::sc_time& now = sc_core::sc_time_stamp();
  if (due > now && due - now > tlm::tlm_global_quantum::instance().get()) sc_core::wait(due - now);
}

// When the target would accept a request. A target that takes TLM_IGNORE_COMMAND for a write finds
// no byte to write.
Cycle MemorySocket::ask(tlm::tlm_command command, uint64_t address, Cycle offered) {
  static unsigned char disabled = TLM_BYTE_DISABLED;
  payload_.set_byte_enable_ptr(&disabled);
  payload_.set_byte_enable_length(1);
  handshake_.asked = command;
  issue(tlm::TLM_IGNORE_COMMAND, address, offered);
  return handshake_.ready_from;
}

Cycle MemorySocket::issue(tlm::tlm_command command, uint64_t address, Cycle offered) {
  handshake_.offered = offered;
  handshake_.accepted = handshake_.ready_from = -1;
  payload_.set_command(command);
  payload_.set_address(address);
  payload_.set_data_length(static_cast<unsigned>(layout_.stamp_bytes));
  payload_.set_streaming_width(static_cast<unsigned>(layout_.stamp_bytes));
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  // A target that waited has let simulated time pass. A request of the meantime is issued now, and
  // takes as long as it would have then.
  const sc_core::sc_time sent = std::max(time_of(offered), sc_core::sc_time_stamp());
  sc_core::sc_time delay = sent - sc_core::sc_time_stamp();
  socket->b_transport(payload_, delay);
  const sc_core::sc_time end = sc_core::sc_time_stamp() + delay;
  return end > sent ? cycles_in(end - sent) : 0;
}

void MemorySocket::report_error() const {
  std::ostringstream text;
  text << socket.name() << ": " << (payload_.is_read() ? "read" : "write") << " of "
       << payload_.get_data_length() << " bytes at 0x" << std::hex << payload_.get_address() << ": "
       << payload_.get_response_string();
  SC_REPORT_ERROR("pineda/memory/response", text.str().c_str());
}

Cycle MemorySocket::ordered(Cycle response) {
  last_response_ = std::max(response, last_response_ + 1);
  return last_response_;
}

void MemorySocket::enable(uint32_t mask) {
  const uint32_t all = static_cast<uint32_t>((uint64_t{1} << contract_.width.lanes) - 1);
  if (mask == all) {
    payload_.set_byte_enable_ptr(nullptr);
    payload_.set_byte_enable_length(0);
    return;
  }
  const auto bytes = static_cast<size_t>(layout_.stamp_bytes);
  std::fill_n(enabled_.begin(), bytes, static_cast<unsigned char>(TLM_BYTE_DISABLED));
  for_each_lane(mask, sample_bytes_, [&](size_t, size_t offset) {
    std::fill_n(enabled_.data() + offset, sample_bytes_,
                static_cast<unsigned char>(TLM_BYTE_ENABLED));
  });
  payload_.set_byte_enable_ptr(enabled_.data());
  payload_.set_byte_enable_length(static_cast<unsigned>(bytes));
}

void MemorySocket::ask_for_direct_access() {
  dmi_.init();
  has_dmi_ = socket->get_direct_mem_ptr(payload_, dmi_) && dmi_.is_read_write_allowed();
  direct_read_cycles_ = std::max<Cycle>(cycles_in(dmi_.get_read_latency()), 1);
  direct_write_cycles_ = cycles_in(dmi_.get_write_latency());
}

void MemorySocket::invalidate(sc_dt::uint64 start, sc_dt::uint64 end) {
  if (has_dmi_ && start <= dmi_.get_end_address() && end >= dmi_.get_start_address()) {
    has_dmi_ = false;
  }
}

unsigned char* MemorySocket::direct(uint64_t address) const {
  const uint64_t last = address + static_cast<uint64_t>(layout_.stamp_bytes) - 1;
  if (!has_dmi_ || address < dmi_.get_start_address() || last > dmi_.get_end_address()) {
    return nullptr;
  }
  return dmi_.get_dmi_ptr() + (address - dmi_.get_start_address());
}

sc_core::sc_time MemorySocket::time_of(Cycle cycle) const {
  return begun_ + sc_core::sc_time::from_value(static_cast<uint64_t>(cycle) * period_.value());
}

Cycle MemorySocket::cycles_in(const sc_core::sc_time& time) const {
  return static_cast<Cycle>((time.value() + period_.value() - 1) / period_.value());
}

}  // namespace pineda::timing
