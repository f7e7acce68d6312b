#include "model/timing/ports/frame_memory.h"

#include <algorithm>

#include "model/timing/ports/payload.h"

namespace pineda::timing {

using memory::MemoryPort;

FrameMemory::FrameMemory(sc_core::sc_module_name name, const spec::Contract& contract,
                         std::shared_ptr<memory::MemoryTiming> timing,
                         const sc_core::sc_time& period)
    : sc_module(name),
      contract_(contract),
      timing_(std::move(timing)),
      next_(timing_),
      period_(period) {
  depth_socket.register_b_transport(this, &FrameMemory::depth_transport);
  depth_socket.register_get_direct_mem_ptr(this, &FrameMemory::depth_direct);
  depth_socket.register_transport_dbg(this, &FrameMemory::depth_debug);
  color_socket.register_b_transport(this, &FrameMemory::color_transport);
  color_socket.register_get_direct_mem_ptr(this, &FrameMemory::color_direct);
  color_socket.register_transport_dbg(this, &FrameMemory::color_debug);
}

void FrameMemory::begin_frame(const spec::FrameState& frame) {
  if (granted_) {
    if (depth_socket.size() > 0) depth_socket->invalidate_direct_mem_ptr(0, ~sc_dt::uint64{0});
    if (color_socket.size() > 0) color_socket->invalidate_direct_mem_ptr(0, ~sc_dt::uint64{0});
    granted_ = false;
  }
  begin_timing(frame);
  frame_ = frame;
  begun_ = sc_core::sc_time_stamp();
  depth_.layout = {contract_, frame, memory::kDepthBytes};
  color_.layout = {contract_, frame, memory::color_bytes(contract_.design)};
  color_.bytes.assign(color_.layout.bytes(), 0);
  depth_.bytes.resize(depth_.layout.bytes());
  const uint32_t cleared = spec::cleared_depth(contract_.design, frame);
  for (size_t i = 0; i < depth_.bytes.size(); ++i) {
    depth_.bytes[i] = static_cast<unsigned char>(cleared >> (8 * (i % memory::kDepthBytes)));
  }
}

void FrameMemory::begin_timing(const spec::FrameState& frame) {
  timing_ = next_;
  timing_->begin_frame(frame);
  waits_ = timing_->fixed_latency() == 0;
  answer_ = {};
  last_response_ = -1;
}

Reply FrameMemory::ask(MemoryPort port, Cycle offered, int x, int y) {
  const Cycle ready = ready_from(port, offered);
  // What other ports do until then matters only where the timing is not fixed.
  if (ready > offered && waits_) return {false, ready, 0};
  answer_ = {};
  const Cycle response = timing_->accept(port, ready, x, y);
  if (port == MemoryPort::kDepthRead) last_response_ = std::max(response, last_response_ + 1);
  return {true, ready, last_response_};
}

core::FrameBuffer FrameMemory::buffer() const {
  core::FrameBuffer buffer(contract_, frame_);
  const auto channels = static_cast<size_t>(buffer.channels);
  const size_t bytes = contract_.design.attribute_bits > 8 ? 2 : 1;
  const int w_log2 = contract_.design.stamp_width_log2;
  const int h_log2 = contract_.design.stamp_height_log2;
  for (int y = 0; y < frame_.height; ++y) {
    for (int x = 0; x < frame_.width; ++x) {
      const int lane = (y & ((1 << h_log2) - 1)) << w_log2 | (x & ((1 << w_log2) - 1));
      const auto at = [&](const Side& side) {
        return side.bytes.data() + side.layout.offset(x >> w_log2, y >> h_log2) +
               static_cast<size_t>(lane * side.layout.sample_bytes);
      };
      const size_t sample =
          static_cast<size_t>(y) * static_cast<size_t>(frame_.width) + static_cast<size_t>(x);
      const unsigned char* const z = at(depth_);
      buffer.depth[sample] =
          uint32_t{z[0]} | uint32_t{z[1]} << 8 | uint32_t{z[2]} << 16 | uint32_t{z[3]} << 24;
      for (size_t c = 0; c < channels; ++c) {
        const unsigned char* const value = at(color_) + c * bytes;
        buffer.color[sample * channels + c] =
            static_cast<uint16_t>(value[0] | (bytes > 1 ? value[1] << 8 : 0));
      }
    }
  }
  return buffer;
}

Cycle FrameMemory::ready_from(MemoryPort port, Cycle from) {
  if (answer_.port == port && answer_.from <= from && from <= answer_.cycle) return answer_.cycle;
  Cycle cycle = from;
  for (Cycle taken = -1; cycle != taken;) {
    taken = waits_ ? timing_->ready_from(port, cycle) : cycle;
    cycle = first_ready(ready_, memory::stalling(port), taken);
    if (!waits_) break;
  }
  answer_ = {port, from, cycle};
  return cycle;
}

MemoryPort FrameMemory::port_of(const Side& side, tlm::tlm_command command) const {
  const bool read = command == tlm::TLM_READ_COMMAND && &side == &depth_;
  return read ? MemoryPort::kDepthRead : side.write_port;
}

Cycle FrameMemory::accept(const Side& side, const tlm::tlm_generic_payload& payload, Cycle cycle,
                          uint64_t address) {
  answer_ = {};
  const auto stamp = static_cast<int>(address / static_cast<uint64_t>(side.layout.stamp_bytes));
  const int columns = side.layout.columns;
  const Cycle response = timing_->accept(port_of(side, payload.get_command()), cycle,
                                         stamp % columns, stamp / columns);
  return payload.is_read() ? response : cycle;
}

void FrameMemory::transport(Side* side, tlm::tlm_generic_payload* payload,
                            sc_core::sc_time* delay) {
  payload->set_response_status(tlm::TLM_OK_RESPONSE);
  auto* const extension = payload->get_extension<HandshakeExtension>();
  if (!payload->is_read() && !payload->is_write()) {
    if (extension != nullptr) {
      extension->ready_from = ready_from(port_of(*side, extension->asked), extension->offered);
    }
    return;
  }
  payload->set_response_status(checked_range(*payload, side->bytes.size()));
  if (payload->is_response_error()) return;
  payload->set_dmi_allowed(is_transparent());
  extension != nullptr ? handshake(side, payload, extension, delay) : access(side, payload, delay);
}

void FrameMemory::handshake(Side* side, tlm::tlm_generic_payload* payload,
                            HandshakeExtension* extension, sc_core::sc_time* delay) {
  const Cycle offered = extension->offered;
  extension->accepted = ready_from(port_of(*side, payload->get_command()), offered);
  move_bytes(*payload, side->bytes.data() + payload->get_address());
  const Cycle end = accept(*side, *payload, extension->accepted, payload->get_address());
  *delay += sc_core::sc_time::from_value(static_cast<uint64_t>(end - offered) * period_.value());
}

void FrameMemory::access(Side* side, tlm::tlm_generic_payload* payload, sc_core::sc_time* delay) {
  move_bytes(*payload, side->bytes.data() + payload->get_address());
  const sc_core::sc_time passed = sc_core::sc_time_stamp() + *delay - begun_;
  auto cycle = static_cast<Cycle>((passed.value() + period_.value() - 1) / period_.value());
  Cycle end = cycle;
  const auto step = static_cast<uint64_t>(side->layout.stamp_bytes);
  const uint64_t last = payload->get_address() + payload->get_data_length();
  for (uint64_t at = payload->get_address() / step * step; at < last; at += step) {
    cycle = ready_from(port_of(*side, payload->get_command()), cycle);
    end = accept(*side, *payload, cycle, at);
    ++cycle;
  }
  *delay = begun_ + sc_core::sc_time::from_value(static_cast<uint64_t>(end) * period_.value()) -
           sc_core::sc_time_stamp();
}

bool FrameMemory::grant(Side* side, tlm::tlm_dmi* dmi) {
  dmi->init();
  dmi->set_end_address(side->bytes.size() - 1);
  if (!is_transparent()) return false;
  dmi->set_dmi_ptr(side->bytes.data());
  dmi->allow_read_write();
  dmi->set_read_latency(sc_core::sc_time::from_value(
      static_cast<uint64_t>(timing_->fixed_latency()) * period_.value()));
  granted_ = true;
  return true;
}

void FrameMemory::depth_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  transport(&depth_, &payload, &delay);
}
void FrameMemory::color_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  transport(&color_, &payload, &delay);
}
bool FrameMemory::depth_direct(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
  return grant(&depth_, &dmi);
}
bool FrameMemory::color_direct(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
  return grant(&color_, &dmi);
}
unsigned FrameMemory::depth_debug(tlm::tlm_generic_payload& payload) {
  return debug_bytes(payload, &depth_.bytes);
}
unsigned FrameMemory::color_debug(tlm::tlm_generic_payload& payload) {
  return debug_bytes(payload, &color_.bytes);
}

}  // namespace pineda::timing
