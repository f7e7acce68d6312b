#include "model/timing/device/triangle_fetch.h"

#include <algorithm>
#include <sstream>

namespace pineda::timing {

TriangleFetch::TriangleFetch(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name), packer_(contract), bytes_(static_cast<size_t>(packer_.words()) * 4) {
  SC_HAS_PROCESS(TriangleFetch);
  SC_THREAD(run);
}

void TriangleFetch::begin(uint64_t address, uint32_t count) {
  ++frame_;
  address_ = address;
  next_ = 0;
  count_ = count;
  failed_ = false;
  fetched_.clear();
  begun_.notify();
  room_.notify();
  changed_.notify();
}

TriangleFetch::Fetched TriangleFetch::take() {
  const Fetched first = fetched_.front();
  fetched_.pop_front();
  room_.notify();
  return first;
}

void TriangleFetch::run() {
  for (;;) {
    if (next_ == count_) {
      wait(begun_);
    } else if (fetched_.size() == kRoom) {
      wait(room_);
    } else {
      fetch();
    }
  }
}

void TriangleFetch::fetch() {
  const uint64_t frame = frame_;
  const bool read_it = read(address_ + next_ * uint64_t{bytes_.size()});
  if (frame != frame_) return;  // stopped meanwhile
  if (read_it) {
    spec::Packed words(static_cast<size_t>(packer_.words()));
    for (size_t i = 0; i < bytes_.size(); ++i) words[i / 4] |= uint32_t{bytes_[i]} << (8 * (i % 4));
    fetched_.push_back({packer_.unpack(words.data()), local_});
    ++next_;
  } else {
    failed_ = true;
    count_ = next_;
  }
  changed_.notify();
  const sc_core::sc_time& now = sc_core::sc_time_stamp();
  const sc_core::sc_time ahead = local_ > now ? local_ - now : sc_core::SC_ZERO_TIME;
  if (ahead > tlm::tlm_global_quantum::instance().get()) wait(ahead);
}

bool TriangleFetch::read(uint64_t address) {
  payload_.set_command(tlm::TLM_READ_COMMAND);
  payload_.set_address(address);
  payload_.set_data_ptr(bytes_.data());
  payload_.set_data_length(static_cast<unsigned>(bytes_.size()));
  payload_.set_streaming_width(static_cast<unsigned>(bytes_.size()));
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  sc_core::sc_time delay = std::max(local_, sc_core::sc_time_stamp()) - sc_core::sc_time_stamp();
  socket->b_transport(payload_, delay);
  local_ = sc_core::sc_time_stamp() + delay;
  if (payload_.is_response_ok()) return true;
  std::ostringstream text;
  text << socket.name() << ": read of " << bytes_.size() << " bytes at 0x" << std::hex << address
       << ": " << payload_.get_response_string();
  SC_REPORT_WARNING("pineda/device/fetch", text.str().c_str());
  return false;
}

}  // namespace pineda::timing
