#include "model/scene/polygons/planar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pineda::scene {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::gcd;
using boost::multiprecision::msb;

// Error bounds for coordinates with relative error e = 2^-52 and magnitude at most 1: a difference
// is at most 2 and off by 3e, a product of two differences by 14e, the difference of two products
// by 32e.
constexpr double kTurnError = 40 * std::numeric_limits<double>::epsilon();
constexpr double kOrderError = 4 * std::numeric_limits<double>::epsilon();

int sign_of(double value) { return (value > 0) - (value < 0); }

int sign_of(uint32_t a, uint32_t b) { return (b > a) - (b < a); }

struct Binary {
  int64_t mantissa = 0;  // odd, or 0
  int exponent = 0;
};

Binary binary(double value) {
  if (value == 0) return {};
  Binary b;
  b.mantissa = static_cast<int64_t>(std::ldexp(std::frexp(value, &b.exponent), 53));
  b.exponent -= 53;
  while (b.mantissa % 2 == 0) {
    b.mantissa /= 2;
    ++b.exponent;
  }
  return b;
}

template <class Int>
int length_bits(const Int& value) {
  return value == 0 ? 0 : static_cast<int>(msb(abs(value))) + 1;
}

// The coordinates as doubles, divided by one power of two.
template <class Int>
std::vector<double> scaled(const std::vector<Int>& exact) {
  int greatest = 0;
  for (const Int& value : exact) greatest = std::max(greatest, length_bits(value));
  std::vector<double> all;
  all.reserve(exact.size());
  for (const Int& value : exact) {
    const int shift = std::max(0, length_bits(value) - 62);
    const Int top =
        shift > 0 ? static_cast<Int>(abs(value) >> shift) : static_cast<Int>(abs(value));
    const double magnitude =
        std::ldexp(static_cast<double>(static_cast<int64_t>(top)), shift - greatest);
    all.push_back(value < 0 ? -magnitude : magnitude);
  }
  return all;
}

template <class Int>
std::vector<uint32_t> ranks(const std::vector<double>& near, const std::vector<Int>& exact) {
  const auto is_less = [&](uint32_t a, uint32_t b) {
    const double difference = near[b] - near[a];
    if (std::abs(difference) > kOrderError) return difference > 0;
    return exact[a] < exact[b];
  };
  std::vector<uint32_t> order(near.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), is_less);
  std::vector<uint32_t> rank(near.size());
  for (size_t i = 1; i < order.size(); ++i) {
    rank[order[i]] = rank[order[i - 1]] + (is_less(order[i - 1], order[i]) ? 1 : 0);
  }
  return rank;
}

}  // namespace

PlanarPolygon::PlanarPolygon(const std::vector<Vec3>& corner) {
  project(corner);
  if (!has_plane_) return;
  u_near_ = scaled(u_);
  v_near_ = scaled(v_);
  u_rank_ = ranks(u_near_, u_);
  v_rank_ = ranks(v_near_, v_);
  rank_places();
}

void PlanarPolygon::project(const std::vector<Vec3>& corner) {
  int least = std::numeric_limits<int>::max();
  for (const Vec3& p : corner) {
    for (const double x : p) {
      if (x != 0) least = std::min(least, binary(x).exponent);
    }
  }
  const auto whole = [&](double x) {
    const Binary b = binary(x);
    Int value = b.mantissa;
    if (b.mantissa != 0) value <<= b.exponent - least;
    return value;
  };
  std::vector<std::array<Int, 3>> q(corner.size());  // relative to the first corner
  for (size_t i = corner.size(); i-- > 0;) {
    for (size_t k = 0; k < 3; ++k) q[i][k] = whole(corner[i][k]) - whole(corner[0][k]);
  }
  std::array<Int, 3> n;
  for (size_t i = 1; i + 1 < q.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      const size_t x = (k + 1) % 3, y = (k + 2) % 3;
      n[k] += q[i][x] * q[i + 1][y] - q[i][y] * q[i + 1][x];
    }
  }
  const Int common = gcd(gcd(n[0], n[1]), n[2]);
  has_plane_ = common != 0;
  if (!has_plane_) {
    u_.resize(corner.size());
    return;
  }
  for (Int& component : n) component /= common;
  size_t z = 0;
  while (n[z] == 0) ++z;
  for (size_t k = z + 1; k < 3; ++k) {
    if (abs(n[k]) > abs(n[z])) z = k;
  }
  const size_t x = (z + 1) % 3, y = (z + 2) % 3;
  // u and v are dot products with (nz, 0, -nx) and (0, nz, -ny). Both are perpendicular to n, and
  // their cross product is nz * n; so where nz is negative one of them is negated.
  const bool is_turned = n[z] < 0;
  u_.reserve(q.size());
  v_.reserve(q.size());
  for (const auto& p : q) {
    u_.push_back(n[z] * p[x] - n[x] * p[z]);
    v_.push_back(is_turned ? n[y] * p[z] - n[z] * p[y] : n[z] * p[y] - n[y] * p[z]);
  }
}

void PlanarPolygon::rank_places() {
  std::vector<uint32_t> order(u_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](uint32_t i) { return uint64_t{u_rank_[i]} << 32 | v_rank_[i]; };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  place_.resize(u_.size());
  for (size_t i = 1; i < order.size(); ++i) {
    place_[order[i]] = place_[order[i - 1]] + (key(order[i - 1]) < key(order[i]) ? 1 : 0);
  }
  places_ = place_[order.back()] + 1;
}

int PlanarPolygon::turn(uint32_t a, uint32_t b, uint32_t c) const {
  // The ranks give the signs of the two products; if these differ they decide.
  const int first = sign_of(u_rank_[a], u_rank_[b]) * sign_of(v_rank_[a], v_rank_[c]);
  const int second = sign_of(v_rank_[a], v_rank_[b]) * sign_of(u_rank_[a], u_rank_[c]);
  if (first != second) return first > second ? 1 : -1;
  if (first == 0) return 0;
  const double near = (u_near_[b] - u_near_[a]) * (v_near_[c] - v_near_[a]) -
                      (v_near_[b] - v_near_[a]) * (u_near_[c] - u_near_[a]);
  if (std::abs(near) > kTurnError) return sign_of(near);
  const Int left = (u_[b] - u_[a]) * (v_[c] - v_[a]);
  const Int right = (v_[b] - v_[a]) * (u_[c] - u_[a]);
  return (left > right) - (left < right);
}

}  // namespace pineda::scene
