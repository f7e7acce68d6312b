// libFuzzer on the C interface: calls in any order, on values that are mostly near the ends of their formats.
// Nothing may crash; a frame that was accepted is that of core, and holds before the exact judge.
#include <fuzzer/FuzzedDataProvider.h>
#include <pineda/golden.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "model/core/frame.h"
#include "model/scene/state.h"
#include "model/spec/bounds.h"

namespace {

using namespace pineda;  // NOLINT: a program, not a header

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "ERROR: %s (%s)\n", what, pineda_last_error());
  std::abort();
}

class Caller {
 public:
  Caller(const uint8_t* data, size_t size) : data_(data, size) {
    constexpr const char* kDesigns[] = {"high_tile", "persp", "tiny", "wide", "flat", "low"};
    design_ = kDesigns[data_.ConsumeIntegralInRange<size_t>(0, 5)];
    require(pineda_open(design_, &model_) == PINEDA_OK, "a named design opens");
    require(pineda_get_design(model_, &formats_) == PINEDA_OK, "a design has formats");
  }
  ~Caller() { pineda_close(model_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  void run() {
    while (data_.remaining_bytes() > 0) {
      switch (data_.ConsumeIntegralInRange<int>(0, 6)) {
        case 0:
          begin();
          break;
        case 1:
          draw_snapped();
          break;
        case 2:
          draw_screen();
          break;
        case 3:
          walk_units();
          break;
        case 4:
          raw_structs();
          break;
        case 5:
          packed();
          break;
        case 6:
          compare();
          break;
      }
    }
    compare();
  }

 private:
  /// Mostly in [low, high], often at an end, sometimes anything.
  int64_t near(int64_t low, int64_t high) {
    switch (data_.ConsumeIntegralInRange<int>(0, 31)) {
      case 0:
        return data_.ConsumeIntegral<int64_t>();
      case 1:
        return low + data_.ConsumeIntegralInRange<int>(-1, 1);
      case 2:
        return high + data_.ConsumeIntegralInRange<int>(-1, 1);
      default:
        return data_.ConsumeIntegralInRange<int64_t>(low, high);
    }
  }
  int32_t near32(int64_t low, int64_t high) { return static_cast<int32_t>(near(low, high)); }
  float near_float(float low, float high) {
    switch (data_.ConsumeIntegralInRange<int>(0, 15)) {
      case 0: {
        const auto bits = data_.ConsumeIntegral<uint32_t>();
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      case 1:
        return data_.ConsumeBool() ? low : high;
      default:
        return data_.ConsumeFloatingPointInRange<float>(low, high);
    }
  }

  void begin() {
    pineda_frame frame = pineda_default_frame(near32(1, 48), near32(1, 48));
    if (frame.width > 64 || frame.height > 64) frame.width = frame.height = 64;  // quick ones
    frame.cull = near32(0, 2);
    frame.depth_func = near32(0, 8);
    frame.depth_write = near32(0, 1);
    frame.shade = near32(0, 1);
    frame.has_scissor = near32(0, 1);
    frame.scissor_x = near32(-8, 64);
    frame.scissor_y = near32(-8, 64);
    frame.scissor_width = near32(0, 64);
    frame.scissor_height = near32(0, 64);
    if (data_.ConsumeBool()) {
      frame.bias_slope = near32(-32768, 32767);
      frame.bias_constant = near(-65535, 65535);
    }
    frame.clear_depth = static_cast<double>(near_float(0, 1));
    if (pineda_begin_frame(model_, &frame) != PINEDA_OK) return;
    frame_ = frame;
    has_frame_ = true;
    snapped_.clear();
    screen_.clear();
    is_screen_alone_ = true;
  }

  pineda_triangle triangle() {
    pineda_triangle t{};
    const int64_t limit = int64_t{1} << (formats_.guard_bits + formats_.subpixel_bits);
    const int64_t close = int64_t{64} << formats_.subpixel_bits;
    for (pineda_vertex& v : t.v) {
      const int64_t reach = data_.ConsumeBool() ? close : limit;
      v.x = near32(reach == close ? 0 : -limit, reach - 1);
      v.y = near32(reach == close ? 0 : -limit, reach - 1);
      v.z = near(0, ((int64_t{1} << formats_.depth_bits) - 1) << 8);
      for (int32_t& a : v.attr) a = near32(0, (1 << formats_.attribute_bits) - 1);
      if (formats_.perspective == 0) continue;
      v.inverse_w = near32(1 << (formats_.inverse_w_bits - 1), (1 << formats_.inverse_w_bits) - 1);
      v.inverse_w_shift = near32(0, 3);
    }
    return t;
  }

  void draw_snapped() {
    const pineda_triangle t = triangle();
    if (pineda_draw(model_, &t, 1) != PINEDA_OK) return;
    require(has_frame_, "no triangle is drawn without a frame");
    snapped_.push_back(t);
    is_screen_alone_ = false;
  }

  void draw_screen() {
    pineda_screen_triangle t{};
    const float limit = std::ldexp(1.f, formats_.guard_bits);
    for (pineda_screen_vertex& v : t.v) {
      const bool is_close = data_.ConsumeBool();
      v.x = near_float(is_close ? 0 : -limit, is_close ? 64 : limit);
      v.y = near_float(is_close ? 0 : -limit, is_close ? 64 : limit);
      v.z = near_float(0, 1);
      v.w = data_.ConsumeBool() ? 1 : near_float(.5f, 2);
      for (uint8_t& c : v.rgba) c = data_.ConsumeIntegral<uint8_t>();
    }
    pineda_triangle snapped{};
    const pineda_status status = pineda_snap(model_, &t, &snapped);
    if (!has_frame_) return;
    require(pineda_draw_screen(model_, &t, 1) == status, "what can be snapped can be drawn");
    if (status != PINEDA_OK) return;
    snapped_.push_back(snapped);
    screen_.push_back(t);
  }

  void walk_units() {
    const pineda_triangle t = triangle();
    pineda_setup_prim prim;
    pineda_drop drop;
    const pineda_frame frame = has_frame_ ? frame_ : pineda_default_frame(32, 32);
    if (pineda_setup(model_, &frame, &t, &prim, &drop) != PINEDA_OK || drop != PINEDA_KEPT) return;
    std::vector<pineda_stamp> stamps(4096);
    size_t count = 0;
    require(pineda_traverse(model_, &prim, stamps.data(), stamps.size(), &count) == PINEDA_OK,
            "traversal takes what setup makes");
    for (size_t i = 0; i < count; ++i) {
      pineda_fragment fragment;
      require(pineda_interpolate(model_, &stamps[i], &fragment) == PINEDA_OK,
              "interpolation takes what traversal makes");
      uint32_t passed = 0;
      if (formats_.depth_bits == 0) continue;
      require(pineda_depth_test(model_, frame.depth_func, stamps[i].mask, fragment.z, fragment.z,
                                &passed) == PINEDA_OK,
              "the depth test takes what interpolation makes");
    }
  }

  template <class T>
  T raw() {
    T value{};
    data_.ConsumeData(&value, sizeof value);
    return value;
  }
  void raw_structs() {
    const auto prim = raw<pineda_setup_prim>();
    const auto stamp = raw<pineda_stamp>();
    size_t count = 0;
    std::vector<pineda_stamp> stamps(16);
    // A legal box of the whole guard band has millions of stamps.
    if (std::abs(int64_t{prim.x1} - prim.x0) < 256 && std::abs(int64_t{prim.y1} - prim.y0) < 256) {
      (void)pineda_traverse(model_, &prim, stamps.data(), stamps.size(), &count);
    }
    pineda_fragment fragment;
    (void)pineda_interpolate(model_, &stamp, &fragment);
  }

  void packed() {
    const int32_t kind = near32(0, 3);
    size_t bits = 0;
    if (pineda_packed_bits(model_, kind, &bits) != PINEDA_OK) return;
    std::vector<uint32_t> words((bits + 31) / 32), again(words.size());
    for (uint32_t& word : words) word = data_.ConsumeIntegral<uint32_t>();
    union {
      pineda_frame frame;
      pineda_triangle triangle;
      pineda_setup_prim prim;
      pineda_stamp stamp;
    } value;
    require(pineda_unpack(model_, kind, words.data(), words.size(), &value) == PINEDA_OK,
            "any bits are a struct");
    if (pineda_pack(model_, kind, &value, again.data(), again.size()) != PINEDA_OK) return;
    if (kind == PINEDA_PACKED_FRAME) return;  // a clear depth has more than one number
    if (bits % 32 != 0) words.back() &= (uint32_t{1} << bits % 32) - 1;
    require(words == again, "what is packed is what was unpacked");
  }

  /// The model's frame against core's, and before the judge where all triangles are the screen's.
  void compare() {
    if (!has_frame_) return;
    const spec::Contract contract = spec::contract(*spec::find_design(design_));
    core::Renderer reference(contract, state());
    for (const pineda_triangle& t : snapped_) {
      spec::Triangle triangle;
      static_assert(sizeof triangle == sizeof t);
      std::memcpy(static_cast<void*>(&triangle), &t, sizeof t);
      reference.draw(triangle);
    }
    const core::FrameBuffer& expected = reference.buffer();
    std::vector<uint16_t> hits(expected.hits.size()), color(expected.color.size());
    std::vector<uint32_t> depth(expected.depth.size());
    require(pineda_read_hits(model_, hits.data(), hits.size()) == PINEDA_OK, "hits");
    require(pineda_read_color(model_, color.data(), color.size()) == PINEDA_OK, "colours");
    require(hits == expected.hits && color == expected.color, "hits and colours are those of core");
    const bool has_depth = formats_.depth_bits > 0;
    if (has_depth) {
      require(pineda_read_depth(model_, depth.data(), depth.size()) == PINEDA_OK, "depths");
      require(depth == expected.depth, "depths are those of core");
    }
    if (!is_screen_alone_ || frame_.bias_slope != 0 || frame_.bias_constant != 0) return;
    const pineda_tolerance tolerance{formats_.subpixel_bits, formats_.guard_bits,
                                     has_depth ? formats_.depth_bits : 24,
                                     spec::error_bounds(contract.design).depth_ulp, 255};
    const pineda_dump dump{hits.data(), has_depth ? depth.data() : nullptr, nullptr, hits.size()};
    pineda_verdict verdict;
    require(pineda_judge(&frame_, &tolerance, screen_.data(), screen_.size(), &dump, &verdict,
                         nullptr) == PINEDA_OK,
            "what is drawn can be judged");
    require(verdict.samples_wrong == 0, verdict.what);
  }

  spec::FrameState state() const {
    spec::FrameState state{frame_.width, frame_.height, static_cast<spec::Cull>(frame_.cull),
                           static_cast<spec::DepthFunc>(frame_.depth_func)};
    state.depth_write = frame_.depth_write != 0;
    state.shade = static_cast<spec::Shade>(frame_.shade);
    if (frame_.has_scissor != 0) {
      scene::set_scissor(frame_.scissor_x, frame_.scissor_y, frame_.scissor_width,
                         frame_.scissor_height, &state);
    }
    state.bias_constant = frame_.bias_constant;
    state.bias_slope = frame_.bias_slope;
    state.clear_depth = frame_.clear_depth;
    return state;
  }

  FuzzedDataProvider data_;
  const char* design_;
  pineda_model* model_ = nullptr;
  pineda_design formats_{};
  pineda_frame frame_{};
  bool has_frame_ = false;
  bool is_screen_alone_ = true;
  std::vector<pineda_triangle> snapped_;
  std::vector<pineda_screen_triangle> screen_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Caller(data, size).run();
  return 0;
}
