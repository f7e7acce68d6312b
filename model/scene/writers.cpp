#include "model/scene/writers.h"

#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "model/files/unfinished.h"
#include "model/scene/error.h"

namespace pineda::scene {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kNearestGrey = 255;
constexpr uint32_t kFarthestGrey = 40;  // still visible against the black background

[[noreturn]] void fail_to_write(const std::string& path) {
  throw InputError(path, fmt::format("expected to write it, got: {}", std::strerror(errno)));
}

// A file under a temporary name, which is removed unless commit() renames it.
class PendingFile {
 public:
  explicit PendingFile(const std::string& path)
      : path_(path),
        temporary_(fmt::format("{}.partial-{}", path, ::getpid())),
        unfinished_(temporary_) {
    file_ = std::fopen(temporary_.c_str(), "wb");
    if (file_ == nullptr) fail_to_write(path_);
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (!done_) std::remove(temporary_.c_str());
  }

  void write(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail_to_write(path_);
  }

  void commit() {
    FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail_to_write(path_);
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail_to_write(path_);
    done_ = true;
  }

 private:
  std::string path_;
  std::string temporary_;
  files::Unfinished unfinished_;
  FILE* file_ = nullptr;
  bool done_ = false;
};

void write_through(const std::string& path, std::string_view bytes) {
  FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) fail_to_write(path);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  if (std::fclose(file) != 0 || !written) fail_to_write(path);
}

void write_png(const std::string& path, int width, int height, png_uint_32 format,
               const std::vector<uint8_t>& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  std::string bytes;
  png_alloc_size_t size = 0;
  // The first call only asks for the size.
  if (png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr) != 0) {
    bytes.resize(size);
    png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  }
  if (PNG_IMAGE_FAILED(image)) {
    throw InputError(path, fmt::format("expected to write it, got: {}", image.message));
  }
  bytes.resize(size);
  write_file(path, bytes);
}

size_t samples(const Frame& frame) {
  return static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
}

// Channel `channel` of a sample in 8 bits.
uint8_t channel_of(const Frame& frame, size_t sample, size_t channel) {
  const auto attributes = static_cast<size_t>(frame.attributes);
  if (channel >= attributes) return channel == 3 ? 255 : 0;
  const uint32_t greatest = (1u << frame.attribute_bits) - 1;
  const uint32_t value = frame.color[sample * attributes + channel];
  return static_cast<uint8_t>((2 * 255 * value + greatest) / (2 * greatest));
}

std::vector<uint8_t> channels(const Frame& frame, size_t count) {
  std::vector<uint8_t> bytes;
  bytes.reserve(samples(frame) * count);
  for (size_t i = 0; i < samples(frame); ++i) {
    for (size_t k = 0; k < count; ++k) bytes.push_back(channel_of(frame, i, k));
  }
  return bytes;
}

std::string_view view_of(const std::vector<uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class Word>
std::vector<uint8_t> little_endian(const std::vector<Word>& words) {
  std::vector<uint8_t> bytes;
  bytes.reserve(words.size() * sizeof(Word));
  for (const Word word : words) {
    for (size_t i = 0; i < sizeof(Word); ++i) bytes.push_back(static_cast<uint8_t>(word >> 8 * i));
  }
  return bytes;
}

}  // namespace

void write_file(const std::string& path, std::string_view bytes) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) {
    throw InputError(folder.string(), "expected to make the folder, got: " + error.message());
  }
  // Of a symbolic link the target file is replaced, not the link. Devices, pipes and open streams
  // (/dev/stdout) must not be replaced by a file, so they are written to directly.
  const fs::file_status status = fs::status(path, error);
  const bool special = path.rfind("/dev/", 0) == 0 || path.rfind("/proc/", 0) == 0;
  if (special || (fs::exists(status) && !fs::is_regular_file(status))) {
    write_through(path, bytes);
    return;
  }
  const fs::path place = fs::canonical(path, error);
  PendingFile file(error ? path : place.string());
  file.write(bytes);
  file.commit();
}

void write_rgb_png(const std::string& path, int width, int height,
                   const std::vector<uint8_t>& rgb) {
  if (rgb.size() != 3 * static_cast<size_t>(width) * static_cast<size_t>(height)) {
    throw std::invalid_argument(
        fmt::format("write_rgb_png: {} bytes for {} x {} pixels", rgb.size(), width, height));
  }
  write_png(path, width, height, PNG_FORMAT_RGB, rgb);
}

void write_color_png(const std::string& path, const Frame& frame) {
  write_rgb_png(path, frame.width, frame.height, channels(frame, 3));
}

void write_depth_png(const std::string& path, const Frame& frame) {
  uint32_t least = UINT32_MAX;
  uint32_t greatest = 0;
  for (const uint32_t code : frame.depth) {
    if (code == frame.clear_depth) continue;
    least = std::min(least, code);
    greatest = std::max(greatest, code);
  }
  // If there is only one depth it is shown as the nearest.
  const uint64_t range = greatest > least ? greatest - least : 1;
  const bool is_reversed = frame.clear_depth == 0;
  std::vector<uint8_t> grey;
  grey.reserve(frame.depth.size());
  for (const uint32_t code : frame.depth) {
    const uint64_t behind = is_reversed ? greatest - code : code - least;
    const uint64_t dark = (kNearestGrey - kFarthestGrey) * behind;
    grey.push_back(code == frame.clear_depth ? uint8_t{0}
                                             : static_cast<uint8_t>(kNearestGrey - dark / range));
  }
  write_png(path, frame.width, frame.height, PNG_FORMAT_GRAY, grey);
}

void write_dump(const std::string& folder, const Frame& frame) {
  const fs::path at(folder);
  const std::string hits = (at / "hits.u16").string();
  if (frame.hits.empty()) {
    std::error_code error;
    fs::remove(hits, error);
    if (error) throw InputError(hits, "expected to remove it, got: " + error.message());
  } else {
    write_file(hits, view_of(little_endian(frame.hits)));
  }
  write_file((at / "depth.u32").string(), view_of(little_endian(frame.depth)));
  write_file((at / "color.rgba").string(), view_of(channels(frame, 4)));
}

}  // namespace pineda::scene
