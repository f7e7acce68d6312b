#include "tests/rtl/setup_bench.h"

#include <algorithm>

namespace pineda::tb {

using spec::Contract;
using spec::Random;

namespace {

int64_t signed_value(Random* random, int bits) {
  const int64_t limit = int64_t{1} << (bits - 1);
  // An end of the range, a small number, or any.
  switch (random->between(0, 4)) {
    case 0:
      return random->coin() ? limit - 1 : -limit;
    case 1:
      return random->between(-limit, limit - 1);
    default:
      return random->between(-300, 300);
  }
}

spec::FrameState random_frame(Random* random, const Contract& c) {
  spec::FrameState frame;
  const int64_t limit = int64_t{1} << c.design.guard_bits;
  const auto side = [&] {
    return static_cast<int>(random->coin() ? random->between(1, limit)
                                           : random->between(1, std::min<int64_t>(limit, 100)));
  };
  frame.width = side();
  frame.height = side();
  frame.cull = static_cast<spec::Cull>(random->between(0, 5) % 3 * random->between(0, 1));
  frame.shade = static_cast<spec::Shade>(random->between(0, 1));
  if (random->coin()) {
    frame.scissor_x0 = random->between(0, frame.width);
    frame.scissor_y0 = random->between(0, frame.height / 2);
    frame.scissor_x1 = random->between(0, frame.width + 3);
    frame.scissor_y1 = random->between(frame.height / 2, frame.height);
  }
  if (c.design.depth_test && random->coin()) {
    frame.bias_constant = signed_value(random, c.width.bias_constant);
    frame.bias_slope = static_cast<int32_t>(signed_value(random, spec::kBiasSlopeBits));
  }
  return frame;
}

void random_values(Random* random, const Contract& c, spec::Vertex* v) {
  const int64_t depth_limit = ((int64_t{1} << c.design.depth_bits) - 1) << 8;
  v->z = random->between(0, 3) == 0 ? (random->coin() ? 0 : depth_limit)
                                    : random->between(0, depth_limit);
  for (int i = 0; i < spec::channels(c.design); ++i) {
    v->attr[static_cast<size_t>(i)] =
        static_cast<int32_t>(random->between(0, (1 << c.design.attribute_bits) - 1));
  }
  const int64_t mantissa = int64_t{1} << (c.design.inverse_w_bits - 1);
  v->inverse_w = static_cast<int32_t>(random->between(mantissa, 2 * mantissa - 1));
  v->inverse_w_shift = static_cast<int32_t>(random->between(0, 255));
}

// In subpixels: in and around the frame, within some pixels, anywhere in the guard band.
spec::Triangle random_triangle(Random* random, const Contract& c, const spec::FrameState& frame) {
  const int s = c.design.subpixel_bits;
  const int64_t guard = int64_t{1} << (c.design.guard_bits + s);
  const auto inside = [&](int64_t value) { return std::clamp(value, -guard, guard - 1); };
  const auto kind = random->between(0, 3);
  const int64_t spread = kind == 0   ? 3 << s
                         : kind == 1 ? 20 << s
                         : kind == 2 ? int64_t{2 * std::max(frame.width, frame.height)} << s
                                     : guard;
  const int64_t x = kind == 3 ? 0 : random->between(0, int64_t{frame.width} << s);
  const int64_t y = kind == 3 ? 0 : random->between(0, int64_t{frame.height} << s);
  spec::Triangle t;
  t.id = static_cast<uint32_t>(random->bits());
  for (spec::Vertex& v : t.v) {
    v.x = static_cast<int32_t>(inside(x + random->between(-spread, spread)));
    v.y = static_cast<int32_t>(inside(y + random->between(-spread, spread)));
    random_values(random, c, &v);
  }
  // Horizontal, vertical and degenerate triangles.
  if (random->between(0, 9) == 0) t.v[1].y = t.v[0].y;
  if (random->between(0, 9) == 0) t.v[2].x = t.v[1].x;
  if (random->between(0, 9) == 0) t.v[2].y = t.v[0].y;
  return t;
}

}  // namespace

std::vector<spec::Packed> expected_prims(const Contract& contract, const SetupScene& scene) {
  const spec::Packer<spec::SetupPrim> packer(contract);
  std::vector<spec::Packed> prims;
  for (const spec::Triangle& triangle : scene.triangles) {
    spec::SetupPrim prim;
    if (core::setup(contract, scene.frame, triangle, &prim) == core::Drop::kNone) {
      prims.push_back(packer.pack(prim));
    }
  }
  return prims;
}

SetupScene random_setup_scene(const Contract& contract, uint64_t seed, int triangles) {
  Random random(seed);
  SetupScene scene;
  scene.frame = random_frame(&random, contract);
  for (int i = 0; i < triangles; ++i) {
    scene.triangles.push_back(random_triangle(&random, contract, scene.frame));
  }
  return scene;
}

Script random_script(const Contract& contract, uint64_t seed, bool source, bool sink,
                     size_t count) {
  Random random(seed);
  const int64_t longest = 2 * contract.width.setup_interval_cycles + 1;
  const auto cycles = [&](bool stalls) {
    std::vector<int64_t> times;
    int64_t time = 0;
    for (size_t i = 0; i <= count; ++i) {
      times.push_back(time);
      // Bursts, and now and then a pause that may exceed the latency.
      if (!stalls) continue;
      if (random.coin()) time += random.between(0, longest);
      if (random.between(0, 15) == 0) time += random.between(0, 50 + longest);
    }
    return times;
  };
  Script script;
  script.offers = cycles(source);
  script.takes = cycles(sink);
  return script;
}

}  // namespace pineda::tb
