#include "studies/judge/frame_dump.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "model/scene/error.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

/// Calls take(sample, bytes) for each sample of a file; false if there is no such file.
template <class Take>
bool read_samples(const fs::path& path, size_t samples, size_t bytes, Take&& take) {
  std::error_code error;
  if (!fs::exists(path, error)) return false;
  const uintmax_t size = fs::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) {
    throw scene::InputError(path.string(), "expected a file of a frame, cannot read it");
  }
  if (size != samples * bytes) {
    throw scene::InputError(path.string(), fmt::format("expected {} bytes, {} for each of {} "
                                                       "samples, got {}",
                                                       samples * bytes, bytes, samples, size));
  }
  std::vector<uint8_t> buffer(samples * bytes);
  file.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(buffer.size()));
  if (!file) throw scene::InputError(path.string(), "expected a file of a frame, cannot read it");
  for (size_t i = 0; i < samples; ++i) take(i, &buffer[i * bytes]);
  return true;
}

}  // namespace

FrameDump read_dump(const std::string& folder, int width, int height) {
  const size_t samples = static_cast<size_t>(width) * static_cast<size_t>(height);
  FrameDump dump;
  dump.hits.emplace(samples);
  dump.depth.emplace(samples);
  dump.color.emplace(samples);
  const fs::path place(folder);
  if (!read_samples(place / "hits.u16", samples, 2, [&](size_t i, const uint8_t* bytes) {
        (*dump.hits)[i] = static_cast<uint16_t>(bytes[0] | bytes[1] << 8);
      })) {
    dump.hits.reset();
  }
  if (!read_samples(place / "depth.u32", samples, 4, [&](size_t i, const uint8_t* bytes) {
        (*dump.depth)[i] = bytes[0] | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 |
                           uint32_t{bytes[3]} << 24;
      })) {
    dump.depth.reset();
  }
  if (!read_samples(place / "color.rgba", samples, 4, [&](size_t i, const uint8_t* bytes) {
        std::copy_n(bytes, 4, (*dump.color)[i].begin());
      })) {
    dump.color.reset();
  }
  if (!dump.hits && !dump.depth && !dump.color) {
    throw scene::InputError(folder, "expected hits.u16, depth.u32 or color.rgba, there is none");
  }
  return dump;
}

}  // namespace pineda::studies
