#include "golden/ranges.h"

#include <cfenv>
#include <cmath>
#include <iterator>

#include "golden/structs.h"
#include "model/scene/state.h"
#include "model/spec/triangle_range.h"

namespace pineda::golden {
namespace {

constexpr int64_t kMaxInt32 = INT32_MAX;

/// 2^bits
constexpr int64_t power(int bits) { return int64_t{1} << bits; }

/// Refuses a number outside [low, high], and NaN.
void require_real(double value, double low, double high, const char* name) {
  if (value >= low && value <= high) return;
  refuse(PINEDA_OUT_OF_RANGE, "{}: expected {} to {}, got {}", name, low, high, value);
}

/// Refuses a struct with a field that its bits do not hold.
template <class T>
void require_fields(const spec::Contract& contract, const T& value) {
  for (const spec::Field<T>& field : spec::fields<T>(contract)) {
    const int64_t low = field.is_signed ? -power(field.bits - 1) : 0;
    const int64_t high = power(field.bits - (field.is_signed ? 1 : 0)) - 1;
    for (int i = 0; i < field.count; ++i) {
      const int64_t number = field.get(contract, value, i);
      if (number < low || number > high) {
        require(number, low, high, fmt::format("{}[{}]", field.name, i).c_str());
      }
    }
  }
}

/// 0 or 1, since it becomes a bool.
void require_flag(int64_t value, const char* name) { require(value, 0, 1, name); }

}  // namespace

void require(int64_t value, int64_t low, int64_t high, const char* name) {
  if (value >= low && value <= high) return;
  refuse(PINEDA_OUT_OF_RANGE, "{}: expected {} to {}, got {}", name, low, high, value);
}

void require_lanes(const spec::Contract& contract, uint32_t mask) {
  require(mask, 0, power(contract.width.lanes) - 1, "mask");
}

spec::FrameState frame_of(const pineda_frame* frame, int guard_bits, int depth_bits) {
  require_pointer(frame, "frame");
  const auto last = [](const auto& names) { return static_cast<int64_t>(std::size(names)) - 1; };
  require(frame->width, 1, power(guard_bits), "frame.width");
  require(frame->height, 1, power(guard_bits), "frame.height");
  require(frame->cull, 0, last(spec::kCullNames), "frame.cull");
  require(frame->depth_func, 0, last(spec::kDepthFuncNames), "frame.depth_func");
  require(frame->shade, 0, last(spec::kShadeNames), "frame.shade");
  require_flag(frame->depth_write, "frame.depth_write");
  require_flag(frame->has_scissor, "frame.has_scissor");
  const int64_t greatest_bias = power(depth_bits) - 1;
  require(frame->bias_constant, -greatest_bias, greatest_bias, "frame.bias_constant");
  require(frame->bias_slope, INT16_MIN, INT16_MAX, "frame.bias_slope");
  require_real(frame->clear_depth, 0, 1, "frame.clear_depth");
  spec::FrameState state;
  state.width = frame->width;
  state.height = frame->height;
  state.cull = static_cast<spec::Cull>(frame->cull);
  state.depth = static_cast<spec::DepthFunc>(frame->depth_func);
  state.depth_write = frame->depth_write != 0;
  state.shade = static_cast<spec::Shade>(frame->shade);
  state.bias_constant = frame->bias_constant;
  state.bias_slope = frame->bias_slope;
  state.clear_depth = frame->clear_depth;
  if (frame->has_scissor != 0) {
    require(frame->scissor_width, 0, kMaxInt32, "frame.scissor_width");
    require(frame->scissor_height, 0, kMaxInt32, "frame.scissor_height");
    scene::set_scissor(frame->scissor_x, frame->scissor_y, frame->scissor_width,
                       frame->scissor_height, &state);
  }
  return state;
}

spec::Triangle triangle_of(const spec::Contract& contract, const pineda_triangle& triangle) {
  const auto result = same<spec::Triangle>(triangle);
  const spec::TriangleRange range(contract);
  if (!range.holds(result)) refuse(PINEDA_OUT_OF_RANGE, "{}", range.reason(result));
  return result;
}

scene::ScreenTriangle screen_of(const exact::Format& format,
                                const pineda_screen_triangle& triangle) {
  if (std::fegetround() != FE_TONEAREST) {
    refuse(PINEDA_OUT_OF_RANGE, "rounding: expected to nearest, in this thread");
  }
  const double limit = std::ldexp(1, format.guard_bits);
  const double step = std::ldexp(1, -format.subpixel_bits);
  scene::ScreenTriangle result;
  result.id = triangle.id;
  for (size_t i = 0; i < 3; ++i) {
    const pineda_screen_vertex& v = triangle.v[i];
    checked("v", i, [&] {
      require_real(std::nearbyint(v.x / step) * step, -limit, limit - step, "x, snapped");
      require_real(std::nearbyint(v.y / step) * step, -limit, limit - step, "y, snapped");
      require_real(v.z, 0, 1, "z");
      if (!std::isnormal(v.w) || v.w <= 0) {
        refuse(PINEDA_OUT_OF_RANGE, "w: expected a normal number above 0, got {}", v.w);
      }
    });
    result.v[i] = {v.x, v.y, v.z, v.w, {v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]}};
  }
  return result;
}

spec::SetupPrim prim_of(const spec::Contract& contract, const pineda_setup_prim& prim) {
  require_flag(prim.planes.z_steep, "planes.z_steep");
  const auto result = same<spec::SetupPrim>(prim);
  require_fields(contract, result);
  require(prim.x0, 0, prim.x1, "x0");
  require(prim.y0, 0, prim.y1, "y0");
  return result;
}

spec::Stamp stamp_of(const spec::Contract& contract, const pineda_stamp& stamp) {
  require_flag(stamp.planes.z_steep, "planes.z_steep");
  require_flag(stamp.first, "first");
  const auto result = same<spec::Stamp>(stamp);
  require_fields(contract, result);
  require(stamp.mask, 1, power(contract.width.lanes) - 1, "mask");
  return result;
}

}  // namespace pineda::golden
