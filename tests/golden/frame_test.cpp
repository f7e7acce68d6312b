// Frames and units behind the C interface are those of core.
#include <cstring>
#include <thread>

#include "model/core/interp.h"
#include "model/spec/pack.h"
#include "tests/golden/support.h"

namespace pineda::test {
namespace {

void expect_frame(pineda_model* model, const core::FrameBuffer& expected, bool has_depth) {
  std::vector<uint16_t> hits(expected.hits.size()), color(expected.color.size());
  std::vector<uint32_t> depth(expected.depth.size());
  ASSERT_OK(pineda_read_hits(model, hits.data(), hits.size()));
  ASSERT_OK(pineda_read_color(model, color.data(), color.size()));
  EXPECT_EQ(hits, expected.hits);
  EXPECT_EQ(color, expected.color);
  if (!has_depth) {
    EXPECT_EQ(pineda_read_depth(model, depth.data(), depth.size()), PINEDA_UNSUPPORTED);
    return;
  }
  ASSERT_OK(pineda_read_depth(model, depth.data(), depth.size()));
  EXPECT_EQ(depth, expected.depth);
}

class GoldenDesign : public testing::TestWithParam<const char*> {};

TEST_P(GoldenDesign, FrameIsThatOfCore) {
  const spec::Contract contract = spec::contract(*spec::find_design(GetParam()));
  const Model model = open_model(GetParam());
  for (const char* name : {"hard/edges_through_centers", "hard/t_junction", "hard/fan"}) {
    const DrawnScene scene(contract, name);
    ASSERT_FALSE(scene.triangles.empty());
    const pineda_frame frame = stated(scene.frame);
    ASSERT_OK(pineda_begin_frame(model.get(), &frame));
    ASSERT_OK(pineda_draw(model.get(), scene.triangles.data(), scene.triangles.size()));
    expect_frame(model.get(), scene.buffer, contract.design.depth_test);
    ASSERT_OK(pineda_begin_frame(model.get(), &frame));  // cleared
    ASSERT_OK(pineda_draw_screen(model.get(), scene.screen.data(), scene.screen.size()));
    expect_frame(model.get(), scene.buffer, contract.design.depth_test);
  }
}

/// Interpolates and tests a stamp by the interface, against a buffer of its own.
void draw_stamp(pineda_model* model, const spec::Contract& contract, const spec::FrameState& state,
                const pineda_stamp& stamp, core::FrameBuffer* buffer) {
  pineda_fragment fragment;
  ASSERT_OK(pineda_interpolate(model, &stamp, &fragment));
  spec::Stamp inner;
  std::memcpy(static_cast<void*>(&inner), &stamp, sizeof inner);
  spec::Fragment values;
  std::memcpy(static_cast<void*>(&values), &fragment, sizeof values);
  buffer->count_hits(contract, inner);
  uint32_t passed = stamp.mask;
  if (core::tests_depth(contract, state)) {
    const spec::DepthData stored = buffer->read(contract, stamp.x, stamp.y, stamp.mask);
    ASSERT_OK(pineda_depth_test(model, static_cast<int32_t>(state.depth), stamp.mask, fragment.z,
                                stored.z.data(), &passed));
  }
  if (passed == 0) return;
  if (core::tests_depth(contract, state) && state.depth_write) {
    buffer->write(contract, core::depth_write(contract, inner, values, passed));
  }
  buffer->write(contract, core::color_write(contract, inner, values, passed));
}

TEST_P(GoldenDesign, UnitsMakeTheFrameOfCore) {
  const spec::Contract contract = spec::contract(*spec::find_design(GetParam()));
  const Model model = open_model(GetParam());
  const DrawnScene scene(contract, "hard/near_plane");
  const pineda_frame frame = stated(scene.frame);
  core::FrameBuffer buffer(contract, scene.frame);
  std::vector<pineda_stamp> stamps(1 << 13);
  size_t kept = 0;
  for (const pineda_triangle& triangle : scene.triangles) {
    pineda_setup_prim prim;
    pineda_drop drop;
    ASSERT_OK(pineda_setup(model.get(), &frame, &triangle, &prim, &drop));
    if (drop != PINEDA_KEPT) continue;
    ++kept;
    size_t count = 0;
    ASSERT_OK(pineda_traverse(model.get(), &prim, stamps.data(), stamps.size(), &count));
    for (size_t i = 0; i < count; ++i) {
      draw_stamp(model.get(), contract, scene.frame, stamps[i], &buffer);
    }
  }
  EXPECT_GT(kept, 0U);
  EXPECT_EQ(buffer.hits, scene.buffer.hits);
  EXPECT_EQ(buffer.depth, scene.buffer.depth);
  EXPECT_EQ(buffer.color, scene.buffer.color);
}

TEST_P(GoldenDesign, PackedStructsAreThoseOfTheRtl) {
  const spec::Contract contract = spec::contract(*spec::find_design(GetParam()));
  const Model model = open_model(GetParam());
  const DrawnScene scene(contract, "hard/near_plane");
  const spec::Packer<spec::Triangle> packer(contract);
  size_t bits = 0;
  ASSERT_OK(pineda_packed_bits(model.get(), PINEDA_PACKED_TRIANGLE, &bits));
  ASSERT_EQ(static_cast<int>(bits), packer.bits());
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    spec::Packed words((bits + 31) / 32);
    ASSERT_OK(pineda_pack(model.get(), PINEDA_PACKED_TRIANGLE, &scene.triangles[i], words.data(),
                          words.size()));
    ASSERT_EQ(words, packer.pack(scene.snapped[i]));
    pineda_triangle back{};
    ASSERT_OK(
        pineda_unpack(model.get(), PINEDA_PACKED_TRIANGLE, words.data(), words.size(), &back));
    // A frame of it alone tells whether anything that the design uses was lost.
    const pineda_frame frame = stated(scene.frame);
    pineda_setup_prim prims[2] = {};
    pineda_drop drops[2];
    ASSERT_OK(pineda_setup(model.get(), &frame, &scene.triangles[i], &prims[0], &drops[0]));
    ASSERT_OK(pineda_setup(model.get(), &frame, &back, &prims[1], &drops[1]));
    ASSERT_EQ(drops[0], drops[1]);
    ASSERT_EQ(std::memcmp(&prims[0], &prims[1], sizeof prims[0]), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Golden, GoldenDesign,
                         testing::Values("low", "high_tile", "persp", "flat", "wide", "tiny"),
                         [](const auto& design) { return std::string(design.param); });

TEST(Golden, FramePacksAndUnpacks) {
  const Model model = open_model("high_tile");
  pineda_frame frame = pineda_default_frame(641, 479);
  frame.cull = PINEDA_CULL_FRONT;
  frame.depth_func = PINEDA_DEPTH_GEQUAL;
  frame.has_scissor = 1;
  frame.scissor_x = 3;
  frame.scissor_y = 5;
  frame.scissor_width = 100;
  frame.scissor_height = 50;
  frame.bias_constant = -77;
  frame.bias_slope = 300;
  size_t bits = 0;
  ASSERT_OK(pineda_packed_bits(model.get(), PINEDA_PACKED_FRAME, &bits));
  std::vector<uint32_t> words((bits + 31) / 32), again(words.size());
  ASSERT_OK(pineda_pack(model.get(), PINEDA_PACKED_FRAME, &frame, words.data(), words.size()));
  pineda_frame back{};
  ASSERT_OK(pineda_unpack(model.get(), PINEDA_PACKED_FRAME, words.data(), words.size(), &back));
  EXPECT_EQ(back.width, 641);
  EXPECT_EQ(back.cull, PINEDA_CULL_FRONT);
  EXPECT_EQ(back.depth_func, PINEDA_DEPTH_GEQUAL);
  EXPECT_EQ(back.scissor_x, 3);
  EXPECT_EQ(back.scissor_width, 100);
  EXPECT_EQ(back.bias_constant, -77);
  EXPECT_EQ(back.bias_slope, 300);
  ASSERT_OK(pineda_pack(model.get(), PINEDA_PACKED_FRAME, &back, again.data(), again.size()));
  EXPECT_EQ(again, words);
}

TEST(Golden, ThreadsDoNotDisturbOneAnother) {
  const DrawnScene scene(spec::contract(spec::kHighTile), "hard/fan");
  const pineda_frame frame = stated(scene.frame);
  const Model shared = open_model("high_tile");
  ASSERT_OK(pineda_begin_frame(shared.get(), &frame));
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      const Model own = open_model("high_tile");
      for (int round = 0; round < 20; ++round) {
        EXPECT_OK(pineda_begin_frame(own.get(), &frame));
        for (const pineda_triangle& triangle : scene.triangles) {
          EXPECT_OK(pineda_draw(own.get(), &triangle, 1));
        }
        std::vector<uint32_t> depth(scene.buffer.depth.size());
        EXPECT_OK(pineda_read_depth(own.get(), depth.data(), depth.size()));
        EXPECT_EQ(depth, scene.buffer.depth);
      }
      // Calls on one model wait for one another: each triangle is drawn once by each thread.
      for (const pineda_triangle& triangle : scene.triangles) {
        EXPECT_OK(pineda_draw(shared.get(), &triangle, 1));
      }
      // Errors are those of the thread.
      pineda_model* none = nullptr;
      const std::string name = "thread" + std::to_string(i);
      EXPECT_EQ(pineda_open(name.c_str(), &none), PINEDA_NO_DESIGN);
      std::this_thread::yield();
      EXPECT_NE(std::string(pineda_last_error()).find(name), std::string::npos);
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::vector<uint16_t> hits(scene.buffer.hits.size());
  ASSERT_OK(pineda_read_hits(shared.get(), hits.data(), hits.size()));
  for (size_t i = 0; i < hits.size(); ++i) ASSERT_EQ(hits[i], 4 * scene.buffer.hits[i]);
}

TEST(Golden, TomlOfADesignOpensIt) {
  const Model model = open_model("persp");
  size_t length = 0;
  EXPECT_EQ(pineda_get_toml(model.get(), nullptr, 0, &length), PINEDA_WRONG_SIZE);
  std::string text(length + 1, '?');
  ASSERT_OK(pineda_get_toml(model.get(), text.data(), text.size(), &length));
  pineda_model* again = nullptr;
  ASSERT_OK(pineda_open_toml(text.c_str(), "again.toml", &again));
  const Model owner(again);
  pineda_design design{};
  ASSERT_OK(pineda_get_design(again, &design));
  EXPECT_EQ(design.perspective, 1);
  EXPECT_EQ(design.inverse_w_bits, 20);
  EXPECT_EQ(design.depth_bits, 24);
  EXPECT_EQ(design.stamp_width_px, 2);
}

}  // namespace
}  // namespace pineda::test
