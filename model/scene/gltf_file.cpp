#include "model/scene/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <sstream>

#include "model/scene/error.h"
#include "model/scene/gltf_guard.h"
#include "model/scene/lines.h"

namespace pineda::scene {
namespace {

constexpr const char* kMagic = "glTF";
constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr uint32_t kVersion = 2, kJsonChunk = 0x4E4F534A;

std::string read_bytes(const std::string& file) {
  std::ostringstream bytes;
  const auto stream = open_file(file);
  if (stream->peek() != std::istream::traits_type::eof()) bytes << stream->rdbuf();
  if (stream->bad() || !bytes) throw InputError(file, "expected more bytes, got a read error");
  std::string all = bytes.str();
  if (all.size() > std::numeric_limits<uint32_t>::max()) {
    throw InputError(file, "expected less than 4 GiB");
  }
  return all;
}

uint32_t u32(const std::string& bytes, size_t at) {
  uint32_t value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// The JSON chunk of a GLB whose chunks fill it.
std::string json_of_glb(const std::string& file, const std::string& bytes) {
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
  for (size_t at = kHeaderBytes; at < bytes.size();) {
    const size_t left = bytes.size() - at;
    if (left < kChunkHeaderBytes || u32(bytes, at) > left - kChunkHeaderBytes) {
      throw InputError(file, fmt::format("byte {}: expected a chunk inside of the file", at));
    }
    at += kChunkHeaderBytes + u32(bytes, at);
  }
  return bytes.substr(kFirst, u32(bytes, kHeaderBytes));
}

bool leave_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                 const unsigned char*, int, void*) {
  return true;
}

// Nothing but files: reading a pipe or a device need not end.
bool is_file(const std::string& path, void*) {
  std::error_code none;
  return std::filesystem::is_regular_file(path, none);
}

// A URI is taken literally, "~" and "$" too.
std::string same_path(const std::string& path, void*) { return path; }

bool load(const std::string& file, const std::string& bytes, bool is_glb, tinygltf::Model* model,
          std::string* error) {
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(leave_image, nullptr);
  tinygltf::FsCallbacks files{};
  files.FileExists = is_file;
  files.ExpandFilePath = same_path;
  files.ReadWholeFile = tinygltf::ReadWholeFile;
  files.WriteWholeFile = tinygltf::WriteWholeFile;
  loader.SetFsCallbacks(files);
  const auto folder = std::filesystem::path(file).parent_path().string();
  const auto size = static_cast<unsigned>(bytes.size());
  std::string warning;  // about images only
  if (!is_glb) {
    return loader.LoadASCIIFromString(model, error, &warning, bytes.data(), size, folder);
  }
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  return loader.LoadBinaryFromMemory(model, error, &warning, data, size, folder);
}

std::string first_line(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return line.size() > 120 ? line.substr(0, 120) + "..." : line;
}

}  // namespace

tinygltf::Model load_gltf(const std::string& file) {
  const std::string bytes = read_bytes(file);
  const bool is_glb = bytes.compare(0, std::strlen(kMagic), kMagic) == 0;
  guard_gltf(file, is_glb ? json_of_glb(file, bytes) : bytes);
  tinygltf::Model model;
  std::string error;
  bool is_loaded = false;
  try {
    is_loaded = load(file, bytes, is_glb, &model, &error);
  } catch (const std::exception& unforeseen) {
    error = unforeseen.what();
  }
  if (!is_loaded || !error.empty()) {
    throw InputError(file, "expected a glTF 2.0 file, got: " + first_line(error));
  }
  return model;
}

}  // namespace pineda::scene
