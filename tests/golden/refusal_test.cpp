// What the C interface refuses, and that nothing is changed then.
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <new>

#include "tests/golden/support.h"

namespace {

// Allocations until one fails; negative: none does.
thread_local int64_t allocations_left = -1;
thread_local bool has_failed = false;

}  // namespace

// Of the library too, which finds these by their names.
void* operator new(size_t size) {
  if (allocations_left == 0) {
    has_failed = true;
    throw std::bad_alloc();
  }
  if (allocations_left > 0) --allocations_left;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }

namespace pineda::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class GoldenRefuses : public testing::Test {
 protected:
  GoldenRefuses() : scene_(spec::contract(spec::kHighTile), "hard/fan") {
    frame_ = stated(scene_.frame);
    begin();
  }

  void begin() {
    EXPECT_OK(pineda_begin_frame(model_.get(), &frame_));
    EXPECT_OK(pineda_draw(model_.get(), scene_.triangles.data(), scene_.triangles.size()));
  }
  void expect_unchanged() {
    std::vector<uint32_t> depth(scene_.buffer.depth.size());
    ASSERT_OK(pineda_read_depth(model_.get(), depth.data(), depth.size()));
    EXPECT_EQ(depth, scene_.buffer.depth);
  }
  void expect(pineda_status got, pineda_status status, const std::string& error) {
    EXPECT_EQ(got, status) << error;
    EXPECT_EQ(std::string(pineda_last_error()), error);
    expect_unchanged();
  }

  DrawnScene scene_;
  pineda_frame frame_{};
  const Model model_ = open_model("high_tile");
};

TEST_F(GoldenRefuses, FrameOutOfRange) {
  struct Case {
    std::function<void(pineda_frame*)> spoil;
    const char* error;
  };
  const Case cases[] = {
      {[](auto* f) { f->width = 0; }, "frame.width: expected 1 to 16384, got 0"},
      {[](auto* f) { f->height = 16385; }, "frame.height: expected 1 to 16384, got 16385"},
      {[](auto* f) { f->cull = 3; }, "frame.cull: expected 0 to 2, got 3"},
      {[](auto* f) { f->depth_func = -1; }, "frame.depth_func: expected 0 to 8, got -1"},
      {[](auto* f) { f->shade = 2; }, "frame.shade: expected 0 to 1, got 2"},
      {[](auto* f) { f->depth_write = 2; }, "frame.depth_write: expected 0 to 1, got 2"},
      {[](auto* f) { f->scissor_width = -1; },
       "frame.scissor_width: expected 0 to 2147483647, got -1"},
      {[](auto* f) { f->bias_constant = 1 << 24; },
       "frame.bias_constant: expected -16777215 to 16777215, got 16777216"},
      {[](auto* f) { f->bias_slope = 32768; },
       "frame.bias_slope: expected -32768 to 32767, got 32768"},
      {[](auto* f) { f->clear_depth = kNan; }, "frame.clear_depth: expected 0 to 1, got nan"},
  };
  for (const Case& one : cases) {
    pineda_frame frame = frame_;
    one.spoil(&frame);
    expect(pineda_begin_frame(model_.get(), &frame), PINEDA_OUT_OF_RANGE, one.error);
  }
}

TEST_F(GoldenRefuses, SnappedTriangleOutOfRange) {
  struct Case {
    std::function<void(pineda_vertex*)> spoil;
    const char* error;
  };
  const Case cases[] = {
      {[](auto* v) { v->x = 1 << 22; },
       "triangles[1].v[2].x: expected -4194304 to 4194303, got 4194304"},
      {[](auto* v) { v->y = -(1 << 22) - 1; },
       "triangles[1].v[2].y: expected -4194304 to 4194303, got -4194305"},
      {[](auto* v) { v->z = int64_t{1} << 32; },
       "triangles[1].v[2].z: expected 0 to 4294967040, got 4294967296"},
      {[](auto* v) { v->z = -1; }, "triangles[1].v[2].z: expected 0 to 4294967040, got -1"},
      {[](auto* v) { v->attr[3] = 256; }, "triangles[1].v[2].attr[3]: expected 0 to 255, got 256"},
  };
  for (const Case& one : cases) {
    pineda_triangle triangles[2] = {scene_.triangles[0], scene_.triangles[1]};
    one.spoil(&triangles[1].v[2]);
    expect(pineda_draw(model_.get(), triangles, 2), PINEDA_OUT_OF_RANGE, one.error);
  }
}

