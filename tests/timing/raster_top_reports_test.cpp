// What a rasterizer reports, and that the frame after it is as if nothing had been.
#include <gtest/gtest.h>

#include <stdexcept>

#include "model/memory/kinds.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

// Covers a frame of up to 64 x 64 px.
spec::Triangle cover(int64_t z = 1000) { return flat_triangle(0, 0, 128, 0, 0, 128, z); }

class RasterTopReports : public testing::Test {
 protected:
  // Stamp by stamp, since somebody listens.
  timing::FrameResult run(const Scene& scene) {
    Record record;
    Recorder recorder(&record);
    return top_.run(scene.frame, pull_from(scene), &recorder);
  }

  timing::RasterTop top_{"top", kContract};
};

TEST_F(RasterTopReports, FrameOutsideTheGuardBandIsRefused) {
  EXPECT_EQ(reported([&] {
              run({{0, 2}, {}});
            }),
            "pineda/raster_top/frame: expected 1 to 16384 px, got 0x2");
  EXPECT_EQ(reported([&] {
              run({{2, 16385}, {}});
            }),
            "pineda/raster_top/frame: expected 1 to 16384 px, got 2x16385");
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46);
}

// Every number of a triangle, one beyond the ends of its range. The triangle before it is drawn.
TEST_F(RasterTopReports, TriangleBeyondItsFieldsIsRefused) {
  struct Case {
    void (*set)(spec::Triangle*);
    const char* text;
  };
  const Case cases[] = {
      {[](auto* t) { t->v[2].x = 1 << 22; }, "v[2].x: expected -4194304 to 4194303, got 4194304"},
      {[](auto* t) { t->v[0].x = INT32_MAX; },
       "v[0].x: expected -4194304 to 4194303, got 2147483647"},
      {[](auto* t) { t->v[1].y = -(1 << 22) - 1; },
       "v[1].y: expected -4194304 to 4194303, got -4194305"},
      {[](auto* t) { t->v[1].z = (int64_t{0xffffff} << 8) + 1; },
       "v[1].z: expected 0 to 4294967040, got 4294967041"},
      {[](auto* t) { t->v[0].z = -1; }, "v[0].z: expected 0 to 4294967040, got -1"},
      {[](auto* t) { t->v[2].attr[3] = 256; }, "v[2].attr[3]: expected 0 to 255, got 256"},
      {[](auto* t) { t->v[0].attr[0] = -1; }, "v[0].attr[0]: expected 0 to 255, got -1"},
  };
  for (const Case& c : cases) {
    Scene scene{{2, 2}, {cover(1000), cover(999), cover(998)}};
    scene.triangles[1].id = 7;
    c.set(&scene.triangles[1]);
    EXPECT_EQ(reported([&] { top_.run(scene.frame, scene.triangles); }),
              std::string("pineda/raster_top/vertex: triangle 7, ") + c.text);
    EXPECT_EQ(top_.buffer().depth[0], 1000u);
    EXPECT_NE(reported([&] { run(scene); }), "");
    EXPECT_EQ(top_.buffer().depth[0], 1000u) << "stamp by stamp";
  }
  // What the design does not have may hold anything, and so may what stands at the ends.
  spec::Triangle t = cover();
  t.v[0] = {(1 << 22) - 1, -(1 << 22), int64_t{0xffffff} << 8, {255, 0, 255, 0, -1}, -1, 1 << 20};
  EXPECT_EQ(reported([&] { run({{2, 2}, {t}}); }), "");
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46);
}

// In the middle of a group that is looked at together, and first and last in it.
TEST_F(RasterTopReports, TrianglesBeforeOneOutOfRangeAreDrawn) {
  for (const size_t faulty : {1, 7, 15, 16, 17, 31}) {
    Scene scene{{64, 64}, {}};
    for (int i = 0; i < 40; ++i) {
      scene.triangles.push_back(flat_triangle(i, i, i + 3, i, i, i + 3));
      scene.triangles.back().id = static_cast<uint32_t>(i);
    }
    Scene before{scene.frame, {}};
    before.triangles.assign(scene.triangles.begin(),
                            scene.triangles.begin() + static_cast<std::ptrdiff_t>(faulty));
    top_.run(before.frame, before.triangles);
    const core::FrameBuffer expected = top_.buffer();
    scene.triangles[faulty].v[1].y = INT32_MIN;
    EXPECT_EQ(reported([&] { top_.run(scene.frame, scene.triangles); }),
              "pineda/raster_top/vertex: triangle " + std::to_string(faulty) +
                  ", v[1].y: expected -4194304 to 4194303, got -2147483648");
    EXPECT_EQ(top_.buffer().depth, expected.depth);
    EXPECT_EQ(top_.buffer().color, expected.color);
  }
}

