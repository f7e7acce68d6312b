// The bytes of a file in order, read in blocks.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <vector>

namespace pineda::scene {

/// Memory grows with the longest run of bytes that is asked for, never with the file.
class BlockReader {
 public:
  explicit BlockReader(std::unique_ptr<std::istream> stream) : stream_(std::move(stream)) {}

  /// What was read and not taken yet.
  const char* data() const { return buffer_.data() + begin_; }
  size_t size() const { return end_ - begin_; }
  /// Reads on; data() may move. False at the end of the file.
  bool read_more();
  void take(size_t count) { begin_ += count; }

  /// Takes the next bytes, which stay where they are until the next call of anything here; nullptr
  /// if the file ends before.
  const char* take_all(size_t count) {
    while (size() < count) {
      if (!read_more()) return nullptr;
    }
    begin_ += count;
    return buffer_.data() + begin_ - count;
  }

  /// The end of the file was an error of reading.
  bool is_bad() const { return stream_->bad(); }
  /// Starts again; false if the stream cannot.
  bool rewind();

 private:
  std::unique_ptr<std::istream> stream_;
  std::vector<char> buffer_;
  size_t begin_ = 0, end_ = 0;  // what is in the buffer
};

}  // namespace pineda::scene
