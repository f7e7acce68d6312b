#include "tests/rtl/support.h"

#include <map>
#include <memory>

#include "model/spec/design_file.h"
#include "tb/scoreboard.h"

namespace pineda::tb {

const RtlLibrary& rtl() {
  static const RtlLibrary library(spec::contract(spec::kHighTile), PINEDA_RTL);
  return library;
}

const RtlLibrary& mutant() {
  static const RtlLibrary library(spec::contract(spec::kHighTile), PINEDA_RTL_MUTANT);
  return library;
}

const RtlLibrary& raster_rtl(std::string_view name) {
  static std::map<std::string, std::unique_ptr<RtlLibrary>> libraries;
  const std::string design(name);
  auto& library = libraries[design];
  if (!library) {
    const auto contract =
        spec::contract(spec::read_design(PINEDA_RASTER_DESIGNS "/" + design + ".toml"));
    library = std::make_unique<RtlLibrary>(contract, PINEDA_RASTER_PLUGINS "/" + design + ".so");
  }
  return *library;
}

spec::FrameState random_state(spec::Random* random, int width, int height) {
  spec::FrameState frame;
  frame.width = width;
  frame.height = height;
  frame.cull = static_cast<spec::Cull>(random->between(0, 2));
  frame.depth = static_cast<spec::DepthFunc>(random->between(0, 2));
  if (random->between(0, 2) == 0)
    frame.clear_depth = static_cast<double>(random->between(1, 255)) / 256;
  return frame;
}

spec::FrameState random_raster_state(spec::Random* random, int width, int height,
                                     const spec::Contract& c) {
  spec::FrameState frame = random_state(random, width, height);
  frame.depth = static_cast<spec::DepthFunc>(random->between(0, 8));
  if (random->between(0, 5) == 0) frame.clear_depth = 0;
  frame.depth_write = random->between(0, 3) != 0;
  frame.shade = random->between(0, 3) == 0 ? spec::Shade::kFlat : spec::Shade::kSmooth;
  if (random->coin()) {
    frame.scissor_x0 = random->between(0, width);
    frame.scissor_y0 = random->between(0, height);
    frame.scissor_x1 = random->between(frame.scissor_x0, width + 8);
    frame.scissor_y1 = random->between(frame.scissor_y0, height + 8);
  }
  // None, a few codes, anything.
  const int64_t constants[] = {0, 4, (int64_t{1} << (c.width.bias_constant - 1)) - 1};
  const int64_t slopes[] = {0, 1 << spec::kBiasFactorFractionBits,
                            (1 << (spec::kBiasSlopeBits - 1)) - 1};
  const int64_t constant = constants[random->between(0, 2)];
  const int64_t slope = slopes[random->between(0, 2)];
  frame.bias_constant = random->between(-constant, constant);
  frame.bias_slope = static_cast<int32_t>(random->between(-slope, slope));
  return frame;
}

namespace {

// 1/w of the vertices: near one another or far apart.
void random_inverse_w(spec::Random* random, const spec::Contract& c, spec::Triangle* t) {
  const int64_t half = int64_t{1} << (c.design.inverse_w_bits - 1);
  const int64_t ranges[] = {0, 3, 30, (1 << spec::kInverseWShiftBits) - 1};
  const int64_t range = ranges[random->between(0, 3)];
  for (spec::Vertex& v : t->v) {
    v.inverse_w = static_cast<int32_t>(random->between(half, 2 * half - 1));
    v.inverse_w_shift = static_cast<int32_t>(random->between(0, range));
  }
  t->v[static_cast<size_t>(random->between(0, 2))].inverse_w_shift = 0;
}

}  // namespace

std::vector<spec::Triangle> random_triangles(spec::Random* random, const spec::FrameState& frame,
                                             int size_px, size_t count, const spec::Contract& c) {
  const int64_t px = int64_t{1} << c.design.subpixel_bits;
  const int64_t limit = px << c.design.guard_bits;
  const int64_t size = size_px * px;
  const auto inside = [&](int64_t x) {
    return static_cast<int32_t>(std::clamp(x, -limit, limit - 1));
  };
  std::vector<spec::Triangle> triangles(count);
  for (size_t i = 0; i < count; ++i) {
    spec::Triangle& t = triangles[i];
    t.id = static_cast<uint32_t>(i);
    const int64_t x = random->between(-size / 2, frame.width * px + size / 2);
    const int64_t y = random->between(-size / 2, frame.height * px + size / 2);
    const int64_t wide = random->between(0, 7) == 0 ? px : size;  // needles
    for (spec::Vertex& v : t.v) {
      v.x = inside(x + random->between(-size / 2, size / 2));
      v.y = inside(y + random->between(-wide / 2, wide / 2));
      v.z = random->between(0, ((int64_t{1} << c.design.depth_bits) - 1) << 8);
      for (int a = 0; a < spec::channels(c.design); ++a) {
        v.attr[static_cast<size_t>(a)] =
            static_cast<int32_t>(random->between(0, (1 << c.design.attribute_bits) - 1));
      }
    }
    if (c.design.perspective) random_inverse_w(random, c, &t);
    if (i > 0 && random->between(0, 15) == 0) t.v[0] = triangles[i - 1].v[2];
  }
  return triangles;
}

vectors::TraversalCase random_traversal(spec::Random* random, const spec::Contract& c, int frame_px,
                                        int size_px, size_t triangles) {
  const auto width = random->between(1, frame_px);
  const auto height = random->between(1, frame_px);
  vectors::SetupCase setup;
  setup.frame = random_raster_state(random, width, height, c);
  setup.in = random_triangles(random, setup.frame, size_px, triangles, c);
  const vectors::TraversalCase inputs{"random", setup.frame, vectors::run_model(c, setup).out, {}};
  return vectors::run_model(c, inputs);
}

NextTriangle from(const std::vector<spec::Triangle>& triangles) {
  return [&triangles, i = size_t{0}](spec::Triangle* t) mutable {
    if (i == triangles.size()) return false;
    *t = triangles[i++];
    return true;
  };
}

std::string check_frame(FrameBench* bench, const spec::FrameState& frame,
                        const std::vector<spec::Triangle>& triangles,
                        const spec::Contract& contract) {
  Scoreboard scoreboard("RTL", contract, frame, from(triangles));
  const FrameResult result = bench->run(frame, from(triangles), &scoreboard);
  scoreboard.finish();
  if (scoreboard.mismatches() != 0) return scoreboard.first_divergence();
  const auto& model = scoreboard.renderer().buffer();
  if (bench->buffer().depth != model.depth) return "depth memories differ";
  if (bench->buffer().color != model.color) return "colour memories differ";
  if (bench->buffer().hits != model.hits) return "hits differ";
  return result.counters.triangles == triangles.size() ? "" : "triangles were lost";
}

}  // namespace pineda::tb
