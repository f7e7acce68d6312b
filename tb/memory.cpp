#include "tb/memory.h"

namespace pineda::tb {

MemoryEnd::Depth::Depth(const RtlUnit& unit)
    : reads(unit, "depth_rd"),
      writes(unit, "depth_wr"),
      read_words(unit.contract(), reads.payload()),
      write_words(unit.contract(), writes.payload()),
      z(writes.payload().packer().position("z")),
      response_valid(unit.port("depth_rsp_valid_i")),
      response_ready(unit.port("depth_rsp_ready_o")),
      response(unit, "depth_rsp_i") {}

MemoryEnd::MemoryEnd(const RtlUnit& unit, std::shared_ptr<MemoryTiming> timing)
    : contract_(unit.contract()),
      color_writes_(unit, "color_wr"),
      color_words_(contract_, color_writes_.payload()),
      timing_(std::move(timing)) {
  const spec::Design& d = contract_.design;
  const auto& color = color_writes_.payload().packer();
  if (d.attributes > 0) attr_ = color.position("attr");
  if (d.flat_attributes > 0) flat_ = color.position("flat");
  if (!d.depth_test) return;
  depth_.emplace(unit);
  due_.resize(static_cast<size_t>(contract_.width.inflight_stamps));  // the RTL has no more
  for (Response& response : due_) {
    response.words.resize(static_cast<size_t>(depth_->response.packer().words()) + 1);
  }
}

void MemoryEnd::start(const spec::FrameState& frame, PagedBuffer buffer, Cycle cycle) {
  buffer_ = std::move(buffer);
  timing_->begin_frame(frame);
  start_ = cycle;
}

void MemoryEnd::clear_depth(uint32_t code) { buffer_.clear_depth(code); }

void MemoryEnd::count_hits(const spec::Stamp& stamp) {
  buffer_.for_each_lane(contract_, stamp.x, stamp.y, stamp.mask,
                        [](size_t, PagedBuffer::Page* page, size_t sample) {
                          if (page->hits[sample] != UINT16_MAX) ++page->hits[sample];
                        });
}

void MemoryEnd::forget() {
  answered_ = asked_;
  last_response_ = -1;  // cycles start again
  color_writes_.forget();
  if (!depth_) return;
  depth_->response_valid.set_bit(false);
  depth_->reads.forget();
  depth_->writes.forget();
}

bool MemoryEnd::ready(const Stalls& stalls, MemoryPort port, Cycle cycle) const {
  const Cycle now = cycle - start_;
  return !stalls(memory::stalling(port), now) && timing_->ready_from(port, now) == now;
}

void MemoryEnd::drive(const Stalls& stalls, Cycle cycle) {
  color_writes_.set_ready(ready(stalls, MemoryPort::kColorWrite, cycle));
  if (!depth_) return;
  depth_->reads.set_ready(ready(stalls, MemoryPort::kDepthRead, cycle));
  depth_->writes.set_ready(ready(stalls, MemoryPort::kDepthWrite, cycle));
  const Response& response = due_[answered_ % due_.size()];
  const bool due = answered_ != asked_ && response.cycle <= cycle;
  depth_->response_valid.set_bit(due);
  if (due) depth_->response.set_packed(response.words.data());
}

Cycle MemoryEnd::accept(MemoryPort port, Cycle cycle, const StampWords& request) {
  return timing_->accept(port, cycle - start_, request.x(), request.y()) + start_;
}

void MemoryEnd::read(Cycle cycle) {
  const int bits = contract_.design.depth_bits;
  Response* const response = &due_[asked_++ % due_.size()];
  response->cycle = accept(MemoryPort::kDepthRead, cycle, depth_->read_words);
  if (response->cycle <= std::max(last_response_, cycle)) {
    throw RtlError(
        fmt::format("memory: a read accepted in cycle {} is answered in {}, one before it in {}",
                    cycle, response->cycle, last_response_));
  }
  last_response_ = response->cycle;
  std::fill(response->words.begin(), response->words.end(), 0);
  buffer_.for_each_lane(contract_, depth_->read_words.x(), depth_->read_words.y(),
                        depth_->read_words.mask(),
                        [&](size_t lane, const PagedBuffer::Page* page, size_t sample) {
                          spec::set_bits(response->words.data(), static_cast<int>(lane) * bits,
                                         bits, page->depth[sample]);
                        });
}

void MemoryEnd::write_depth() {
  const int bits = contract_.design.depth_bits;
  buffer_.for_each_lane(
      contract_, depth_->write_words.x(), depth_->write_words.y(), depth_->write_words.mask(),
      [&](size_t lane, PagedBuffer::Page* page, size_t sample) {
        page->depth[sample] =
            static_cast<uint32_t>(depth_->write_words.element(depth_->z, lane, bits));
      });
}

void MemoryEnd::write_color() {
  const auto attributes = static_cast<size_t>(contract_.design.attributes);
  const auto flat = static_cast<size_t>(contract_.design.flat_attributes);
  const int bits = contract_.design.attribute_bits;
  buffer_.for_each_lane(
      contract_, color_words_.x(), color_words_.y(), color_words_.mask(),
      [&](size_t lane, PagedBuffer::Page* page, size_t sample) {
        uint16_t* to = page->color.data() + sample * (attributes + flat);
        for (size_t a = 0; a < attributes; ++a) {
          *to++ = static_cast<uint16_t>(color_words_.element(attr_, lane * attributes + a, bits));
        }
        for (size_t a = 0; a < flat; ++a) {
          *to++ = static_cast<uint16_t>(color_words_.element(flat_, a, bits));
        }
      });
}

bool MemoryEnd::sample(Cycle cycle, Listener* listener) {
  if (depth_ && depth_->response_valid.bit() && depth_->response_ready.bit()) ++answered_;
  // A read sees the writes accepted before its cycle, so it comes first.
  if (depth_ && depth_->reads.taken()) read(cycle);
  const bool depth = depth_ && depth_->writes.taken();
  if (depth) {
    accept(MemoryPort::kDepthWrite, cycle, depth_->write_words);
    write_depth();
    if (listener != nullptr) listener->depth(cycle, depth_->writes.value());
  }
  const bool color = color_writes_.taken();
  if (color) {
    accept(MemoryPort::kColorWrite, cycle, color_words_);
    write_color();
    if (listener != nullptr) listener->color(cycle, color_writes_.value());
  }
  return depth || color;
}

}  // namespace pineda::tb
