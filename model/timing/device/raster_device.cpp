#include "model/timing/device/raster_device.h"

#include <algorithm>
#include <cstring>

namespace pineda::timing {

namespace {

const RegisterRow* register_at(uint64_t address) {
  const auto* const row =
      std::find_if(std::begin(kRegisters), std::end(kRegisters),
                   [address](const RegisterRow& r) { return r.offset == address; });
  return row != std::end(kRegisters) ? row : nullptr;
}

// What is wrong with an access as such.
tlm::tlm_response_status checked(const tlm::tlm_generic_payload& payload, const RegisterRow* row) {
  if (row == nullptr) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  if (payload.get_data_length() != 4 || payload.get_streaming_width() < 4) {
    return tlm::TLM_BURST_ERROR_RESPONSE;
  }
  const unsigned char* const enables = payload.get_byte_enable_ptr();
  const unsigned count = std::min(payload.get_byte_enable_length(), 4U);
  if (enables != nullptr && std::any_of(enables, enables + count, [](unsigned char enable) {
        return enable != TLM_BYTE_ENABLED;
      })) {
    return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  }
  const Access other = payload.is_read() ? Access::kWrite : Access::kRead;
  return row->access == other ? tlm::TLM_COMMAND_ERROR_RESPONSE : tlm::TLM_OK_RESPONSE;
}

uint32_t word_of(const unsigned char* bytes) {
  return uint32_t{bytes[0]} | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 |
         uint32_t{bytes[3]} << 24;
}

void put_word(uint32_t word, unsigned char* bytes) {
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<unsigned char>(word >> (8 * i));
}

}  // namespace

RasterDevice::RasterDevice(sc_core::sc_module_name name, const spec::Contract& contract,
                           const sc_core::sc_time& period)
    : sc_module(name),
      period_(period),
      bias_limit_(int64_t{1} << contract.design.depth_bits),
      top_("top", contract, Memories::kOutside),
      fetch_("fetch", contract) {
  registers.register_b_transport(this, &RasterDevice::b_transport);
  registers.register_transport_dbg(this, &RasterDevice::transport_dbg);
  top_.set_ready([this](ExternalPort port, Cycle cycle) {
    return port != ExternalPort::kTriangle || cycle >= arrived_;
  });
  reset_registers();
  SC_HAS_PROCESS(RasterDevice);
  SC_THREAD(draw_frames);
  SC_METHOD(drive_interrupt);
  sensitive << interrupts_changed_;
}

// ---- Registers

void RasterDevice::b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  if (!payload.is_read() && !payload.is_write()) return;
  const RegisterRow* const row = register_at(payload.get_address());
  payload.set_response_status(checked(payload, row));
  if (payload.is_response_error()) return;
  if (delay > sc_core::SC_ZERO_TIME) {
    wait(delay);
    delay = sc_core::SC_ZERO_TIME;
  }
  if (payload.is_read()) {
    put_word(read(*row), payload.get_data_ptr());
  } else {
    payload.set_response_status(write(*row, word_of(payload.get_data_ptr())));
  }
}

// Reads registers and has no effect.
unsigned RasterDevice::transport_dbg(tlm::tlm_generic_payload& payload) {
  const RegisterRow* const row = register_at(payload.get_address());
  if (!payload.is_read() || checked(payload, row) != tlm::TLM_OK_RESPONSE) return 0;
  put_word(read(*row), payload.get_data_ptr());
  return 4;
}

uint32_t RasterDevice::read(const RegisterRow& row) const {
  if (row.value != Register::kStatus) return value(row.value);
  const auto queued = static_cast<uint32_t>(queue_.size());
  return (drawing_ || queued > 0 ? kStatusBusy : 0) | (queued == kQueueFrames ? kStatusFull : 0) |
         (has_failed_ ? kStatusFailed : 0) | queued << kStatusQueuedShift;
}

tlm::tlm_response_status RasterDevice::write(const RegisterRow& row, uint32_t written) {
  if (row.value == Register::kControl) return control(written);
  if (row.value == Register::kTriangleData) return push(written);
  if (row.value == Register::kInterruptPending) {
    value(row.value) &= ~written;
  } else {
    value(row.value) = written;
  }
  interrupts_changed_.notify();
  return tlm::TLM_OK_RESPONSE;
}

tlm::tlm_response_status RasterDevice::control(uint32_t bits) {
  if ((bits & kReset) != 0) reset();
  for (const uint32_t bit : {kStart, kStartPushed}) {
    if ((bits & bit) != 0 && !start(bit == kStartPushed)) return tlm::TLM_GENERIC_ERROR_RESPONSE;
  }
  return tlm::TLM_OK_RESPONSE;
}

tlm::tlm_response_status RasterDevice::push(uint32_t word) {
  if (pushed_.size() == kPushedTriangles) return tlm::TLM_GENERIC_ERROR_RESPONSE;
  words_.push_back(word);
  if (words_.size() == static_cast<size_t>(fetch_.packer().words())) {
    pushed_.push_back(fetch_.packer().unpack(words_.data()));
    words_.clear();
  }
  return tlm::TLM_OK_RESPONSE;
}

void RasterDevice::reset() {
  ++resets_;
  queue_.clear();
  top_.stop();
  fetch_.stop();
  words_.clear();
  pushed_.clear();
  has_failed_ = false;
  reset_registers();
  interrupts_changed_.notify();
}

void RasterDevice::reset_registers() {
  for (const RegisterRow& row : kRegisters) value(row.value) = row.reset;
  value(Register::kTriangleWords) = static_cast<uint32_t>(fetch_.packer().words());
}

