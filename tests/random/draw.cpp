#include "tests/random/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "model/scene/writers.h"
#include "model/spec/random.h"

namespace pineda::test {
namespace {

using spec::Random;
using spec::ReciprocalScheme;

bool one_in(Random* r, int n) { return r->between(1, n) == 1; }

// Logarithmic: as often between 1 and 2 as between 2^(bits-1) and 2^bits.
int scaled(Random* r, int bits) {
  const int scale = 1 << r->between(0, bits);
  return r->between((scale + 1) / 2, scale);
}

// Anywhere in its range.
void draw(Random* r, int spec::Design::*member, spec::Design* d) {
  const auto& number = std::get<spec::Number>(spec::parameter(member).member);
  d->*member = r->between(number.low(*d), number.high(*d));
}

void draw_values(Random* r, spec::Design* d) {
  d->depth_test = !one_in(r, 8);
  draw(r, &spec::Design::depth_bits, d);
  d->attributes = r->between(0, one_in(r, 4) ? spec::kMaxAttributes : 4);
  d->flat_attributes = std::min(r->between(0, 2), spec::kMaxAttributes - d->attributes);
  draw(r, &spec::Design::attribute_bits, d);
  d->perspective = one_in(r, 3);
  draw(r, &spec::Design::inverse_w_bits, d);
}

void draw_setup(Random* r, spec::Design* d) {
  draw(r, &spec::Design::subpixel_bits, d);
  draw(r, &spec::Design::guard_bits, d);
  d->reciprocal_scheme = static_cast<ReciprocalScheme>(r->between(0, 3));
  draw(r, &spec::Design::reciprocal_lut_bits, d);
  draw(r, &spec::Design::reciprocal_newton_steps, d);
  draw(r, &spec::Design::reciprocal_bits, d);
  d->setup_style = static_cast<spec::SetupStyle>(r->between(0, 2));
  draw(r, &spec::Design::multiplier_stages, d);
  draw(r, &spec::Design::gradient_fraction_bits, d);
  draw(r, &spec::Design::tile_fraction_bits, d);
}

void draw_raster(Random* r, spec::Design* d) {
  d->tile_log2 = r->between(2, 6);
  draw(r, &spec::Design::stamp_width_log2, d);
  draw(r, &spec::Design::stamp_height_log2, d);
  draw(r, &spec::Design::tested_stamps_log2, d);
  d->hierarchical_z = one_in(r, 2);
  draw(r, &spec::Design::hierarchical_z_bits, d);
  d->hierarchical_z_tiles = scaled(r, 14);
  d->hierarchical_z_delay_cycles = scaled(r, 6);
  d->prim_fifo_depth = r->between(0, 2) == 0 ? 0 : scaled(r, 6);
  d->tile_fifo_depth = r->between(0, 2) == 0 ? 0 : scaled(r, 6);
  d->stamp_fifo_depth = scaled(r, 6);
  d->plane_slots = 1 + scaled(r, 5);
  d->max_depth_latency_cycles = scaled(r, 6);
  draw(r, &spec::Design::depth_latency_cycles, d);
}

bool usable(const spec::Design& d) {
  const int values = (spec::channels(d) + 1) << (d.stamp_width_log2 + d.stamp_height_log2);
  return spec::invalid_reason(d).empty() && spec::no_rtl_reason(d).empty() &&
         values <= (d.perspective ? 32 : 64);
}

// ---- Scenes

enum class Kind { kSmall, kMedium, kGuardBand, kNeedle, kOneStamp, kFrame };
constexpr int kKinds = 6;

struct Point {
  float x;
  float y;
};

struct Canvas {
  const spec::Design& design;
  int width;
  int height;

