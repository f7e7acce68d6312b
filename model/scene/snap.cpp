#include "model/scene/snap.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pineda::scene {
namespace {

bool is_denormal(float value) { return std::fpclassify(value) == FP_SUBNORMAL; }

bool has_nan(const ScreenTriangle& triangle) {
  return std::any_of(triangle.v.begin(), triangle.v.end(), [](const ScreenVertex& v) {
    return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z) || std::isnan(v.w);
  });
}

}  // namespace

int32_t snap_coordinate(const spec::Contract& c, float value_px, Counters* counters) {
  if (is_denormal(value_px)) {
    ++counters->denormals;
    return 0;
  }
  // Exact: scaling by a power of two only changes the exponent, and a double has a larger range.
  const double scaled = static_cast<double>(value_px) * (1 << c.design.subpixel_bits);
  const double rounded = std::nearbyint(scaled);  // halves to even
  const int32_t limit = 1 << (c.design.guard_bits + c.design.subpixel_bits);
  if (rounded >= -limit && rounded < limit) return static_cast<int32_t>(rounded);
  ++counters->saturated;
  return rounded < 0 ? -limit : limit - 1;
}

int64_t snap_depth(const spec::Contract& c, float z, Counters* counters) {
  if (is_denormal(z)) {
    ++counters->denormals;
    return 0;
  }
  if (z < 0 || z > 1) {
    ++counters->z_clamped;
    z = z < 0 ? 0.0f : 1.0f;
  }
  if (z == 0) return 0;
  // z = mantissa * 2^(exponent - 150) with 2^23 <= mantissa < 2^24 and 1 <= exponent <= 127.
  uint32_t bits;
  std::memcpy(&bits, &z, sizeof bits);
  const int64_t mantissa = (bits & 0x7fffff) | 0x800000;
  const int shift = 150 - static_cast<int>(bits >> 23);
  // Below 2^64 with 32 depth bits; rounding needs one bit more.
  const spec::int128_t product = spec::int128_t{(mantissa << c.design.depth_bits) - mantissa}
                                 << spec::kDepthInputFractionBits;
  return shift > 66 ? 0 : static_cast<int64_t>(spec::round_half_up(product, shift));
}

void set_inverse_w(const spec::Contract& c, const std::array<float, 3>& w,
                   std::array<spec::Vertex, 3>* vertices) {
  std::array<int, 3> exponent{};
  for (size_t i = 0; i < 3; ++i) {
    // w = m * 2^(e - 24) with 2^23 <= m < 2^24, so 1/w = 2^(23 + bits) / m * 2^(1 - e - bits), and
    // the quotient lies in (2^(bits-1), 2^bits].
    int e;
    const auto m = static_cast<int64_t>(std::ldexp(std::frexp(w[i], &e), 24));
    const int bits = c.design.inverse_w_bits;
    int64_t quotient = ((int64_t{1} << (24 + bits)) + m) / (2 * m);
    exponent[i] = -e;
    if (quotient >> bits != 0) {  // w is a power of two, or the quotient rounded up to one
      quotient >>= 1;
      ++exponent[i];
    }
    (*vertices)[i].inverse_w = static_cast<int32_t>(quotient);
  }
  const int greatest = *std::max_element(exponent.begin(), exponent.end());
  for (size_t i = 0; i < 3; ++i) (*vertices)[i].inverse_w_shift = greatest - exponent[i];
}

spec::Vertex SnappedSource::snap(const ScreenVertex& vertex) {
  spec::Vertex snapped;
  snapped.x = snap_coordinate(contract_, vertex.x, &counters_);
  snapped.y = snap_coordinate(contract_, vertex.y, &counters_);
  snapped.z = snap_depth(contract_, vertex.z, &counters_);
  const size_t count = std::min<size_t>(static_cast<size_t>(spec::channels(contract_.design)), 4);
  const int32_t greatest = (1 << contract_.design.attribute_bits) - 1;
  for (size_t i = 0; i < count; ++i) {
    snapped.attr[i] = (2 * vertex.rgba[i] * greatest + 255) / 510;
  }
  return snapped;
}

bool SnappedSource::next(spec::Triangle* triangle) {
  while (reader_->read(&screen_, &counters_)) {
    if (has_nan(screen_)) {
      ++counters_.nan_dropped;
      continue;
    }
    triangle->id = screen_.id;
    for (size_t i = 0; i < 3; ++i) triangle->v[i] = snap(screen_.v[i]);
    set_inverse_w(contract_, {screen_.v[0].w, screen_.v[1].w, screen_.v[2].w}, &triangle->v);
    return true;
  }
  return false;
}

void SnappedSource::rewind() {
  reader_->rewind();
  counters_ = start_;
}

}  // namespace pineda::scene
