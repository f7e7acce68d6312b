#include "model/scene/readers/gltf/data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "model/scene/error.h"
#include "model/scene/readers/gltf/data_uri.h"
#include "model/scene/readers/lines.h"

namespace pineda::scene {
namespace {

constexpr const char* kMagic = "glTF";
constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr uint32_t kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr uint64_t kGreatestBytes = std::numeric_limits<uint32_t>::max();

std::string read_bytes(const std::string& file) {
  constexpr size_t kBlock = size_t{1} << 20;
  const auto stream = open_file(file);
  const auto check_size = [&](uint64_t size) {
    if (size > kGreatestBytes) throw InputError(file, "expected less than 4 GiB");
  };
  std::string all;
  std::error_code none;
  const auto size = std::filesystem::file_size(file, none);
  if (!none) {  // a pipe or a device has no size and may be endless
    check_size(size);
    all.reserve(size + kBlock);
  }
  while (*stream) {
    const size_t before = all.size();
    all.resize(before + kBlock);
    stream->read(&all[before], kBlock);
    all.resize(before + static_cast<size_t>(stream->gcount()));
    check_size(all.size());
  }
  if (stream->bad()) throw InputError(file, "expected more bytes, got a read error");
  return all;
}

uint32_t u32(std::string_view bytes, size_t at) {
  uint32_t value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

struct Chunks {
  std::string_view json;
  std::optional<std::string_view> binary;  // the second chunk, if its type is BIN
};

// The chunks of a GLB, which must fill the file.
Chunks chunks_of(const std::string& file, std::string_view bytes) {
  constexpr size_t kFirst = kHeaderBytes + kChunkHeaderBytes;
  if (bytes.size() < kFirst) throw InputError(file, "expected the header of a GLB and of a chunk");
  if (u32(bytes, 4) != kVersion) {
    throw InputError(file, fmt::format("expected GLB version 2, got {}", u32(bytes, 4)));
  }
  if (u32(bytes, 8) != bytes.size()) {
    throw InputError(file, fmt::format("expected {} bytes, as the header of the GLB says, got {}",
                                       u32(bytes, 8), bytes.size()));
  }
  if (u32(bytes, 16) != kJsonChunk) throw InputError(file, "expected a first chunk of JSON");
  Chunks chunks;
  int index = 0;
  for (size_t at = kHeaderBytes; at < bytes.size(); ++index) {
    const size_t left = bytes.size() - at;
    if (left < kChunkHeaderBytes || u32(bytes, at) > left - kChunkHeaderBytes) {
      throw InputError(file, fmt::format("byte {}: expected a chunk inside of the file", at));
    }
    const std::string_view chunk = bytes.substr(at + kChunkHeaderBytes, u32(bytes, at));
    if (index == 0) chunks.json = chunk;
    if (index == 1 && u32(bytes, at + 4) == kBinaryChunk) chunks.binary = chunk;
    at += kChunkHeaderBytes + chunk.size();
  }
  return chunks;
}

}  // namespace

GltfData::GltfData(const std::string& file) : file_(file), bytes_(read_bytes(file)) {
  Chunks chunks{bytes_, {}};
  const bool is_glb = bytes_.compare(0, std::strlen(kMagic), kMagic) == 0;
  if (is_glb) chunks = chunks_of(file, bytes_);
  Json json = parse_json(file, chunks.json);
  chunk_ = chunks.binary;
  if (!is_glb) std::string().swap(bytes_);
  document_ = read_document(file, &json);
  buffers_.resize(document_.buffers.size());
  is_used_.resize(document_.accessors.size());
}

bool GltfData::is_first_use(size_t accessor) {
  const bool is_first = !is_used_[accessor];
  is_used_[accessor] = true;
  return is_first;
}

std::string_view GltfData::buffer(int i) {
  const auto at = static_cast<size_t>(i);
  if (at >= buffers_.size()) {
    throw InputError(file_, fmt::format("buffers[{}]: expected one of {}", i, buffers_.size()));
  }
  const GltfBuffer& buffer = document_.buffers[at];
  const bool is_chunk = at == 0 && !buffer.uri && chunk_;
  if (!is_chunk && !buffers_[at]) {
    loaded_bytes_ += buffer.bytes;
    if (loaded_bytes_ > kGreatestBytes) throw InputError(file_, "expected buffers below 4 GiB");
    buffers_[at] = load(at, buffer);
  }
  const std::string_view all = is_chunk ? *chunk_ : static_cast<std::string_view>(*buffers_[at]);
  if (all.size() < buffer.bytes) {
    throw InputError(file_,
                     fmt::format("buffers[{}]: expected {} bytes, as byteLength says, got {}", i,
                                 buffer.bytes, all.size()));
  }
  return all.substr(0, buffer.bytes);
}

std::string GltfData::load(size_t i, const GltfBuffer& buffer) const {
  const std::string where = fmt::format("buffers[{}].uri", i);
  if (!buffer.uri) {
    throw InputError(file_, where + ": expected a URI, or a first buffer in the GLB's BIN chunk");
  }
  std::optional<std::string> bytes;
  if (!read_data_uri(*buffer.uri, &bytes)) return load_file(where, *buffer.uri, buffer.bytes);
  if (!bytes) throw InputError(file_, where + ": expected base64 data, got other characters");
  return std::move(*bytes);
}

// Only regular files are read: a pipe or a device may be endless.
std::string GltfData::load_file(const std::string& where, const std::string& uri,
                                size_t bytes) const {
  const std::string name = percent_decoded(uri);
  const auto fail = [&](const char* expected) {
    throw InputError(file_, fmt::format("{}: expected {}, got {}", where, expected, quoted(uri)));
  };
  const std::filesystem::path path(name);
  if (name.empty() || path.is_absolute() || name.find('\0') != std::string::npos) {
    fail("a path relative to the file");
  }
  const auto full = (std::filesystem::path(file_).parent_path() / path).string();
  std::error_code none;
  if (!std::filesystem::is_regular_file(full, none)) fail("a file to read");
  const auto stream = open_file(full);
  const auto size = std::filesystem::file_size(full, none);
  if (none) fail("a file to read");
  std::string content(std::min<uint64_t>(bytes, size), '\0');
  stream->read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<size_t>(stream->gcount()));
  return content;
}

}  // namespace pineda::scene
