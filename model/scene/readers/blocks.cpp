#include "model/scene/readers/blocks.h"

#include <cstring>

namespace pineda::scene {
namespace {

constexpr size_t kBlock = size_t{1} << 16;

}  // namespace

bool BlockReader::read_more() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), data(), size());
    end_ -= begin_;
    begin_ = 0;
  }
  if (buffer_.size() < end_ + kBlock) buffer_.resize(2 * end_ + kBlock);
  stream_->read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  const auto count = static_cast<size_t>(stream_->gcount());
  end_ += count;
  return count > 0;
}

bool BlockReader::rewind() {
  stream_->clear();
  begin_ = end_ = 0;
  return static_cast<bool>(stream_->seekg(0));
}

}  // namespace pineda::scene
