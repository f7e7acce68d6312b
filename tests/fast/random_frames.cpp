#include "tests/fast/random_frames.h"

#include <algorithm>

#include "model/fast/renderer.h"

namespace pineda::test {

using spec::Random;

spec::FrameState random_frame(Random* r) {
  spec::FrameState frame;
  frame.width = r->between(1, 90);
  frame.height = r->between(1, 70);
  frame.cull = static_cast<spec::Cull>(r->between(0, 2));
  frame.depth = static_cast<spec::DepthFunc>(r->between(0, 8));
  frame.depth_write = r->between(0, 3) != 0;
  frame.shade = static_cast<spec::Shade>(r->between(0, 1));
  if (r->between(0, 2) == 0) {
    frame.scissor_x0 = r->between(0, 30);
    frame.scissor_y0 = r->between(0, 30);
    frame.scissor_x1 = r->between(20, 90);
    frame.scissor_y1 = r->between(20, 90);
  }
  if (r->between(0, 2) == 0) {
    frame.bias_constant = r->between(-3000, 3000);
    frame.bias_slope = static_cast<int32_t>(r->between(-2000, 2000));
  }
  if (r->between(0, 2) == 0) frame.clear_depth = static_cast<double>(r->between(0, 8)) / 8;
  return frame;
}

spec::Triangle random_triangle(const spec::Contract& c, const spec::FrameState& frame, Random* r) {
  const spec::Design& d = c.design;
  const int px = 1 << d.subpixel_bits;
  const int64_t limit = int64_t{1} << (d.guard_bits + d.subpixel_bits);
  const auto kind = r->between(0, 23);
  const bool is_tiny = kind < 2;  // about a sample, whose edges may go through it
  const int64_t reach = is_tiny     ? r->between(1, 2)
                        : kind < 4  ? limit
                        : kind < 10 ? r->between(1, 40 * px)
                                    : r->between(1, 5 * px);
  int64_t x = r->between(0, frame.width * px);
  int64_t y = r->between(0, frame.height * px);
  if (is_tiny) {
    x = x / px * px + px / 2;
    y = y / px * px + px / 2;
  }
  spec::Triangle t;
  for (auto& v : t.v) {
    const int64_t from_x = r->between(-reach, reach);
    const int64_t from_y = r->between(-reach, reach);
    v.x = static_cast<int32_t>(std::clamp<int64_t>(x + from_x, -limit, limit - 1));
    v.y = static_cast<int32_t>(std::clamp<int64_t>(y + from_y, -limit, limit - 1));
    v.z = r->between(0, ((int64_t{1} << d.depth_bits) - 1) << 8);
    for (auto& a : v.attr) a = static_cast<int32_t>(r->between(0, (1 << d.attribute_bits) - 1));
    v.inverse_w =
        static_cast<int32_t>(r->between(1 << (d.inverse_w_bits - 1), (1 << d.inverse_w_bits) - 1));
    v.inverse_w_shift = static_cast<int32_t>(r->between(0, 9));
  }
  t.v[0].inverse_w_shift = 0;
  return t;
}

std::string compare(const spec::Contract& c, const spec::Contract& of_tiles, uint64_t seed,
                    uint64_t* drawn) {
  Random random(seed);
  const spec::FrameState frame = random_frame(&random);
  core::Renderer stamps(c, frame);
  fast::Renderer tiles(of_tiles, frame);
  std::vector<spec::Triangle> triangles;
  for (int i = 0; i < 100; ++i) triangles.push_back(random_triangle(c, frame, &random));
  for (const auto& t : triangles) stamps.draw(t);
  // Most of them in a list, whose groups are set up side by side.
  fast::TriangleList list(of_tiles, frame);
  for (size_t i = 0; i < 70; ++i) list.push_back(triangles[i]);
  tiles.draw(list);
  tiles.draw(triangles.data() + 70, 20);
  for (size_t i = 90; i < triangles.size(); ++i) tiles.draw(triangles[i]);
  const core::FrameCounters& a = stamps.counters();
  const core::FrameCounters b = tiles.counters();
  *drawn += a.passed;
  for (const core::FrameCounter& row : core::kFrameCounters) {
    if (row.of(a) != row.of(b)) return row.name;
  }
  const core::FrameBuffer drawn_by_tiles = tiles.buffer();
  if (stamps.buffer().hits != drawn_by_tiles.hits) return "hits";
  if (stamps.buffer().depth != drawn_by_tiles.depth) return "depth";
  if (stamps.buffer().color != drawn_by_tiles.color) return "colour";
  return {};
}

}  // namespace pineda::test
