#include "model/timing/ports/memory_port.h"

#include <algorithm>
#include <cstring>

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

void MemorySocket::begin_frame(const spec::FrameState& frame) {
  layout_ = {contract_, frame, sample_bytes_};
  begun_ = sc_core::sc_time_stamp();
  last_response_ = -1;
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
  enable(mask);
  return transport(command, base_ + layout_.offset(x, y), offered);
}

MemorySocket::Taken MemorySocket::transport(tlm::tlm_command command, uint64_t address,
                                            Cycle offered) {
  // A target may wait and so let simulated time pass. A request that should have been offered
  // meanwhile is offered now.
  offered = std::max(offered, cycles_until(sc_core::sc_time_stamp()));
  handshake_.offered = offered;
  handshake_.accepted = handshake_.retry_from = -1;
  payload_.set_command(command);
  payload_.set_address(address);
  payload_.set_data_length(static_cast<unsigned>(layout_.stamp_bytes));
  payload_.set_streaming_width(static_cast<unsigned>(layout_.stamp_bytes));
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  auto delay = begun_ +
               sc_core::sc_time::from_value(static_cast<uint64_t>(offered) * period_.value()) -
               sc_core::sc_time_stamp();
  socket->b_transport(payload_, delay);
  if (payload_.is_response_error()) {
    SC_REPORT_FATAL("pineda/memory/response", payload_.get_response_string().c_str());
  }
  if (handshake_.retry_from >= 0) {
    sc_assert(handshake_.retry_from > offered);
    return {-1, -1, handshake_.retry_from};
  }
  const bool read = command == tlm::TLM_READ_COMMAND;
  const Cycle done = std::max(cycles_until(sc_core::sc_time_stamp() + delay), offered);
  const Cycle otherwise = read ? offered : done;
  const Cycle accepted = handshake_.accepted >= 0 ? handshake_.accepted : otherwise;
  if (payload_.is_dmi_allowed() && !has_dmi_) ask_for_direct_access();
  return {accepted, read ? ordered(std::max(done, accepted + 1)) : -1, -1};
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
  const auto cycles = [this](const sc_core::sc_time& latency) {
    return cycles_until(begun_ + latency);
  };
  direct_read_cycles_ = std::max<Cycle>(cycles(dmi_.get_read_latency()), 1);
  direct_write_cycles_ = cycles(dmi_.get_write_latency());
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

Cycle MemorySocket::cycles_until(const sc_core::sc_time& time) const {
  const uint64_t passed = (time - begun_).value();
  return static_cast<Cycle>((passed + period_.value() - 1) / period_.value());
}

}  // namespace pineda::timing