TEST_F(GoldenRefuses, InverseWOutOfRange) {
  const DrawnScene scene(spec::contract(*spec::find_design("persp")), "hard/near_plane");
  const Model model = open_model("persp");
  pineda_triangle triangle = scene.triangles[0];
  const pineda_frame frame = stated(scene.frame);
  ASSERT_OK(pineda_begin_frame(model.get(), &frame));
  ASSERT_OK(pineda_draw(model.get(), &triangle, 1));
  triangle.v[0].inverse_w >>= 1;
  EXPECT_EQ(pineda_draw(model.get(), &triangle, 1), PINEDA_OUT_OF_RANGE);
  triangle = scene.triangles[0];
  for (pineda_vertex& v : triangle.v) v.inverse_w_shift = 1;
  EXPECT_EQ(pineda_draw(model.get(), &triangle, 1), PINEDA_OUT_OF_RANGE);
  EXPECT_EQ(std::string(pineda_last_error()),
            "triangles[0].inverse_w_shift: expected 0 at one of the vertices");
}

TEST_F(GoldenRefuses, ScreenTriangleOutOfRange) {
  struct Case {
    std::function<void(pineda_screen_vertex*)> spoil;
    const char* error;
  };
  const Case cases[] = {
      {[](auto* v) { v->x = kNan; },
       "triangles[0].v[1].x, snapped: expected -16384 to 16383.99609375, got nan"},
      {[](auto* v) { v->y = kInfinity; },
       "triangles[0].v[1].y, snapped: expected -16384 to 16383.99609375, got inf"},
      {[](auto* v) { v->x = 16383.999f; },
       "triangles[0].v[1].x, snapped: expected -16384 to 16383.99609375, got 16384"},
      {[](auto* v) { v->z = kNan; }, "triangles[0].v[1].z: expected 0 to 1, got nan"},
      {[](auto* v) { v->z = 1.5; }, "triangles[0].v[1].z: expected 0 to 1, got 1.5"},
      {[](auto* v) { v->w = kNan; },
       "triangles[0].v[1].w: expected a normal number above 0, got nan"},
      {[](auto* v) { v->w = -1; }, "triangles[0].v[1].w: expected a normal number above 0, got -1"},
      {[](auto* v) { v->w = 1e-40f; },
       "triangles[0].v[1].w: expected a normal number above 0, got 1e-40"},
  };
  for (const Case& one : cases) {
    pineda_screen_triangle triangle = scene_.screen[0];
    one.spoil(&triangle.v[1]);
    expect(pineda_draw_screen(model_.get(), &triangle, 1), PINEDA_OUT_OF_RANGE, one.error);
  }
  std::fesetround(FE_UPWARD);
  const pineda_status status = pineda_draw_screen(model_.get(), scene_.screen.data(), 1);
  std::fesetround(FE_TONEAREST);
  expect(status, PINEDA_OUT_OF_RANGE, "triangles[0].rounding: expected to nearest, in this thread");
}

