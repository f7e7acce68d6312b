// Reader of .ptrb, a binary format for streams of triangles after the viewport transform.
#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/screen.h"

namespace pineda::scene {

/// The contents of the 28-byte header.
struct PtrbHeader {
  spec::FrameState frame;
  bool has_w = false;
  uint64_t triangles = 0;

  static constexpr size_t kBytes = 28;
  size_t triangle_bytes() const { return has_w ? 60 : 48; }
  uint64_t file_bytes() const { return kBytes + triangles * triangle_bytes(); }
};

/// Reads many triangles at once, in bounded memory whatever the count.
///
/// In       a stream at its first byte. With `bytes`, its length, the count is checked at once and
///          rewind() works. Without it the stream is a pipe: a wrong count is found at its end, and
///          rewind() throws.
/// Errors   InputError: wrong magic, version, flags, size or count; W not positive and normal.
class PtrbReader final : public ScreenReader {
 public:
  PtrbReader(const spec::Contract& contract, const std::string& file,
             std::shared_ptr<std::istream> stream, std::optional<uint64_t> bytes);

  const spec::FrameState& frame() const { return header_.frame; }
  bool read(ScreenTriangle* triangle, Counters* counters) override {
    return read_many(triangle, 1, counters) == 1;
  }
  size_t read_many(ScreenTriangle* triangles, size_t count, Counters* counters) override;
  void rewind() override;
  std::optional<uint64_t> size() const override { return header_.triangles; }
  std::optional<uint64_t> stream_bytes() const override { return header_.file_bytes(); }
  /// Seeks if the stream is a file.
  uint64_t skip(uint64_t triangles) override;

 private:
  void refill();
  void check_end();
  void discard(uint64_t bytes);
  template <bool HasW>
  void decode(size_t count, ScreenTriangle* triangles, Counters* counters);
  [[noreturn]] void refuse_w(float w, uint64_t triangle, size_t corner) const;

  std::string file_;
  std::shared_ptr<std::istream> stream_;
  bool can_rewind_;
  PtrbHeader header_;
  uint64_t next_ = 0;                  // number of the next triangle
  std::vector<unsigned char> buffer_;  // whole triangles
  size_t position_ = 0;                // of the next triangle in buffer_
};

/// Copies a .ptrb from a pipe into an unnamed temporary file, so that it can be read several times
/// in bounded memory. Copies at most one byte more than the header states.
/// Out      the file, at its first byte; *bytes = its length.
std::shared_ptr<std::istream> spool_ptrb(const spec::Contract& contract, const std::string& file,
                                         std::istream& stream, uint64_t* bytes);

}  // namespace pineda::scene
