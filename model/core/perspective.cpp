#include "model/core/perspective.h"

#include <algorithm>

namespace pineda::core {

using spec::Contract;
using spec::int128_t;
using spec::round_half_up;
using spec::Stamp;

namespace {

int bit_length(int128_t value) {
  const auto high = static_cast<uint64_t>(value >> 64);
  return high != 0 ? 64 + spec::bit_length(high) : spec::bit_length(static_cast<uint64_t>(value));
}

// E of an edge at a sample: E' stepped by whole pixels, then its low bits and bias restored.
int64_t edge_value(const Contract& c, const spec::EdgeFunction& edge, int32_t low, int i, int j) {
  const bool top_left = edge.a > 0 || (edge.a == 0 && edge.b > 0);
  const int64_t e = edge.e + i * edge.a + j * edge.b;
  return e * (int64_t{1} << c.design.subpixel_bits) + low + (top_left ? 0 : 1);
}

}  // namespace

std::array<int64_t, 3> weight_products(const Contract& c, const Stamp& stamp, int i, int j) {
  const spec::PerspectiveSet& p = stamp.planes.perspective;
  std::array<int128_t, 3> exact;
  int top = 0;  // bit length of the greatest product, at the scale of a vertex with shift 0
  bool any = false;
  for (size_t v = 0; v < 3; ++v) {
    const size_t edge = (v + 1) % 3;  // opposite to vertex v
    exact[v] = int128_t{edge_value(c, stamp.edge[edge], p.e_low[edge], i, j)} * p.inverse_w[v];
    if (exact[v] <= 0) continue;
    const int length = bit_length(exact[v]) - p.inverse_w_shift[v];
    top = any ? std::max(top, length) : length;
    any = true;
  }
  std::array<int64_t, 3> cut{};
  for (size_t v = 0; v < 3; ++v) {
    const int shift = top + p.inverse_w_shift[v] - spec::kWeightProductBits;
    if (exact[v] <= 0 || shift > 127) continue;
    cut[v] = static_cast<int64_t>(shift < 0 ? exact[v] << -shift : exact[v] >> shift);
  }
  return cut;
}

void weigh_attributes(const Contract& c, const Stamp& stamp, const std::array<int64_t, 3>& product,
                      const Reciprocal& r, spec::Attributes* attr) {
  // product * mantissa * 2^(1 - k - length) in units of 2^-24.
  const int shift = c.design.reciprocal_bits + r.length - 1 - spec::kWeightFractionBits;
  const int64_t one = int64_t{1} << spec::kWeightFractionBits;
  const auto weight = [&](size_t v) {
    const auto g = static_cast<int64_t>(round_half_up(int128_t{product[v]} * r.mantissa, shift));
    return std::min(g, one);
  };
  const int64_t g1 = weight(1);
  const int64_t g2 = weight(2);
  const auto& a = stamp.planes.perspective.attr;
  const int64_t top = (int64_t{1} << c.design.attribute_bits) - 1;
  for (size_t n = 0; n < static_cast<size_t>(c.design.attributes); ++n) {
    const int64_t sum = a[0][n] * one + g1 * (a[1][n] - a[0][n]) + g2 * (a[2][n] - a[0][n]);
    const int64_t value = round_half_up(sum, spec::kWeightFractionBits);
    (*attr)[n] = static_cast<int32_t>(std::clamp<int64_t>(value, 0, top));
  }
}

void perspective_attributes(const Contract& c, const Stamp& stamp, int i, int j,
                            spec::Attributes* attr) {
  const auto product = weight_products(c, stamp, i, j);
  weigh_attributes(c, stamp, product, reciprocal(c, product[0] + product[1] + product[2]), attr);
}

}  // namespace pineda::core
