#include "model/scene/readers/ptrb_reader.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

constexpr size_t kBufferTriangles = 1024;

uint32_t u32_at(const unsigned char* p) {
  return static_cast<uint32_t>(p[0]) | static_cast<uint32_t>(p[1]) << 8 |
         static_cast<uint32_t>(p[2]) << 16 | static_cast<uint32_t>(p[3]) << 24;
}

float f32_at(const unsigned char* p) {
  const uint32_t bits = u32_at(p);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Reads up to `count` bytes; fewer only at the end of the stream.
size_t read_bytes(std::istream& stream, const std::string& file, unsigned char* to, size_t count) {
  stream.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count));
  if (stream.bad()) throw InputError(file, "expected more bytes, got a read error");
  return static_cast<size_t>(stream.gcount());
}

using HeaderBytes = std::array<unsigned char, PtrbHeader::kBytes>;

HeaderBytes read_header(std::istream& stream, const std::string& file) {
  HeaderBytes bytes{};
  const size_t got = read_bytes(stream, file, bytes.data(), bytes.size());
  if (got < bytes.size()) {
    throw InputError(file, fmt::format("expected a header of {} bytes, got {}", bytes.size(), got));
  }
  return bytes;
}

spec::FrameState parse_state(const std::string& file, uint32_t width, uint32_t height,
                             uint32_t flags, int guard_bits) {
  const uint32_t greatest = 1u << guard_bits;
  if (width < 1 || width > greatest || height < 1 || height > greatest) {
    throw InputError(file, fmt::format("expected a size of 1x1 to {0}x{0}, got {1}x{2}", greatest,
                                       width, height));
  }
  const uint32_t cull = flags >> 1 & 3;
  const uint32_t depth = flags >> 3 & 3;
  if (flags >> 5 != 0 || cull == 3 || depth == 3) {
    throw InputError(file, fmt::format("expected flags with bits 0-4 only, cull 0-2 and depth 0-2, "
                                       "got 0x{:x}",
                                       flags));
  }
  spec::FrameState frame;
  frame.width = static_cast<int>(width);
  frame.height = static_cast<int>(height);
  frame.cull = static_cast<spec::Cull>(cull);
  frame.depth = static_cast<spec::DepthFunc>(depth);
  return frame;
}

PtrbHeader parse_header(const spec::Contract& contract, const std::string& file,
                        const HeaderBytes& bytes) {
  if (std::memcmp(bytes.data(), "PTRB", 4) != 0) {
    throw InputError(file, "expected the bytes 'PTRB' at the start");
  }
  const uint32_t version = u32_at(&bytes[4]);
  if (version != 1) throw InputError(file, fmt::format("expected version 1, got {}", version));
  const uint32_t flags = u32_at(&bytes[16]);
  PtrbHeader header;
  header.frame =
      parse_state(file, u32_at(&bytes[8]), u32_at(&bytes[12]), flags, contract.design.guard_bits);
  header.has_w = (flags & 1) != 0;
  header.triangles = u32_at(&bytes[20]) | static_cast<uint64_t>(u32_at(&bytes[24])) << 32;
  // A triangle's number has 32 bits.
  if (header.triangles > uint64_t{1} << spec::kTriangleIdBits) {
    throw InputError(file,
                     fmt::format("expected at most 2^32 triangles, got {}", header.triangles));
  }
  return header;
}

}  // namespace

PtrbReader::PtrbReader(const spec::Contract& contract, const std::string& file,
                       std::shared_ptr<std::istream> stream, std::optional<uint64_t> bytes)
    : file_(file), stream_(std::move(stream)), can_rewind_(bytes.has_value()) {
  header_ = parse_header(contract, file_, read_header(*stream_, file_));
  if (bytes && *bytes != header_.file_bytes()) {
    throw InputError(file_, fmt::format("expected {} bytes for {} triangles, got {}",
                                        header_.file_bytes(), header_.triangles, *bytes));
  }
}

void PtrbReader::rewind() {
  stream_->clear();
  if (!can_rewind_ || !stream_->seekg(PtrbHeader::kBytes)) {
    throw InputError(file_, "expected a file that can be read twice, got a pipe");
  }
  next_ = 0;
  position_ = 0;
  buffer_.clear();
}

void PtrbReader::refill() {
  const uint64_t triangles = std::min<uint64_t>(header_.triangles - next_, kBufferTriangles);
  const size_t wanted = static_cast<size_t>(triangles) * header_.triangle_bytes();
  buffer_.resize(wanted);
  const size_t got = read_bytes(*stream_, file_, buffer_.data(), wanted);
  if (got < wanted) {
    throw InputError(file_, fmt::format("expected {} triangles, got {}", header_.triangles,
                                        next_ + got / header_.triangle_bytes()));
  }
  position_ = 0;
}

