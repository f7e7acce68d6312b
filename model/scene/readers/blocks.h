// Reads the bytes of a stream in blocks.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <vector>

namespace pineda::scene {

/// Memory is bounded by the longest run of bytes that the caller needs at once, not by the file.
class BlockReader {
 public:
  explicit BlockReader(std::unique_ptr<std::istream> stream) : stream_(std::move(stream)) {}

  /// The bytes that were read but not taken yet.
  const char* data() const { return buffer_.data() + begin_; }
  size_t size() const { return end_ - begin_; }
  /// Reads another block; data() may move. False at the end of the file.
  bool read_more();
  void take(size_t count) { begin_ += count; }

  /// Takes the next `count` bytes; they are valid until the next call of any member. nullptr if the
  /// file has fewer.
  const char* take_all(size_t count) {
    while (size() < count) {
      if (!read_more()) return nullptr;
    }
    begin_ += count;
    return buffer_.data() + begin_ - count;
  }

  /// True if reading stopped because of an error.
  bool is_bad() const { return stream_->bad(); }
  /// Starts again at the beginning; false if the stream cannot seek.
  bool rewind();

 private:
  std::unique_ptr<std::istream> stream_;
  std::vector<char> buffer_;
  size_t begin_ = 0, end_ = 0;  // range of the buffer with bytes not taken yet
};

}  // namespace pineda::scene