TEST(RasterTopErrors, InverseWAndFlatAttributesHaveRanges) {
  spec::Design design = *spec::find_design("persp");
  design.flat_attributes = 1;
  timing::RasterTop top("top", spec::contract(design));
  const auto last = static_cast<size_t>(design.attributes);
  spec::Triangle good = cover();
  for (auto& v : good.v) v.inverse_w = 1 << (design.inverse_w_bits - 1);
  good.v[1].attr[last] = -1;  // of vertex 0 alone
  const auto report = [&](const spec::Triangle& t) {
    const std::string text = reported([&] { top.run({2, 2}, std::vector{t}); });
    return text.substr(0, text.find(" expected"));
  };
  EXPECT_EQ(report(good), "");
  spec::Triangle t = good;
  t.v[0].attr[last] = 1 << design.attribute_bits;
  EXPECT_EQ(report(t),
            "pineda/raster_top/vertex: triangle 0, v[0].attr[" + std::to_string(last) + "]:");
  t = good;
  t.v[1].inverse_w -= 1;
  EXPECT_EQ(report(t), "pineda/raster_top/vertex: triangle 0, v[1].inverse_w:");
  t.v[1].inverse_w = 1 << design.inverse_w_bits;
  EXPECT_EQ(report(t), "pineda/raster_top/vertex: triangle 0, v[1].inverse_w:");
  t = good;
  t.v[2].inverse_w_shift = 256;
  EXPECT_EQ(report(t), "pineda/raster_top/vertex: triangle 0, v[2].inverse_w_shift:");
  t = good;
  for (auto& v : t.v) v.inverse_w_shift = 1;
  EXPECT_EQ(report(t), "pineda/raster_top/vertex: triangle 0, inverse_w_shift:");
}

TEST(RasterTopErrors, DesignThatCannotBeIsRefused) {
  spec::Design design = spec::kHighTile;
  design.tile_log2 = 40;
  EXPECT_EQ(reported([&] { timing::RasterTop("top", spec::contract(design)); }),
            "pineda/raster_top/design: high_tile: " + spec::invalid_reason(design));
  const spec::Contract exact = spec::contract(*spec::find_design("exact"));
  EXPECT_EQ(reported([&] { timing::RasterTop("top", exact); }),
            "pineda/raster_top/design: exact: " + spec::no_cycles_reason(exact.design));
}

// Draws a second frame when the first token of the first one is heard.
struct Meddler final : timing::Listener {
  timing::RasterTop* top = nullptr;
  std::string text;
  void stamp(Cycle, const spec::Stamp&) override {
    if (text.empty()) text = reported([&] { top->run({2, 2}, std::vector{cover()}); });
  }
};

TEST_F(RasterTopReports, RunWithinARunIsRefused) {
  Meddler meddler;
  meddler.top = &top_;
  EXPECT_EQ(top_.run({2, 2}, std::vector{cover()}, &meddler).cycles, 46);
  EXPECT_EQ(meddler.text, "pineda/raster_top/busy: top draws a frame already");
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46);
}

// A handler that only notes errors: the frame ends before the fault, and says so by what it counts.
TEST_F(RasterTopReports, HandlerThatDoesNotThrowLeavesACleanRasterizer) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_ERROR, sc_core::SC_CACHE_REPORT);
  Scene scene{{2, 2}, {cover(1000), cover(999), cover(998)}};
  scene.triangles[1].v[0].z = -1;
  EXPECT_EQ(top_.run(scene.frame, scene.triangles).counters.triangles, 1u);
  EXPECT_EQ(top_.buffer().depth[0], 1000u);
  EXPECT_EQ(sc_core::sc_report_handler::get_count(sc_core::SC_ERROR), 1);
  EXPECT_EQ(run({{0, 2}, {cover()}}).cycles, 0);
  Meddler meddler;
  meddler.top = &top_;
  EXPECT_EQ(top_.run({2, 2}, std::vector{cover()}, &meddler).cycles, 46);
  EXPECT_EQ(sc_core::sc_report_handler::get_count(sc_core::SC_ERROR), 2 + 1);
  EXPECT_THROW(timing::RasterTop("second", spec::contract(*spec::find_design("exact"))),
               std::invalid_argument);
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46);
}

// Stamp by stamp, where writes are still under way when the pull throws.
TEST_F(RasterTopReports, TrianglesBeforeAFailureAreDrawnOnAnyMemory) {
  top_.set_memory(memory::make_timing(memory::Kind::kDram, kContract, 8));
  int left = 1;
  const auto pull = [&left](spec::Triangle* t) {
    if (left-- == 0) throw std::runtime_error("line 3: expected a number");
    *t = cover();
    return true;
  };
  EXPECT_THROW(top_.run({2, 2}, pull), std::runtime_error);
  EXPECT_EQ(top_.buffer().depth[0], 1000u);
}

TEST_F(RasterTopReports, FailureOfThePullComesBackAndTheNextFrameIsClean) {
  int left = 2;
  const auto pull = [&left](spec::Triangle* t) {
    if (left-- == 0) throw std::runtime_error("line 3: expected a number");
    *t = cover();
    return true;
  };
  EXPECT_THROW(top_.run({2, 2}, pull), std::runtime_error);
  EXPECT_EQ(left, -1);
  EXPECT_EQ(top_.buffer().depth[0], 1000u);  // the triangles before it are drawn
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46);
}

}  // namespace
}  // namespace pineda::test