void PtrbReader::check_end() {
  // If the length is known this was checked at the start.
  if (!can_rewind_ && stream_->peek() != std::istream::traits_type::eof()) {
    throw InputError(file_,
                     fmt::format("expected {} triangles, got bytes after them", header_.triangles));
  }
}

void PtrbReader::refuse_w(float w, uint64_t triangle, size_t corner) const {
  throw InputError(file_, fmt::format("triangle {} vertex {}: expected W > 0, neither denormal nor "
                                      "infinite, got {}",
                                      triangle, corner, w));
}

// Decodes triangles from the buffer, which has as many.
template <bool HasW>
void PtrbReader::decode(size_t count, ScreenTriangle* triangles, Counters* counters) {
  const unsigned char* p = &buffer_[position_];
  uint64_t perspective = 0;
  for (size_t i = 0; i < count; ++i) {
    ScreenTriangle& triangle = triangles[i];
    triangle.id = static_cast<uint32_t>(next_ + i);
    for (size_t corner = 0; corner < 3; ++corner) {
      ScreenVertex& v = triangle.v[corner];
      v.x = f32_at(p);
      v.y = f32_at(p + 4);
      v.z = f32_at(p + 8);
      v.w = HasW ? f32_at(p + 12) : 1;
      p += HasW ? 16 : 12;
      if (HasW && !(std::isnormal(v.w) && v.w > 0) && !std::isnan(v.w)) {
        refuse_w(v.w, next_ + i, corner);
      }
      perspective += v.w != 1 && !std::isnan(v.w) ? 1 : 0;
      std::memcpy(v.rgba.data(), p, v.rgba.size());
      p += v.rgba.size();
    }
  }
  next_ += count;
  position_ += count * header_.triangle_bytes();
  counters->perspective += perspective;
  counters->triangles += count;
}

size_t PtrbReader::read_many(ScreenTriangle* triangles, size_t count, Counters* counters) {
  size_t filled = 0;
  while (filled < count) {
    if (next_ == header_.triangles) {
      check_end();
      break;
    }
    if (position_ == buffer_.size()) refill();
    const size_t now =
        std::min(count - filled, (buffer_.size() - position_) / header_.triangle_bytes());
    if (header_.has_w) {
      decode<true>(now, &triangles[filled], counters);
    } else {
      decode<false>(now, &triangles[filled], counters);
    }
    filled += now;
  }
  return filled;
}

// The stream's own ignore() takes byte by byte from standard input.
void PtrbReader::discard(uint64_t bytes) {
  if (bytes == 0) return;
  buffer_.resize(kBufferTriangles * header_.triangle_bytes());
  position_ = buffer_.size();
  for (size_t got = buffer_.size(); bytes > 0 && got == buffer_.size(); bytes -= got) {
    got = read_bytes(*stream_, file_, buffer_.data(), std::min<uint64_t>(bytes, buffer_.size()));
  }
}

uint64_t PtrbReader::skip(uint64_t triangles) {
  const uint64_t skipped = std::min(triangles, header_.triangles - next_);
  const uint64_t buffered =
      std::min<uint64_t>(skipped, (buffer_.size() - position_) / header_.triangle_bytes());
  position_ += static_cast<size_t>(buffered) * header_.triangle_bytes();
  const uint64_t bytes = (skipped - buffered) * header_.triangle_bytes();
  if (can_rewind_) {
    stream_->seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
  } else {
    discard(bytes);  // reading the next triangle reports a premature end
  }
  next_ += skipped;
  return skipped;
}

std::shared_ptr<std::istream> spool_ptrb(const spec::Contract& contract, const std::string& file,
                                         std::istream& stream, uint64_t* bytes) {
  const HeaderBytes header = read_header(stream, file);
  const uint64_t wanted = parse_header(contract, file, header).file_bytes() + 1;

  std::string path = (std::filesystem::temp_directory_path() / "pineda-XXXXXX").string();
  const int descriptor = mkstemp(path.data());
  if (descriptor < 0) throw InputError(path, "expected to make a temporary file");
  auto spool = std::make_shared<std::fstream>(
      path, std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc);
  ::unlink(path.c_str());  // the file exists until the stream is closed
  ::close(descriptor);

  spool->write(reinterpret_cast<const char*>(header.data()), header.size());
  *bytes = header.size();
  std::vector<unsigned char> buffer(1 << 16);
  while (*bytes < wanted) {
    const size_t count =
        read_bytes(stream, file, buffer.data(), std::min<uint64_t>(buffer.size(), wanted - *bytes));
    if (count == 0) break;
    spool->write(reinterpret_cast<const char*>(buffer.data()), static_cast<std::streamsize>(count));
    *bytes += count;
  }
  spool->seekg(0);
  if (!*spool) throw InputError(path, "expected room for a temporary copy of the scene");
  return spool;
}

}  // namespace pineda::scene
