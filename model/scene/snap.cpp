#include "model/scene/snap.h"

#include <algorithm>
#include <cstring>

namespace pineda::scene {
namespace {

constexpr size_t kBatch = 64;  // screen triangles: 4 KB

// Their shifted products and the half that rounds them stay below 2^63.
constexpr int kGreatestNarrowDepthBits = 30;

uint32_t bits_of(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

bool is_denormal(uint32_t bits) { return (bits << 1) - 1 < 0xffffff; }  // of a zero: 2^32 - 1

bool is_nan(float value) { return bits_of(value) << 1 > 0xff000000; }

// The nearest integer, halves to even, of |value| < 2^51: the sum has no bits for a fraction.
double nearest_even(double value) { return value + 0x1.8p52 - 0x1.8p52; }

bool has_nan(const ScreenTriangle& triangle) {
  bool nan = false;
  for (const ScreenVertex& v : triangle.v) {
    nan |= is_nan(v.x) || is_nan(v.y) || is_nan(v.z) || is_nan(v.w);
  }
  return nan;
}

}  // namespace

int32_t snap_coordinate(const spec::Contract& c, float value_px, Counters* counters) {
  if (is_denormal(bits_of(value_px))) {
    ++counters->denormals;
    return 0;
  }
  const int32_t limit = 1 << (c.design.guard_bits + c.design.subpixel_bits);
  // Exact: scaling by a power of two only changes the exponent, and a double has a larger range.
  const double scaled = static_cast<double>(value_px) * (1 << c.design.subpixel_bits);
  const auto units =
      static_cast<int32_t>(nearest_even(std::clamp(scaled, -limit - 1., limit + 1.)));
  if (units >= -limit && units < limit) return units;
  ++counters->saturated;
  return units < 0 ? -limit : limit - 1;
}

int64_t snap_depth(const spec::Contract& c, float z, Counters* counters) {
  uint32_t bits = bits_of(z);
  if (is_denormal(bits)) {
    ++counters->denormals;
    return 0;
  }
  if (z < 0 || z > 1) {
    ++counters->z_clamped;
    bits = bits_of(z < 0 ? 0.0f : 1.0f);
  }
  if (bits << 1 == 0) return 0;
  // z = mantissa * 2^(exponent - 150) with 2^23 <= mantissa < 2^24 and 1 <= exponent <= 127.
  const int64_t mantissa = (bits & 0x7fffff) | 0x800000;
  const int shift = 150 - static_cast<int>(bits >> 23);
  const int64_t codes = (mantissa << c.design.depth_bits) - mantissa;
  if (c.design.depth_bits <= kGreatestNarrowDepthBits) {
    const int64_t product = codes << spec::kDepthInputFractionBits;
    return shift > 62 ? 0 : spec::round_half_up(product, shift);
  }
  // Below 2^64 with 32 depth bits; rounding needs one bit more.
  const spec::int128_t product = spec::int128_t{codes} << spec::kDepthInputFractionBits;
  return shift > 66 ? 0 : static_cast<int64_t>(spec::round_half_up(product, shift));
}

void set_inverse_w(const spec::Contract& c, const std::array<float, 3>& w,
                   std::array<spec::Vertex, 3>* vertices) {
  const int inverse_bits = c.design.inverse_w_bits;
  std::array<int, 3> exponent{};
  for (size_t i = 0; i < 3; ++i) {
    // w = m * 2^(e - 24) with 2^23 <= m < 2^24, so 1/w = 2^(23 + bits) / m * 2^(1 - e - bits), and
    // the quotient lies in (2^(bits-1), 2^bits].
    const uint32_t bits = bits_of(w[i]);
    const int64_t m = (bits & 0x7fffff) | 0x800000;
    exponent[i] = 126 - static_cast<int>(bits >> 23);  // -e
    int64_t quotient = int64_t{1} << inverse_bits;     // of a power of two, as without perspective
    if (m != 0x800000) quotient = ((int64_t{1} << (24 + inverse_bits)) + m) / (2 * m);
    if (quotient >> inverse_bits != 0) {  // w is a power of two, or the quotient rounded up to one
      quotient >>= 1;
      ++exponent[i];
    }
    (*vertices)[i].inverse_w = static_cast<int32_t>(quotient);
  }
  const int greatest = *std::max_element(exponent.begin(), exponent.end());
  for (size_t i = 0; i < 3; ++i) (*vertices)[i].inverse_w_shift = greatest - exponent[i];
}

SnappedSource::SnappedSource(const spec::Contract& contract, std::unique_ptr<ScreenReader> reader,
                             const Counters& start)
    : contract_(contract),
      reader_(std::move(reader)),
      start_(start),
      colors_(std::min<size_t>(static_cast<size_t>(spec::channels(contract.design)), 4)),
      color_codes_() {
  counters_ = start_;
  const int32_t greatest = (1 << contract.design.attribute_bits) - 1;
  for (int32_t byte = 0; byte < 256; ++byte) {
    color_codes_[static_cast<size_t>(byte)] = (2 * byte * greatest + 255) / 510;
  }
}

// False if the triangle is dropped.
bool SnappedSource::snap(const ScreenTriangle& screen, spec::Triangle* triangle) {
  if (has_nan(screen)) {
    ++counters_.nan_dropped;
    return false;
  }
  triangle->id = screen.id;
  for (size_t i = 0; i < 3; ++i) {
    const ScreenVertex& from = screen.v[i];
    spec::Vertex& to = triangle->v[i];
    to.x = snap_coordinate(contract_, from.x, &counters_);
    to.y = snap_coordinate(contract_, from.y, &counters_);
    to.z = snap_depth(contract_, from.z, &counters_);
    to.attr = {};
    for (size_t k = 0; k < colors_; ++k) to.attr[k] = color_codes_[from.rgba[k]];
  }
  set_inverse_w(contract_, {screen.v[0].w, screen.v[1].w, screen.v[2].w}, &triangle->v);
  return true;
}

bool SnappedSource::next(spec::Triangle* triangle) {
  while (reader_->read(&screen_, &counters_)) {
    if (snap(screen_, triangle)) return true;
  }
  return false;
}

size_t SnappedSource::next_many(spec::Triangle* triangles, size_t count) {
  std::array<ScreenTriangle, kBatch> screen;
  size_t filled = 0;
  for (bool at_end = false; filled < count && !at_end;) {
    const size_t wanted = std::min(count - filled, kBatch);
    const size_t got = reader_->read_many(screen.data(), wanted, &counters_);
    for (size_t i = 0; i < got; ++i) filled += snap(screen[i], &triangles[filled]) ? 1 : 0;
    at_end = got < wanted;
  }
  return filled;
}

void SnappedSource::rewind() {
  reader_->rewind();
  counters_ = start_;
}

}  // namespace pineda::scene
