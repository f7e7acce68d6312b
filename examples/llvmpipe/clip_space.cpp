#include "examples/llvmpipe/clip_space.h"

#include <algorithm>

namespace pineda::llvmpipe {

std::array<Vertex, 3> clip_vertices(const scene::Scene& scene, const spec::Triangle& triangle) {
  const spec::Design& d = scene.source->contract().design;
  const double px = 1 << d.subpixel_bits;
  const auto code =
      static_cast<double>(((int64_t{1} << d.depth_bits) - 1) << spec::kDepthInputFractionBits);
  std::array<Vertex, 3> vertices{};
  for (size_t i = 0; i < 3; ++i) {
    const scene::ScreenVertex& stated = scene.source->screen().v[i];
    const spec::Vertex& v = triangle.v[i];
    const double w = stated.w;
    vertices[i] = {{static_cast<float>((2 * v.x / px / scene.frame.width - 1) * w),
                    static_cast<float>((2 * v.y / px / scene.frame.height - 1) * w),
                    static_cast<float>(static_cast<double>(v.z) / code * w), stated.w},
                   {}};
    std::copy_n(stated.rgba.begin(), 4, vertices[i].rgba);
  }
  return vertices;
}

}  // namespace pineda::llvmpipe