  float kept(float value_px) const {
    const auto limit = static_cast<float>(1 << design.guard_bits);
    return std::clamp(value_px, -limit, limit - std::ldexp(1.f, -design.subpixel_bits));
  }
  Point near(Random* r, Point p, float reach_px) const {
    const float dx = r->uniform(-reach_px, reach_px);
    const float dy = r->uniform(-reach_px, reach_px);
    return {kept(p.x + dx), kept(p.y + dy)};
  }
};

std::array<Point, 3> corners(Random* r, const Canvas& c, Kind kind) {
  const float x = r->uniform(0, static_cast<float>(c.width));
  const float y = r->uniform(0, static_cast<float>(c.height));
  const auto around = [&](Point p, float reach) {
    std::array<Point, 3> corner{};
    for (Point& q : corner) q = c.near(r, p, reach);
    return corner;
  };
  switch (kind) {
    case Kind::kSmall:
      return around({x, y}, 3);
    case Kind::kMedium:
      return around({x, y}, 20);
    case Kind::kGuardBand:
      return around({x, y}, static_cast<float>(2 << c.design.guard_bits));
    case Kind::kNeedle: {
      auto corner = around({x, y}, 200);
      corner[1] = c.near(r, corner[0], 1.5f);
      return corner;
    }
    case Kind::kOneStamp:
      return around({2, 2}, 2);
    case Kind::kFrame:
      break;
  }
  const auto far = c.kept(static_cast<float>(2 * std::max(c.width, c.height)));
  return {{{-1, -1}, {far, -1}, {-1, far}}};
}

std::string triangle_lines(Random* r, const Canvas& c, Kind kind) {
  auto corner = corners(r, c, kind);
  if (r->between(0, 1) == 1) std::swap(corner[1], corner[2]);
  const int ratio_log2 = one_in(r, 2) ? 0 : r->between(1, 20);
  // Few depths, so that some are equal; else any.
  const int depths = one_in(r, 4) ? 4 : 1 << 24;
  std::string text;
  for (const Point& p : corner) {
    const float z = static_cast<float>(r->between(0, depths)) / static_cast<float>(depths);
    float w = 1;
    if (ratio_log2 != 0) {
      const int exponent = r->between(-ratio_log2, 0) + ratio_log2 / 2;
      w = std::ldexp(r->uniform(1, 2), exponent);
    }
    text += fmt::format("v {:.9g} {:.9g} {:.9g} {:.9g}", p.x, p.y, z, w);
    for (int i = 0; i < 4; ++i) text += fmt::format(" {}", r->between(0, 255));
    text += '\n';
  }
  return text;
}

std::string state_lines(Random* r, const Canvas& c) {
  static constexpr const char* kCulls[] = {"none", "none", "back", "front"};
  static constexpr const char* kDepths[] = {"less",    "lequal", "less",  "lequal",
                                            "greater", "off",    "never", "notequal",
                                            "greater", "gequal", "equal", "always"};
  std::string text = fmt::format("pineda-tri 1\nsize {} {}\n", c.width, c.height);
  text += fmt::format("cull {}\n", kCulls[r->between(0, 3)]);
  const std::string depth = kDepths[r->between(0, 11)];
  text += fmt::format("depth {}\n", depth);
  text += fmt::format("depthwrite {}\n", one_in(r, 4) ? "off" : "on");
  if (one_in(r, 3)) {
    const int x = r->between(0, c.width / 2);
    const int y = r->between(0, c.height / 2);
    const int width = r->between(0, c.width);
    const int height = r->between(0, c.height);
    text += fmt::format("scissor {} {} {} {}\n", x, y, width, height);
  }
  if (one_in(r, 2)) {
    const int constant = r->between(-3000, 3000);
    const int slope = one_in(r, 4) ? r->between(-32768, 32767) : r->between(-600, 600);
    text += fmt::format("depthbias {} {}\n", constant, slope / 256.);
  }
  if (one_in(r, 2)) {
    // With reversed z cleared to 0; else so that a part of what is drawn lies behind the cleared
    // depth.
    const bool is_reversed = depth == "greater" || depth == "gequal";
    text += fmt::format("cleardepth {:.9g}\n", is_reversed ? 0 : r->uniform(.3f, 1));
  }
  text += fmt::format("shade {}\n", one_in(r, 4) ? "flat" : "smooth");
  return text;
}

}  // namespace

spec::Design random_design(uint64_t seed) {
  static std::deque<std::string> names;  // they live as long as the program
  Random random(seed);
  spec::Design d;
  do {
    draw_values(&random, &d);
    draw_setup(&random, &d);
    draw_raster(&random, &d);
  } while (!usable(d));
  d.name = names.emplace_back(fmt::format("r{}", seed)).c_str();
  d.summary = names.emplace_back(fmt::format("drawn from seed {}", seed)).c_str();
  return d;
}

std::string summary_of(const spec::Design& d) {
  return fmt::format(
      "{} l{} n{} k{} {} m{}, S{} g{}, {}{}, {}+{} of {} bits{}, F{}/{}, tile {}, stamp {}x{}, "
      "FIFOs "
      "{} "
      "{} {}, {} planes, latency {}",
      spec::name_of(d.reciprocal_scheme), d.reciprocal_lut_bits, d.reciprocal_newton_steps,
      d.reciprocal_bits, spec::name_of(d.setup_style), d.multiplier_stages, d.subpixel_bits,
      d.guard_bits, d.depth_test ? fmt::format("z{}", d.depth_bits) : "no z",
      d.hierarchical_z ? fmt::format(" hidden {}b {} tiles {} cycles", d.hierarchical_z_bits,
                                     d.hierarchical_z_tiles, d.hierarchical_z_delay_cycles)
                       : "",
      d.attributes, d.flat_attributes, d.attribute_bits,
      d.perspective ? fmt::format(" persp {}", d.inverse_w_bits) : "", d.gradient_fraction_bits,
      d.tile_fraction_bits, 1 << d.tile_log2, 1 << d.stamp_width_log2, 1 << d.stamp_height_log2,
      d.prim_fifo_depth, d.tile_fifo_depth, d.stamp_fifo_depth, d.plane_slots,
      d.max_depth_latency_cycles);
}

std::string random_tri(const spec::Design& design, uint64_t seed) {
  Random random(seed);
  const int greatest_px = 1 << design.guard_bits;
  const int width = random.between(1, std::min(150, greatest_px));
  const int height = random.between(1, std::min(90, greatest_px));
  const Canvas canvas{design, width, height};
  std::string text = state_lines(&random, canvas);
  const int kind = random.between(0, kKinds);  // the last one: mixed
  const int triangles = random.between(1, 60);
  for (int i = 0; i < triangles; ++i) {
    const int own = kind == kKinds ? random.between(0, kKinds - 1) : kind;
    text += triangle_lines(&random, canvas, static_cast<Kind>(own));
  }
  return text;
}

std::string Trial::arguments() const {
  return fmt::format("'{}'{} {} --stall {} --seed {}", scene, size.empty() ? "" : " --size " + size,
                     memory == memory::Kind::kIdeal
                         ? fmt::format("--latency {}", bench.depth_latency_cycles)
                         : fmt::format("--memory {}", spec::name_of(memory)),
                     spec::name_of(bench.stall_mode), bench.seed);
}

Trial random_trial(const spec::Design& design, uint64_t seed, const std::string& folder) {
  Random random(seed);
  Trial trial;
  trial.bench.depth_latency_cycles = random.between(1, design.max_depth_latency_cycles);
  // Sometimes longer than the table of stamps in flight can hide.
  if (seed % 4 == 0) {
    trial.bench.depth_latency_cycles =
        std::min(8 * trial.bench.depth_latency_cycles, spec::kMaxDepthLatencyCycles);
  }
  trial.bench.stall_mode = tb::kStallModes[random.between(0, 3)];
  trial.bench.seed = random.bits() >> 32;
  Random kind(~seed);  // not `random`: a scene depends on its seed alone
  if (one_in(&kind, 3)) {
    constexpr auto kLast = static_cast<int>(memory::kKinds.size()) - 1;
    trial.memory = memory::kKinds[static_cast<size_t>(kind.between(1, kLast))];  // 0 is ideal
  }
  if (one_in(&random, 4)) {
    static constexpr const char* kBuiltIn[] = {"triangle", "grid", "layers", "random/screen"};
    static constexpr const char* kHard[] = {
        "hard/back_to_back", "hard/near_plane",  "hard/sliver",        "hard/tile_corners",
        "hard/zero_area",    "hard/perspective", "hard/guard_band_fan"};
    // Hard cases have frames of their own, which want a guard band.
    if (design.guard_bits >= 10 && random.between(0, 1) == 1) {
      trial.scene = kHard[random.between(0, 6)];
    } else {
      trial.scene = kBuiltIn[random.between(0, 3)];
      const int greatest_px = 1 << design.guard_bits;
      const int width = random.between(1, std::min(100, greatest_px));
      const int height = random.between(1, std::min(70, greatest_px));
      trial.size = fmt::format("{}x{}", width, height);
    }
    return trial;
  }
  trial.scene = fmt::format("{}/scene_{}.tri", folder, seed);
  scene::write_file(trial.scene, random_tri(design, seed));
  return trial;
}

}  // namespace pineda::test
