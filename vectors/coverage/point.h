// What a row of the coverage table is made of.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "model/spec/widths.h"

namespace pineda::vectors {

/// Values that a point does not tell apart.
struct Bin {
  std::string name;
  std::string unreachable;  // why no legal input hits it; empty: one does
};
using Bins = std::vector<Bin>;

/// How often each bin of a point was hit.
class Hits {
 public:
  explicit Hits(const Bins& bins) : count_(bins.size(), 0), reachable_(bins.size()) {
    for (size_t i = 0; i < bins.size(); ++i) reachable_[i] = bins[i].unreachable.empty();
  }

  template <class Integer>
  void add(Integer bin) {
    const auto at = static_cast<size_t>(bin);
    hit_ += count_.at(at)++ == 0 && reachable_[at] ? 1 : 0;
  }
  const std::vector<uint64_t>& counts() const { return count_; }
  /// Reachable bins with a hit.
  size_t hit() const { return hit_; }

 private:
  std::vector<uint64_t> count_;
  std::vector<bool> reachable_;
  size_t hit_ = 0;
};

/// One thing that cases can show of a unit: a row of the table. `Seen` is what it looks at.
template <class Seen>
struct Point {
  const char* name;
  const char* what;
  Bins (*bins)(const spec::Contract& contract);  // none: the design has nothing of the kind
  void (*see)(const Seen& seen, Hits* hits);     // only called where there are bins
};

inline Bins named(std::initializer_list<const char*> names) {
  Bins bins;
  for (const char* name : names) bins.push_back({name, ""});
  return bins;
}

/// "first" to "last", with what they are numbers of.
inline Bins numbered(int first, int last, const std::string& of) {
  Bins bins;
  for (int i = first; i <= last; ++i) bins.push_back({fmt::format("{} {}", i, of), ""});
  return bins;
}

/// Each of `a` with each of `b`, those of `b` next to each other.
inline Bins product(const Bins& a, const Bins& b) {
  Bins bins;
  for (const Bin& first : a) {
    for (const Bin& second : b) {
      bins.push_back({first.name + ", " + second.name,
                      first.unreachable.empty() ? second.unreachable : first.unreachable});
    }
  }
  return bins;
}

inline Bins operator+(Bins a, const Bins& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// `bins` where the design has it.
inline Bins where(bool has, const Bins& bins) { return has ? bins : Bins(); }

/// 0, 1 or 2: negative, zero, positive.
template <class Integer>
constexpr int sign_bin(Integer value) {
  return value < 0 ? 0 : value == 0 ? 1 : 2;
}
inline Bins signs() { return named({"negative", "zero", "positive"}); }

inline int length_of(int64_t value) { return spec::bit_length(static_cast<uint64_t>(value)); }

/// What rounding off the low `shift` bits does: 0 nothing is lost, 1 down, 2 a half, up, 3 more, up.
inline int rounding_bin(spec::int128_t value, int shift) {
  if (shift == 0) return 0;
  const auto low = static_cast<uint64_t>(value) & ((uint64_t{1} << shift) - 1);
  const uint64_t half = uint64_t{1} << (shift - 1);
  return low == 0 ? 0 : low < half ? 1 : low == half ? 2 : 3;
}
inline Bins roundings(int shift) {
  Bins bins = named({"exact", "down", "a half up", "up"});
  const std::string none = "no bits are rounded off", one = "a single bit is rounded off";
  if (shift == 0) bins[2].unreachable = none;
  if (shift <= 1) bins[1].unreachable = bins[3].unreachable = shift == 0 ? none : one;
  return bins;
}

/// Does `value` leave a two's complement number of so many bits?
inline bool leaves(spec::int128_t value, int bits) {
  return value < -(spec::int128_t{1} << (bits - 1)) || value >= spec::int128_t{1} << (bits - 1);
}

}  // namespace pineda::vectors
