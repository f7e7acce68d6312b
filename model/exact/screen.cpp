// Exact values of a triangle given in floats. Along a row a value is a fraction whose numerator and
// denominator change by constants. Affine values are stepped as quotient and remainder, without
// divisions.
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/exact/exact.h"

namespace exact {

namespace {

__extension__ typedef __int128 Int128;
// For perspective sums that need more than 128 bits. w = m * 2^e with m odd, m < 2^24 and -149 <= e
// <= 127, so product * 2^shift < 2^(48 + 276); with an area of 54 bits and an attribute of 16 that
// is 394 bits. Overflow throws.
using Wide = boost::multiprecision::checked_int512_t;

using Weights = std::array<int64_t, 3>;

constexpr int64_t kGreatestBias = int64_t{1} << 32;

void check_range(int value, int low, int high, const char* message) {
  if (value < low || value > high) throw std::out_of_range(message);
}

void check(const Format& f) {
  check_range(f.subpixel_bits, 1, 12, "exact: subpixel bits must be 1 to 12");
  check_range(f.guard_bits, 0, 26 - f.subpixel_bits,
              "exact: guard band and subpixels must fit into 26 bits");
  check_range(f.depth_bits, 0, 32, "exact: depth bits must be 0 to 32");
  check_range(f.attributes, 0, 16, "exact: attributes must be 0 to 16");
  check_range(f.attribute_bits, 0, 16, "exact: attribute bits must be 0 to 16");
}

void check(const Frame& f) {
  check_range(f.bias_slope, -(1 << 15), 1 << 15, "exact: a bias's slope must be within 2^15");
  if (f.bias_constant < -kGreatestBias || f.bias_constant > kGreatestBias) {
    throw std::out_of_range("exact: a bias's constant must be within 2^32");
  }
}

bool has_nan(const ScreenTriangle& triangle) {
  return std::any_of(triangle.begin(), triangle.end(), [](const ScreenVertex& v) {
    return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z) || std::isnan(v.w);
  });
}

Vertex snap_vertex(const ScreenVertex& v, const Format& format) {
  if (!std::isnormal(v.w) || v.w < 0) {
    throw std::out_of_range("exact: w must be positive, neither denormal nor infinite");
  }
  bool outside = false;  // not used: the judge does not count saturation
  Vertex snapped;
  snapped.x = snap(v.x, format.subpixel_bits, format.guard_bits, &outside);
  snapped.y = snap(v.y, format.subpixel_bits, format.guard_bits, &outside);
  snapped.z = depth_input(v.z, format.depth_bits, &outside);
  snapped.attr.resize(static_cast<size_t>(format.attributes));
  const int greatest = (1 << format.attribute_bits) - 1;
  for (size_t i = 0; i < v.rgba.size() && i < snapped.attr.size(); ++i) {
    check_range(v.rgba[i], 0, 255, "exact: a colour must be 0 to 255");
    // To the nearest. There are no ties: they need 2*c*greatest to be an odd multiple of 255, but
    // it is even.
    snapped.attr[i] = (v.rgba[i] * greatest + 127) / 255;
  }
  return snapped;
}

Triangle snap_triangle(const ScreenTriangle& t, const Format& format, const Frame& frame) {
  check(format);
  check(frame);
  if (has_nan(t)) return {};
  Triangle v{snap_vertex(t[0], format), snap_vertex(t[1], format), snap_vertex(t[2], format)};
  if (frame.flat) v[1].attr = v[2].attr = v[0].attr;
  return v;
}

// max(|dz/dx|, |dz/dy|) times the doubled area: below 2^68, in units of 2^-8 codes times subpixels.
Int128 steepest(const Triangle& t) {
  const auto magnitude = [&](int64_t Vertex::*along) {
    const Int128 numerator = Int128{t[1].z - t[0].z} * (t[2].*along - t[0].*along) -
                             Int128{t[2].z - t[0].z} * (t[1].*along - t[0].*along);
    return numerator < 0 ? -numerator : numerator;
  };
  return std::max(magnitude(&Vertex::y), magnitude(&Vertex::x));
}

int bit_length(int64_t value) {
  int bits = 0;
  for (; value != 0; value >>= 1) ++bits;
  return bits;
}

struct OddFloat {
  int64_t mantissa;  // odd, or 0
  int exponent;      // value = mantissa * 2^exponent
};

OddFloat odd_float(float value) {
  int exponent = 0;
  auto mantissa = static_cast<int64_t>(std::ldexp(std::frexp(value, &exponent), 24));
  exponent -= 24;
  for (; mantissa != 0 && mantissa % 2 == 0; mantissa /= 2) ++exponent;
  return {mantissa, exponent};
}

// v = whole + fraction. A quotient of two integers in a 64-bit mantissa is within 2^-64, and
// rounded to a double within 2^-54 + 2^-64. A fraction that rounds up to 1 is clamped below 1.
Value make_value(int64_t whole, long double fraction, bool half) {
  static_assert(std::numeric_limits<long double>::digits >= 64, "2^-53 needs a long double");
  constexpr double kBelowOne = 1 - std::numeric_limits<double>::epsilon() / 2;
  return {whole, std::min(static_cast<double>(fraction), kBelowOne), half ? whole + 1 : whole};
}

// The weighted mean of the three vertices' values, stepped along the samples of a row.
//
// Widths: the weights sum to at most 2^54 (see Judge) and a value is below 2^40, so the numerator
// is below 2^94. The denominator, the area times the unit of the values, has at most 62 bits, so a
// remainder plus a step of it is below 2^63. Quotients are means of the values, and their step is
// the difference of two means, so both are small.
class Mean {
 public:
  Mean(const Weights& at, const Weights& next, const std::array<int64_t, 3>& values,
       int64_t denominator)
      : denominator_(denominator) {
    Int128 numerator = 0;
    Int128 next_numerator = 0;
    for (size_t i = 0; i < 3; ++i) {
      numerator += Int128{at[i]} * values[i];
      next_numerator += Int128{next[i]} * values[i];
    }
    whole_ = static_cast<int64_t>(numerator / denominator);
    rest_ = static_cast<int64_t>(numerator % denominator);
    whole_step_ = static_cast<int64_t>(next_numerator / denominator) - whole_;
    rest_step_ = static_cast<int64_t>(next_numerator % denominator) - rest_;
  }

