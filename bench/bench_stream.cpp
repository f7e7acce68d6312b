// Writes a .ptrb of random triangles of 1 px on 1920x1080, or of a mesh many times, to standard output,
// for measuring how quickly streams are read: the same bytes on every machine.
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "bench/scenes.h"
#include "model/scene/builtin/builtin.h"
#include "model/scene/error.h"
#include "model/spec/random.h"

namespace pineda::scene {
namespace {

constexpr uint64_t kWidth = 1920;
constexpr uint64_t kHeight = 1080;
constexpr size_t kTriangleBytes = 48;
constexpr size_t kBufferTriangles = 1365;  // nearly 64 KB, what a pipe holds
constexpr int kFractionBits = 10;          // of a coordinate: a binary32 holds it exactly

// Corners as offsets from a place, in units of 2^-10 px.
using Shape = std::array<std::array<int32_t, 2>, 3>;

std::vector<Shape> random_shapes(int count) {
  std::vector<Shape> shapes;
  for (const ScreenTriangle& t : random_triangles({"", "", count, 1}, 1, 1, 1)) {
    const auto units = [](float px) {
      return static_cast<int32_t>(std::lround(px * (1 << kFractionBits)));
    };
    Shape shape;
    for (size_t i = 0; i < 3; ++i) shape[i] = {units(t.v[i].x), units(t.v[i].y)};
    shapes.push_back(shape);
  }
  return shapes;
}

unsigned char* put_u32(uint32_t value, unsigned char* to) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<unsigned char>(value >> 8 * i);
  return to + 4;
}

unsigned char* put_f32(float value, unsigned char* to) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return put_u32(bits, to);
}

bool write_all(const unsigned char* from, size_t bytes) {
  while (bytes > 0) {
    const ssize_t written = ::write(STDOUT_FILENO, from, bytes);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    from += written;
    bytes -= static_cast<size_t>(written);
  }
  return true;
}

class RandomTriangles {
 public:
  explicit RandomTriangles(uint64_t seed) : random_(seed) {}

  unsigned char* put(unsigned char* to) {
    const uint64_t place = random_();
    const auto x = static_cast<int32_t>((place & 0xffffff) * (kWidth << kFractionBits) >> 24);
    const auto y =
        static_cast<int32_t>((place >> 24 & 0xffffff) * (kHeight << kFractionBits) >> 24);
    const Shape& shape = shapes_[place >> 48 & (kShapes - 1)];
    for (const auto& corner : shape) {
      const uint64_t bits = random_();
      to = put_f32(static_cast<float>(x + corner[0]) * kUnitPx, to);
      to = put_f32(static_cast<float>(y + corner[1]) * kUnitPx, to);
      to = put_f32(static_cast<float>(bits >> 40) * 0x1p-24f, to);
      to = put_u32(static_cast<uint32_t>(bits) | 0xff000000u, to);
    }
    return to;
  }

 private:
  static constexpr int kShapes = 1024;
  static constexpr float kUnitPx = 1.0f / (1 << kFractionBits);

  std::vector<Shape> shapes_ = random_shapes(kShapes);
  spec::SplitMix64 random_;
};

// A framed mesh again and again: each copy at another place, nearer than the one before.
class Copies {
 public:
  Copies(std::vector<ScreenTriangle> mesh, uint64_t copies)
      : mesh_(std::move(mesh)), copies_(copies) {}

  uint64_t count() const { return mesh_.size() * copies_; }
  unsigned char* put(unsigned char* to) {
    constexpr uint64_t kColumns = 12;
    const auto x = static_cast<float>(copy_ % kColumns) - kColumns / 2.0f;
    const auto y = static_cast<float>(copy_ / kColumns % kColumns) - kColumns / 2.0f;
    const float depth = static_cast<float>(copies_ - 1 - copy_) / static_cast<float>(copies_);
    for (const ScreenVertex& v : mesh_[next_].v) {
      to = put_f32(v.x + x * kStepPx, to);
      to = put_f32(v.y + y * kStepPx, to);
      to = put_f32((v.z + depth) / 2, to);
      to = put_u32(0xff000000u | static_cast<uint32_t>(next_), to);
    }
    if (++next_ == mesh_.size()) {
      next_ = 0;
      ++copy_;
    }
    return to;
  }

 private:
  static constexpr float kStepPx = 16;

  std::vector<ScreenTriangle> mesh_;
  uint64_t copies_;
  size_t next_ = 0;
  uint64_t copy_ = 0;
};

template <class Triangles>
int write_stream(uint64_t count, Triangles triangles) {
  std::vector<unsigned char> buffer(kBufferTriangles * kTriangleBytes);
  unsigned char* end = buffer.data();
  for (const char c : {'P', 'T', 'R', 'B'}) *end++ = static_cast<unsigned char>(c);
  for (const uint64_t word : {uint64_t{1}, kWidth, kHeight, uint64_t{0}, count, count >> 32}) {
    end = put_u32(static_cast<uint32_t>(word), end);
  }
  if (!write_all(buffer.data(), static_cast<size_t>(end - buffer.data()))) return 1;
  for (uint64_t left = count; left > 0;) {
    end = buffer.data();
    for (size_t i = 0; i < kBufferTriangles && left > 0; ++i, --left) end = triangles.put(end);
    if (!write_all(buffer.data(), static_cast<size_t>(end - buffer.data()))) return 1;
  }
  return 0;
}

int run(uint64_t count, const char* mesh) {
  if (mesh == nullptr) return write_stream(count, RandomTriangles(1));
  const Copies copies(bench::triangles_of(spec::contract(spec::kHighTile), mesh), count);
  return write_stream(copies.count(), copies);
}

}  // namespace
}  // namespace pineda::scene

int main(int argc, char** argv) {
  char* end = nullptr;
  const uint64_t count = argc == 2 || argc == 3 ? std::strtoull(argv[1], &end, 10) : 0;
  if (argc < 2 || argc > 3 || end == argv[1] || *end != '\0' || count > uint64_t{1} << 32) {
    std::fputs(
        "usage: bench_stream TRIANGLES > FILE.ptrb    (at most 2^32)\n"
        "       bench_stream COPIES MESH > FILE.ptrb\n",
        stderr);
    return 2;
  }
  try {
    if (pineda::scene::run(count, argc == 3 ? argv[2] : nullptr) == 0) return 0;
  } catch (const pineda::scene::InputError& e) {
    std::fprintf(stderr, "bench_stream: %s\n", e.what());
    return 2;
  }
  std::perror("bench_stream: expected to write");
  return 1;
}