TEST_F(GoldenRefuses, UnitInputsOutOfRange) {
  pineda_setup_prim prim;
  pineda_drop drop;
  ASSERT_OK(pineda_setup(model_.get(), &frame_, &scene_.triangles[0], &prim, &drop));
  ASSERT_EQ(drop, PINEDA_KEPT);
  size_t count = 0;
  EXPECT_EQ(pineda_traverse(model_.get(), &prim, nullptr, 0, &count), PINEDA_WRONG_SIZE);
  ASSERT_GT(count, 0U);
  std::vector<pineda_stamp> stamps(count);
  ASSERT_OK(pineda_traverse(model_.get(), &prim, stamps.data(), count, &count));

  pineda_setup_prim bad = prim;
  bad.edge[1].a = 1 << 23;
  expect(pineda_traverse(model_.get(), &bad, stamps.data(), count, &count), PINEDA_OUT_OF_RANGE,
         "a[1]: expected -8388608 to 8388607, got 8388608");
  bad = prim;
  bad.x0 = bad.x1 + 1;
  EXPECT_EQ(pineda_traverse(model_.get(), &bad, stamps.data(), count, &count), PINEDA_OUT_OF_RANGE);
  bad = prim;
  bad.planes.z_steep = 2;
  EXPECT_EQ(pineda_traverse(model_.get(), &bad, stamps.data(), count, &count), PINEDA_OUT_OF_RANGE);

  pineda_fragment fragment;
  pineda_stamp stamp = stamps[0];
  stamp.mask = 0;
  expect(pineda_interpolate(model_.get(), &stamp, &fragment), PINEDA_OUT_OF_RANGE,
         "mask: expected 1 to 15, got 0");
  stamp = stamps[0];
  stamp.planes.z.dx = int64_t{1} << 43;
  EXPECT_EQ(pineda_interpolate(model_.get(), &stamp, &fragment), PINEDA_OUT_OF_RANGE);

  uint32_t codes[PINEDA_MAX_LANES] = {}, passed = 0;
  EXPECT_EQ(pineda_depth_test(model_.get(), 9, 1, codes, codes, &passed), PINEDA_OUT_OF_RANGE);
  EXPECT_EQ(pineda_depth_test(model_.get(), PINEDA_DEPTH_LESS, 16, codes, codes, &passed),
            PINEDA_OUT_OF_RANGE);
  codes[2] = 1 << 24;
  expect(pineda_depth_test(model_.get(), PINEDA_DEPTH_LESS, 1, codes, codes, &passed),
         PINEDA_OUT_OF_RANGE, "z: expected 0 to 16777215, got 16777216");
}

TEST_F(GoldenRefuses, NullPointers) {
  pineda_model* none = nullptr;
  expect(pineda_open(nullptr, &none), PINEDA_NULL_POINTER, "design: expected a pointer, got null");
  expect(pineda_open("low", nullptr), PINEDA_NULL_POINTER, "model: expected a pointer, got null");
  expect(pineda_begin_frame(nullptr, &frame_), PINEDA_NULL_POINTER,
         "model: expected a pointer, got null");
  expect(pineda_begin_frame(model_.get(), nullptr), PINEDA_NULL_POINTER,
         "frame: expected a pointer, got null");
  expect(pineda_draw(model_.get(), nullptr, 1), PINEDA_NULL_POINTER,
         "triangles: expected a pointer, got null");
  EXPECT_OK(pineda_draw(model_.get(), nullptr, 0));
  EXPECT_EQ(pineda_read_hits(model_.get(), nullptr, 1), PINEDA_NULL_POINTER);
  EXPECT_EQ(pineda_pack(model_.get(), PINEDA_PACKED_FRAME, nullptr, nullptr, 0),
            PINEDA_NULL_POINTER);
  EXPECT_EQ(pineda_judge(nullptr, nullptr, nullptr, 0, nullptr, nullptr, nullptr),
            PINEDA_NULL_POINTER);
  pineda_close(nullptr);
}

TEST_F(GoldenRefuses, SizesAndOrder) {
  uint16_t hits[1];
  expect(pineda_read_hits(model_.get(), hits, 1), PINEDA_WRONG_SIZE,
         "hits: expected 6144 values, got 1");
  uint32_t words[1];
  EXPECT_EQ(pineda_pack(model_.get(), PINEDA_PACKED_FRAME, &frame_, words, 1), PINEDA_WRONG_SIZE);
  EXPECT_EQ(pineda_pack(model_.get(), 4, &frame_, words, 1), PINEDA_OUT_OF_RANGE);
  const Model fresh = open_model("low");
  EXPECT_EQ(pineda_draw(fresh.get(), scene_.triangles.data(), 1), PINEDA_NO_FRAME);
  EXPECT_EQ(pineda_read_hits(fresh.get(), hits, 1), PINEDA_NO_FRAME);
}

