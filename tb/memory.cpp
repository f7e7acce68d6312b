#include "tb/memory.h"

namespace pineda::tb {

MemoryEnd::MemoryEnd(const RtlUnit& unit, int latency_cycles)
    : contract_(unit.contract()),
      reads_(unit, "depth_rd"),
      depth_writes_(unit, "depth_wr"),
      color_writes_(unit, "color_wr"),
      read_words_(contract_, reads_.payload(), nullptr),
      depth_words_(contract_, depth_writes_.payload(), "z"),
      color_words_(contract_, color_writes_.payload(), "attr"),
      response_valid_(unit.port("depth_rsp_valid_i")),
      response_(unit, "depth_rsp_i") {
  if (latency_cycles < 1 || latency_cycles > contract_.design.max_depth_latency_cycles) {
    throw RtlError(fmt::format("depth latency is {} cycles, must be 1 to {}", latency_cycles,
                               contract_.design.max_depth_latency_cycles));
  }
  due_.resize(static_cast<size_t>(latency_cycles));
  for (Response& response : due_) {
    response.words.resize(static_cast<size_t>(response_.packer().words()));
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
  if (response.valid) {
    std::copy(response.words.begin(), response.words.end(), response_.words());
  }
  response.valid = false;
}

void MemoryEnd::read(Response* response) const {
  const int bits = contract_.design.depth_bits;
  response->valid = true;
  std::fill(response->words.begin(), response->words.end(), 0);
  buffer_.for_each_lane(contract_, read_words_.x(), read_words_.y(), read_words_.mask(),
                        [&](size_t lane, size_t sample) {
                          spec::set_bits(response->words.data(), static_cast<int>(lane) * bits,
                                         bits, buffer_.depth[sample]);
                        });
}

void MemoryEnd::write_depth() {
  const int bits = contract_.design.depth_bits;
  buffer_.for_each_lane(contract_, depth_words_.x(), depth_words_.y(), depth_words_.mask(),
                        [&](size_t lane, size_t sample) {
                          buffer_.depth[sample] =
                              static_cast<uint32_t>(depth_words_.element(lane, bits));
                        });
}

void MemoryEnd::write_color() {
  const auto attributes = static_cast<size_t>(buffer_.attributes);
  const int bits = contract_.design.attribute_bits;
  buffer_.for_each_lane(contract_, color_words_.x(), color_words_.y(), color_words_.mask(),
                        [&](size_t lane, size_t sample) {
                          for (size_t a = 0; a < attributes; ++a) {
                            buffer_.color[sample * attributes + a] = static_cast<uint16_t>(
                                color_words_.element(lane * attributes + a, bits));
                          }
                        });
}

bool MemoryEnd::sample(uint64_t cycle, Listener* listener) {
  // The slot of this cycle has just been answered: it is that of cycle + latency now. A read sees
  // the writes accepted before its cycle, so it comes first.
  if (reads_.taken()) read(&due_[cycle % due_.size()]);
  const bool depth = depth_writes_.taken();
  if (depth) {
    write_depth();
    if (listener != nullptr) listener->depth(cycle, depth_writes_.value());
  }
  const bool color = color_writes_.taken();
  if (color) {
    write_color();
    if (listener != nullptr) listener->color(cycle, color_writes_.value());
  }
  return depth || color;
}

}  // namespace pineda::tb
