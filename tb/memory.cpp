#include "tb/memory.h"

namespace pineda::tb {

MemoryEnd::MemoryEnd(const RtlUnit& unit, int latency_cycles)
    : contract_(unit.contract()),
      reads_(unit, "depth_rd"),
      depth_writes_(unit, "depth_wr"),
      color_writes_(unit, "color_wr"),
      response_valid_(unit.port("depth_rsp_valid_i")),
      response_(unit, "depth_rsp_i"),
      due_(static_cast<size_t>(latency_cycles)) {
  if (latency_cycles < 1 || latency_cycles > contract_.design.max_depth_latency_cycles) {
    throw RtlError(fmt::format("depth latency is {} cycles, must be 1 to {}", latency_cycles,
                               contract_.design.max_depth_latency_cycles));
  }
}

void MemoryEnd::start(const spec::FrameState& frame) {
  buffer_ = core::FrameBuffer(contract_, frame);
}

void MemoryEnd::forget() {
  for (Response& response : due_) response.valid = false;
  response_valid_.set_bit(false);
  reads_.forget();
  depth_writes_.forget();
  color_writes_.forget();
}

void MemoryEnd::drive(const Stalls& stalls, uint64_t cycle) {
  reads_.set_ready(!stalls(Port::kDepthRead, cycle));
  depth_writes_.set_ready(!stalls(Port::kDepthWrite, cycle));
  color_writes_.set_ready(!stalls(Port::kColorWrite, cycle));
  Response& response = due_[cycle % due_.size()];
  response_valid_.set_bit(response.valid);
  if (response.valid) response_.set(response.data);
  response.valid = false;
}

bool MemoryEnd::sample(uint64_t cycle, Listener* listener) {
  // The slot of this cycle has just been answered: it is that of cycle + latency now.
  if (reads_.taken()) {
    const spec::DepthRead read = reads_.value();
    due_[cycle % due_.size()] = {true, buffer_.read(contract_, read.x, read.y, read.mask)};
  }
  bool written = false;
  if (depth_writes_.taken()) {
    const spec::DepthWrite write = depth_writes_.value();
    buffer_.write(contract_, write);
    if (listener != nullptr) listener->depth(cycle, write);
    written = true;
  }
  if (color_writes_.taken()) {
    const spec::ColorWrite write = color_writes_.value();
    buffer_.write(contract_, write);
    if (listener != nullptr) listener->color(cycle, write);
    written = true;
  }
  return written;
}

}  // namespace pineda::tb