uint64_t RasterDevice::both(Register low) const {
  const auto high = static_cast<Register>(static_cast<int>(low) + 1);
  return value(low) | uint64_t{value(high)} << 32;
}

// False if there is no such state.
bool RasterDevice::read_state(spec::FrameState* state) const {
  const uint32_t bits = value(Register::kState);
  const uint32_t cull = bits & 3;
  const uint32_t depth = bits >> 4 & 15;
  const auto slope = static_cast<int32_t>(value(Register::kBiasSlope));
  const auto bias = static_cast<int64_t>(both(Register::kBiasConstant));
  float clear_depth;
  std::memcpy(&clear_depth, &values_[static_cast<size_t>(Register::kClearDepth)], 4);
  if (cull >= std::size(spec::kCullNames) || depth >= std::size(spec::kDepthFuncNames) ||
      slope < INT16_MIN || slope > INT16_MAX || bias <= -bias_limit_ || bias >= bias_limit_ ||
      !(clear_depth >= 0 && clear_depth <= 1)) {
    return false;
  }
  const auto low = [this](Register reg) { return static_cast<int>(value(reg) & 0xffff); };
  const auto high = [this](Register reg) { return static_cast<int>(value(reg) >> 16); };
  state->width = low(Register::kFrameSize);
  state->height = high(Register::kFrameSize);
  state->cull = static_cast<spec::Cull>(cull);
  state->depth = static_cast<spec::DepthFunc>(depth);
  state->depth_write = (bits >> 8 & 1) != 0;
  state->shade = (bits >> 9 & 1) != 0 ? spec::Shade::kFlat : spec::Shade::kSmooth;
  state->scissor_x0 = low(Register::kScissorMin);
  state->scissor_y0 = high(Register::kScissorMin);
  state->scissor_x1 = low(Register::kScissorMax);
  state->scissor_y1 = high(Register::kScissorMax);
  state->bias_constant = bias;
  state->bias_slope = slope;
  state->clear_depth = static_cast<double>(clear_depth);
  return true;
}

bool RasterDevice::start(bool pushed) {
  Frame frame{};
  if (queue_.size() == kQueueFrames || !read_state(&frame.state)) return false;
  frame.depth_base = both(Register::kDepthBase);
  frame.color_base = both(Register::kColorBase);
  frame.triangle_base = both(Register::kTriangleBase);
  frame.is_pushed = pushed;
  if (pushed) {
    frame.pushed.swap(pushed_);
    words_.clear();
  }
  frame.count =
      pushed ? static_cast<uint32_t>(frame.pushed.size()) : value(Register::kTriangleCount);
  frame.reset = resets_;
  queue_.push_back(std::move(frame));
  started_.notify();
  return true;
}

// ---- Frames

void RasterDevice::draw_frames() {
  for (;;) {
    while (queue_.empty()) wait(started_);
    drawing_ = true;
    const Frame frame = queue_.front();
    Cycle cycles = 0;
    const bool right = draw(frame, &cycles);
    drawing_ = false;
    if (frame.reset != resets_) continue;  // the queue is another one
    queue_.pop_front();
    ++value(Register::kFramesDone);
    value(Register::kCycles) = static_cast<uint32_t>(cycles);
    value(Register::kInterruptPending) |= right ? kInterruptDone : kInterruptFailed;
    has_failed_ |= !right;
    interrupts_changed_.notify();
  }
}

// False if not all of it was drawn.
bool RasterDevice::draw(const Frame& frame, Cycle* cycles) {
  top_.set_memory_map(period_, frame.depth_base, frame.color_base);
  arrived_ = 0;
  if (!frame.is_pushed) fetch_.begin(frame.triangle_base, frame.count);
  size_t number = 0;
  try {
    const FrameResult result = top_.run(
        frame.state, [&](spec::Triangle* triangle) { return next(frame, number++, triangle); });
    *cycles = result.cycles;
    return result.cycles > 0 && result.counters.triangles == frame.count;
  } catch (const Stopped&) {
    return false;
  } catch (const sc_core::sc_report&) {
    return false;  // the error was reported, and the next frame starts clean
  }
}

// Waits for a triangle. Writes that are due meanwhile are not kept waiting, a few cycles at a time:
// no triangle that is still to come can change what is written then.
bool RasterDevice::next(const Frame& frame, size_t number, spec::Triangle* triangle) {
  constexpr Cycle kStep = 8;
  if (frame.reset != resets_) return false;
  if (frame.is_pushed) {
    if (number == frame.pushed.size()) return false;
    *triangle = frame.pushed[number];
    return true;
  }
  while (fetch_.empty() && !fetch_.at_end()) {
    top_.write_until(static_cast<Cycle>((sc_core::sc_time_stamp() - top_.begun()) / period_) +
                     kStep);
    if (fetch_.empty() && !fetch_.at_end()) {
      wait(period_ * static_cast<double>(kStep), fetch_.changed());
    }
  }
  if (frame.reset != resets_ || fetch_.empty()) return false;
  const TriangleFetch::Fetched fetched = fetch_.take();
  *triangle = fetched.triangle;
  const sc_core::sc_time since =
      fetched.arrived > top_.begun() ? fetched.arrived - top_.begun() : sc_core::SC_ZERO_TIME;
  arrived_ = static_cast<Cycle>((since.value() + period_.value() - 1) / period_.value());
  return true;
}

void RasterDevice::drive_interrupt() {
  interrupt.write((value(Register::kInterruptEnable) & value(Register::kInterruptPending)) != 0);
}

}  // namespace pineda::timing
