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

ScreenVertex PtrbReader::vertex(const unsigned char* bytes, size_t corner,
                                Counters* counters) const {
  const size_t vertex_bytes = header_.triangle_bytes() / 3;
  const unsigned char* p = bytes + corner * vertex_bytes;
  ScreenVertex v;
  v.x = f32_at(p);
  v.y = f32_at(p + 4);
  v.z = f32_at(p + 8);
  if (header_.has_w) v.w = f32_at(p + 12);
  if (!std::isnan(v.w) && !(std::isnormal(v.w) && v.w > 0)) {
    throw InputError(file_, fmt::format("triangle {} vertex {}: expected W > 0, neither denormal "
                                        "nor infinite, got {}",
                                        next_, corner, v.w));
  }
  counters->perspective += v.w != 1 && !std::isnan(v.w) ? 1 : 0;
  std::copy_n(p + vertex_bytes - 4, 4, v.rgba.begin());
  return v;
}

bool PtrbReader::read(ScreenTriangle* triangle, Counters* counters) {
  if (next_ == header_.triangles) {
    check_end();
    return false;
  }
  if (position_ == buffer_.size()) refill();
  for (size_t i = 0; i < 3; ++i) triangle->v[i] = vertex(&buffer_[position_], i, counters);
  position_ += header_.triangle_bytes();
  triangle->id = static_cast<uint32_t>(next_++);
  ++counters->triangles;
  return true;
}

uint64_t PtrbReader::skip(uint64_t triangles) {
  const uint64_t skipped = std::min(triangles, header_.triangles - next_);
  const uint64_t buffered =
      std::min<uint64_t>(skipped, (buffer_.size() - position_) / header_.triangle_bytes());
  position_ += static_cast<size_t>(buffered) * header_.triangle_bytes();
  const auto bytes = static_cast<std::streamsize>((skipped - buffered) * header_.triangle_bytes());
  if (can_rewind_) {
    stream_->seekg(bytes, std::ios::cur);
  } else {
    stream_->ignore(bytes);  // reading the next triangle reports a premature end
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
