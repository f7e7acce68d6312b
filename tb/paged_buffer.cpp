#include "tb/paged_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "tb/rtl.h"

namespace pineda::tb {

PagedBuffer::PagedBuffer(const spec::Contract& contract, const spec::FrameState& frame)
    : width_(frame.width),
      height_(frame.height),
      channels_(spec::channels(contract.design)),
      columns_((frame.width + kSide - 1) / kSide),
      clear_depth_(spec::cleared_depth(contract.design, frame)),
      cleared_to_(clear_depth_) {
  const int rows = (frame.height + kSide - 1) / kSide;
  pages_.resize(static_cast<size_t>(columns_) * static_cast<size_t>(rows));
}

PagedBuffer::PagedBuffer(const spec::Contract& contract, const core::FrameBuffer& buffer)
    : PagedBuffer(contract, [&] {
        spec::FrameState frame;
        frame.width = buffer.width;
        frame.height = buffer.height;
        return frame;
      }()) {
  clear_depth_ = cleared_to_ = buffer.clear_depth;
  const auto channels = static_cast<size_t>(channels_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      Page* const page = made(x / kSide, y / kSide);
      const size_t from = buffer.index(x, y);
      const size_t to = place_of(x, y);
      page->depth[to] = buffer.depth[from];
      page->hits[to] = buffer.hits[from];
      std::copy_n(&buffer.color[from * channels], channels, &page->color[to * channels]);
    }
  }
}

PagedBuffer::Page* PagedBuffer::made(int column, int row) {
  auto& page = pages_[static_cast<size_t>(row) * static_cast<size_t>(columns_) +
                      static_cast<size_t>(column)];
  if (!page) {
    constexpr size_t kSamples = size_t{kSide} * kSide;
    page = std::make_unique<Page>(
        Page{column * kSide, row * kSide, std::vector<uint32_t>(kSamples, cleared_to_),
             std::vector<uint16_t>(kSamples * static_cast<size_t>(channels_)),
             std::vector<uint16_t>(kSamples)});
  }
  return page.get();
}

PagedBuffer::Page* PagedBuffer::page_of(const spec::Contract& contract, int left, int top,
                                        uint32_t mask) {
  const int stamp_width = 1 << contract.design.stamp_width_log2;
  const int stamp_height = 1 << contract.design.stamp_height_log2;
  bool inside = left + stamp_width <= width_ && top + stamp_height <= height_;
  if (!inside) {
    inside = left < width_ && top < height_;
    core::for_each_lane(contract.design, mask, [&](size_t, int column, int row) {
      inside &= left + column < width_ && top + row < height_;
    });
  }
  if (!inside) {
    throw RtlError(
        fmt::format("memory: lanes {:#x} of the stamp at ({}, {}) px lie outside the "
                    "frame of {} x {}",
                    mask, left, top, width_, height_));
  }
  return made(left / kSide, top / kSide);
}

void PagedBuffer::clear_depth(uint32_t code) {
  cleared_to_ = code;
  for (const auto& page : pages_) {
    if (page) std::fill(page->depth.begin(), page->depth.end(), code);
  }
}

core::FrameBuffer PagedBuffer::whole() const {
  core::FrameBuffer buffer;
  buffer.width = width_;
  buffer.height = height_;
  buffer.channels = channels_;
  buffer.clear_depth = clear_depth_;
  buffer.clear();
  std::fill(buffer.depth.begin(), buffer.depth.end(), cleared_to_);
  const auto channels = static_cast<size_t>(channels_);
  for (const Page* page : pages()) {
    const auto columns = static_cast<size_t>(std::min(kSide, width_ - page->x));
    for (int row = 0; row < std::min(kSide, height_ - page->y); ++row) {
      const size_t from = place_of(0, row);
      const size_t to = buffer.index(page->x, page->y + row);
      std::copy_n(&page->depth[from], columns, &buffer.depth[to]);
      std::copy_n(&page->hits[from], columns, &buffer.hits[to]);
      std::copy_n(page->color.data() + from * channels, columns * channels,
                  buffer.color.data() + to * channels);
    }
  }
  return buffer;
}

std::vector<const PagedBuffer::Page*> PagedBuffer::pages() const {
  std::vector<const Page*> all;
  for (const auto& page : pages_) {
    if (page) all.push_back(page.get());
  }
  return all;
}

}  // namespace pineda::tb
