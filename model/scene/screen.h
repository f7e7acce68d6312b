// Triangles after the viewport transform and before snapping, as in .tri and .ptrb files.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "model/scene/source.h"

namespace pineda::scene {

/// x, y in px, y down; z in [0, 1]; the clip-space w; colour, not premultiplied.
struct ScreenVertex {
  float x = 0;
  float y = 0;
  float z = 0;
  float w = 1;
  std::array<uint8_t, 4> rgba{};
};

struct ScreenTriangle {
  uint32_t id = 0;
  std::array<ScreenVertex, 3> v;
};

/// A pull stream of screen triangles. It counts the triangles that it reads, clips and drops.
class ScreenReader {
 public:
  virtual ~ScreenReader() = default;
  virtual bool read(ScreenTriangle* triangle, Counters* counters) = 0;
  /// Up to `count` triangles, as read() would give them one by one; fewer only at the end.
  virtual size_t read_many(ScreenTriangle* triangles, size_t count, Counters* counters) {
    size_t filled = 0;
    while (filled < count && read(&triangles[filled], counters)) ++filled;
    return filled;
  }
  virtual void rewind() = 0;

  /// Triangles of the scene, if that is known without reading it.
  virtual std::optional<uint64_t> size() const { return std::nullopt; }
  /// Bytes of a stream of triangles, which is read while they are drawn; none of other scenes.
  virtual std::optional<uint64_t> stream_bytes() const { return std::nullopt; }
  /// Skips a number of triangles, after discarding the remaining pieces of the current one. Skipped
  /// triangles are not counted, and read only as far as needed to find the next one. Returns how
  /// many were skipped: fewer at the end. This default is for readers that give no pieces.
  virtual uint64_t skip(uint64_t triangles) {
    Counters none;
    ScreenTriangle triangle;
    uint64_t skipped = 0;
    while (skipped < triangles && read(&triangle, &none)) ++skipped;
    return skipped;
  }
};

/// Reads screen triangles from memory.
class ListReader final : public ScreenReader {
 public:
  explicit ListReader(std::vector<ScreenTriangle> triangles) : triangles_(std::move(triangles)) {}

  bool read(ScreenTriangle* triangle, Counters* counters) override {
    if (next_ == triangles_.size()) return false;
    ++counters->triangles;
    *triangle = triangles_[next_++];
    for (const ScreenVertex& v : triangle->v) {
      counters->perspective += v.w != 1 && !std::isnan(v.w) ? 1 : 0;
    }
    return true;
  }
  void rewind() override { next_ = 0; }
  std::optional<uint64_t> size() const override { return triangles_.size(); }
  uint64_t skip(uint64_t triangles) override {
    const uint64_t skipped = std::min<uint64_t>(triangles, triangles_.size() - next_);
    next_ += skipped;
    return skipped;
  }

 private:
  std::vector<ScreenTriangle> triangles_;
  size_t next_ = 0;
};

}  // namespace pineda::scene