  Value value() const {
    return make_value(whole_,
                      static_cast<long double>(rest_) / static_cast<long double>(denominator_),
                      rest_ >= denominator_ - rest_);
  }

  void step() {
    whole_ += whole_step_;
    rest_ += rest_step_;
    if (rest_ < 0) {
      rest_ += denominator_;
      --whole_;
    } else if (rest_ >= denominator_) {
      rest_ -= denominator_;
      ++whole_;
    }
  }

 private:
  int64_t denominator_;
  int64_t whole_;
  int64_t rest_;
  int64_t whole_step_;
  int64_t rest_step_;
};

// A sum over the vertices that changes by the constant `step` from sample to sample.
template <typename Integer>
struct Sum {
  Integer value = 0;
  Integer step = 0;

  void add(int64_t at, int64_t next, const Integer& factor) {
    value += at * factor;
    step += (next - at) * factor;
  }
};

template <typename Integer>
Value quotient(const Integer& numerator, const Integer& denominator) {
  const Integer whole = numerator / denominator;
  const Integer rest = numerator - whole * denominator;
  return make_value(static_cast<int64_t>(whole),
                    static_cast<long double>(rest) / static_cast<long double>(denominator),
                    rest >= denominator - rest);
}

// One attribute with perspective along a row: factor[i] is proportional to 1/w_i.
template <typename Integer>
void perspective_row(const Weights& at, const Weights& next, const std::array<Integer, 3>& factor,
                     const Triangle& t, size_t attribute, Sample* first, Sample* last) {
  Sum<Integer> numerator;
  Sum<Integer> denominator;
  for (size_t i = 0; i < 3; ++i) {
    numerator.add(at[i], next[i], factor[i] * t[i].attr[attribute]);
    denominator.add(at[i], next[i], factor[i]);
  }
  for (;; ++first) {
    first->perspective[attribute] = quotient(numerator.value, denominator.value);
    if (first == last) return;
    numerator.value += numerator.step;
    denominator.value += denominator.step;
  }
}

template <typename Integer>
std::array<Integer, 3> factors(const std::array<int64_t, 3>& product,
                               const std::array<int, 3>& shift) {
  std::array<Integer, 3> result;
  for (size_t i = 0; i < 3; ++i) result[i] = Integer{product[i]} << shift[i];
  return result;
}

}  // namespace

double Value::error_of(int64_t code) const { return static_cast<double>(code - whole) - fraction; }

double Value::error_of(int64_t value, int fraction_bits) const {
  const int64_t floor = value >> fraction_bits;
  const int64_t below = (int64_t{1} << fraction_bits) - 1;
  const auto rest = static_cast<double>(value & below);  // exact: 52 bits
  return static_cast<double>(floor - whole) + (std::ldexp(rest, -fraction_bits) - fraction);
}