TEST_F(GoldenRefuses, Designs) {
  pineda_model* none = nullptr;
  EXPECT_EQ(pineda_open("hihg_tile", &none), PINEDA_NO_DESIGN);
  EXPECT_NE(std::string(pineda_last_error()).find("got 'hihg_tile'"), std::string::npos);
  expect(pineda_open_toml("depth_bits = 40\n", "mine", &none), PINEDA_NO_DESIGN,
         "mine:1: expected a design that can be built: depth_bits is 40, must be 16 to 32");
  EXPECT_EQ(pineda_open_toml("base = [", "mine", &none), PINEDA_NO_DESIGN);
  EXPECT_EQ(none, nullptr);
}

TEST_F(GoldenRefuses, LongTextsAreCut) {
  pineda_model* none = nullptr;
  EXPECT_EQ(pineda_open(std::string(100000, 'x').c_str(), &none), PINEDA_NO_DESIGN);
  EXPECT_EQ(std::strlen(pineda_last_error()), 511U);
}

TEST(Golden, StatusAndVersionAreTold) {
  EXPECT_EQ(pineda_abi(), PINEDA_GOLDEN_ABI);
  EXPECT_EQ(std::string(pineda_version()), PINEDA_VERSION);
  for (int i = PINEDA_OK; i <= PINEDA_INTERNAL; ++i) {
    EXPECT_NE(std::string(pineda_status_text(i)), "no status");
  }
  EXPECT_EQ(std::string(pineda_status_text(99)), "no status");
}

/// Runs a call with ever more allocations until none fails; each that fails must say so.
template <class Call>
int failures_of(Call&& call) {
  for (int failing = 0;; ++failing) {
    allocations_left = failing;
    has_failed = false;
    const pineda_status status = call();
    allocations_left = -1;
    if (status == PINEDA_OK) {
      EXPECT_FALSE(has_failed);
      return failing;
    }
    EXPECT_EQ(status, PINEDA_OUT_OF_MEMORY) << pineda_last_error();
    if (status != PINEDA_OUT_OF_MEMORY) return failing;
  }
}

TEST(Golden, EachAllocationMayFail) {
  const DrawnScene scene(spec::contract(spec::kHighTile), "hard/fan");
  const pineda_frame frame = stated(scene.frame);
  pineda_model* opened = nullptr;
  EXPECT_GT(failures_of([&] { return pineda_open("high_tile", &opened); }), 0);
  const Model model(opened);
  pineda_model* other = nullptr;
  EXPECT_GT(failures_of([&] { return pineda_open_toml("base = \"low\"\n", "x", &other); }), 5);
  pineda_close(other);
  EXPECT_GT(failures_of([&] { return pineda_begin_frame(opened, &frame); }), 2);
  EXPECT_GT(failures_of([&] {
              return pineda_draw(opened, scene.triangles.data(), scene.triangles.size());
            }),
            0);
  EXPECT_GT(failures_of([&] {
              return pineda_draw_screen(opened, scene.screen.data(), scene.screen.size());
            }),
            10);
  std::vector<uint16_t> hits(scene.buffer.hits.size());
  EXPECT_GT(failures_of([&] { return pineda_read_hits(opened, hits.data(), hits.size()); }), 2);
  for (size_t i = 0; i < hits.size(); ++i) ASSERT_EQ(hits[i], 2 * scene.buffer.hits[i]);

  const pineda_tolerance tolerance = pineda_default_tolerance();
  const pineda_dump dump{scene.buffer.hits.data(), nullptr, nullptr, hits.size()};
  pineda_verdict verdict;
  EXPECT_GT(failures_of([&] {
              return pineda_judge(&frame, &tolerance, scene.screen.data(), 8, &dump, &verdict,
                                  nullptr);
            }),
            10);
}

}  // namespace
}  // namespace pineda::test
