// Compiled once for each vector unit that Highway knows on this processor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/limits.cpp"
// The order of these is Highway's.
#include "bench/limits.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pineda::bench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Products under way at once: more than a multiplier has stages, fewer than there are registers.
constexpr size_t kChains = 10;
constexpr size_t kRounds = 4096;

using Tag = hn::ScalableTag<uint32_t>;

size_t products() { return kRounds * kChains * hn::Lanes(Tag()); }

uint32_t multiply(uint32_t factor) {
  constexpr Tag kTag;
  const auto by = hn::Set(kTag, factor);
  auto v0 = hn::Iota(kTag, 1), v1 = hn::Iota(kTag, 101), v2 = hn::Iota(kTag, 201);
  auto v3 = hn::Iota(kTag, 301), v4 = hn::Iota(kTag, 401), v5 = hn::Iota(kTag, 501);
  auto v6 = hn::Iota(kTag, 601), v7 = hn::Iota(kTag, 701), v8 = hn::Iota(kTag, 801);
  auto v9 = hn::Iota(kTag, 901);
  for (size_t round = 0; round < kRounds; ++round) {
    v0 = hn::Mul(v0, by);
    v1 = hn::Mul(v1, by);
    v2 = hn::Mul(v2, by);
    v3 = hn::Mul(v3, by);
    v4 = hn::Mul(v4, by);
    v5 = hn::Mul(v5, by);
    v6 = hn::Mul(v6, by);
    v7 = hn::Mul(v7, by);
    v8 = hn::Mul(v8, by);
    v9 = hn::Mul(v9, by);
  }
  const auto sum = hn::Add(hn::Add(hn::Add(v0, v1), hn::Add(v2, v3)),
                           hn::Add(hn::Add(hn::Add(v4, v5), hn::Add(v6, v7)), hn::Add(v8, v9)));
  return hn::GetLane(sum);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace pineda::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pineda::bench {

HWY_EXPORT(products);
HWY_EXPORT(multiply);

size_t lane_products() { return HWY_DYNAMIC_DISPATCH(products)(); }
uint32_t multiply_lanes(uint32_t factor) { return HWY_DYNAMIC_DISPATCH(multiply)(factor); }

uint64_t multiply_words(uint64_t factor) {
  constexpr size_t kWords = 8;
  uint64_t word[kWords] = {1, 2, 3, 4, 5, 6, 7, 8};
  for (size_t round = 0; round < kWordProducts / kWords; ++round) {
    for (uint64_t& w : word) {
      w *= factor;
      asm("" : "+r"(w));  // a register of its own, not a lane
    }
  }
  uint64_t sum = 0;
  for (const uint64_t w : word) sum += w;
  return sum;
}

}  // namespace pineda::bench
#endif