ScreenJudge::ScreenJudge(const ScreenTriangle& triangle, const Format& format, const Frame& frame)
    : snapped_(snap_triangle(triangle, format, frame), format.subpixel_bits, frame),
      format_(format),
      frame_(frame),
      dropped_(has_nan(triangle)),
      attributes_(static_cast<size_t>(std::min(format.attributes, 4))) {
  affine_ = frame.flat || (triangle[0].w == triangle[1].w && triangle[1].w == triangle[2].w);
  if (culled() || affine_) return;
  // Multiplied by w_0 w_1 w_2, each 1/w_i becomes the product of the other two w's.
  std::array<OddFloat, 3> w{};
  for (size_t i = 0; i < 3; ++i) w[i] = odd_float(triangle[i].w);
  const int highest = std::max({w[0].exponent, w[1].exponent, w[2].exponent});
  int factor_bits = 0;
  for (size_t i = 0; i < 3; ++i) {
    product_[i] = w[(i + 1) % 3].mantissa * w[(i + 2) % 3].mantissa;  // below 2^48
    shift_[i] = highest - w[i].exponent;
    factor_bits = std::max(factor_bits, bit_length(product_[i]) + shift_[i]);
  }
  // A sum is at most area * greatest factor * greatest attribute, and its step is the difference of
  // two such sums. If both are below 2^126, sum plus step is below 2^127.
  const int area_bits = bit_length(std::abs(snapped_.doubled_area()));
  narrow_ = area_bits + factor_bits + format.attribute_bits <= 126;
}

double ScreenJudge::depth_slope() const {
  const int64_t area2 = std::abs(snapped_.doubled_area());
  if (area2 == 0) return 0;
  return std::ldexp(static_cast<double>(static_cast<long double>(steepest(snapped_.vertices())) /
                                        static_cast<long double>(area2)),
                    format_.subpixel_bits - 8);
}

// Numerators in units of 2^-16 codes / area. Those of depth, constant, slope and greatest code are
// below 2^102 each, so sums and steps fit into 128 bits.
void ScreenJudge::biased_row(const Weights& at, const Weights& next, Sample* first,
                             Sample* last) const {
  const Triangle& t = snapped_.vertices();
  const Int128 denominator = Int128{std::abs(snapped_.doubled_area())} << 16;
  const Int128 greatest = ((Int128{1} << format_.depth_bits) - 1) * denominator;
  Sum<Int128> numerator;
  for (size_t i = 0; i < 3; ++i) numerator.add(at[i], next[i], Int128{t[i].z} << 8);
  numerator.value += frame_.bias_constant * denominator;
  numerator.value += frame_.bias_slope * (steepest(t) << format_.subpixel_bits);
  for (Sample* s = first; s <= last; ++s, numerator.value += numerator.step) {
    s->z = quotient(std::clamp(numerator.value, Int128{0}, greatest), denominator);
  }
}

void ScreenJudge::row(int y, bool with_perspective, std::vector<Sample>* out) const {
  const Span span = snapped_.span(y);
  if (span.first > span.last) return;
  const size_t begin = out->size();
  const auto count = static_cast<size_t>(span.last - span.first) + 1;
  out->resize(begin + count);
  Sample* const first = out->data() + begin;
  Sample* const last = first + count - 1;
  const Triangle& t = snapped_.vertices();
  const Weights at = snapped_.weights(span.first, y);
  const Weights next = snapped_.weights(std::min(span.first + 1, span.last), y);
  const int64_t area2 = std::abs(snapped_.doubled_area());

  int x = span.first;
  for (Sample* s = first; s <= last; ++s) {
    s->x = x++;
    s->y = y;
  }
  if (frame_.bias_constant != 0 || frame_.bias_slope != 0) {
    biased_row(at, next, first, last);
  } else {
    Mean z(at, next, {t[0].z, t[1].z, t[2].z}, area2 << 8);
    for (Sample* s = first; s <= last; ++s, z.step()) s->z = z.value();
  }
  for (size_t a = 0; a < attributes_; ++a) {
    Mean mean(at, next, {t[0].attr[a], t[1].attr[a], t[2].attr[a]}, area2);
    for (Sample* s = first; s <= last; ++s, mean.step()) s->affine[a] = mean.value();
    if (!with_perspective) continue;
    if (affine_) {
      for (Sample* s = first; s <= last; ++s) s->perspective[a] = s->affine[a];
    } else if (narrow_) {
      perspective_row(at, next, factors<Int128>(product_, shift_), t, a, first, last);
    } else {
      perspective_row(at, next, factors<Wide>(product_, shift_), t, a, first, last);
    }
  }
}

}  // namespace exact
