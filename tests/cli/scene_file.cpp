#include "tests/cli/scene_file.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace pineda::test {
namespace {

void put(std::string* to, uint64_t value, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i) to->push_back(static_cast<char>(value >> 8 * i & 0xff));
}

void put(std::string* to, float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  put(to, bits, 4);
}

}  // namespace

std::string tri_text(const Scene& scene) {
  static constexpr const char* kCull[] = {"none", "back", "front"};
  static constexpr const char* kDepth[] = {"less", "lequal", "off"};
  std::string text = "pineda-tri 1\nsize " + std::to_string(scene.width) + " " +
                     std::to_string(scene.height) + "\ncull " +
                     kCull[static_cast<int>(scene.cull)] + "\ndepth " +
                     kDepth[static_cast<int>(scene.depth)] + "\n" + scene.state;
  for (const Triangle& t : scene.triangles) {
    for (const Vertex& v : t) {
      char line[160];
      // Hex floats: every bit arrives.
      std::snprintf(line, sizeof line, "v %a %a %a %a %d %d %d %d\n", static_cast<double>(v.x),
                    static_cast<double>(v.y), static_cast<double>(v.z), static_cast<double>(v.w),
                    v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]);
      text += line;
    }
  }
  return text;
}

std::string ptrb_bytes(const Scene& scene, bool with_w) {
  std::string bytes = "PTRB";
  put(&bytes, 1, 4);
  put(&bytes, static_cast<uint64_t>(scene.width), 4);
  put(&bytes, static_cast<uint64_t>(scene.height), 4);
  const auto cull = static_cast<uint64_t>(scene.cull);
  const auto depth = static_cast<uint64_t>(scene.depth);
  put(&bytes, (with_w ? 1u : 0u) | cull << 1 | depth << 3, 4);
  put(&bytes, scene.triangles.size(), 8);
  for (const Triangle& t : scene.triangles) {
    for (const Vertex& v : t) {
      put(&bytes, v.x);
      put(&bytes, v.y);
      put(&bytes, v.z);
      if (with_w) put(&bytes, v.w);
      for (const uint8_t channel : v.rgba) put(&bytes, channel, 1);
    }
  }
  return bytes;
}

Triangle Random::any_order(Triangle t) {
  std::rotate(t.begin(), t.begin() + between(0, 2), t.end());
  if (between(0, 1) == 1) std::swap(t[1], t[2]);
  return t;
}

}  // namespace pineda::test
