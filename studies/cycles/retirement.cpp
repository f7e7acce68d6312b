#include "studies/cycles/retirement.h"

#include <algorithm>

namespace pineda::studies {
namespace {

int64_t at(const std::vector<int64_t>& cycles, size_t index) {
  return index < cycles.size() ? cycles[index] : -1;
}

std::optional<size_t> first_difference(const std::vector<int64_t>& model,
                                       const std::vector<int64_t>& rtl) {
  for (size_t i = 0; i < std::max(model.size(), rtl.size()); ++i) {
    if (at(model, i) != at(rtl, i)) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<RetireDifference> first_retire_difference(const std::vector<int64_t>& model,
                                                        const std::vector<int64_t>& rtl) {
  const auto id = first_difference(model, rtl);
  if (!id) return std::nullopt;
  return RetireDifference{static_cast<uint32_t>(*id), at(model, *id), at(rtl, *id)};
}

const char* boundary_name(Boundary boundary) {
  static constexpr std::array<const char*, kBoundaries> kNames = {"prim", "stamp", "depth write",
                                                                  "colour write"};
  return kNames[static_cast<size_t>(boundary)];
}

const char* unit_before(Boundary boundary) {
  static constexpr std::array<const char*, kBoundaries> kNames = {"setup", "traversal",
                                                                  "interp_ztest", "interp_ztest"};
  return kNames[static_cast<size_t>(boundary)];
}

std::optional<TokenDifference> first_token_difference(const ByBoundary<int64_t>& model,
                                                      const ByBoundary<int64_t>& rtl) {
  std::optional<TokenDifference> first;
  for (size_t b = 0; b < kBoundaries; ++b) {
    const auto i = first_difference(model[b], rtl[b]);
    if (!i) continue;
    const TokenDifference here{static_cast<Boundary>(b), *i, at(model[b], *i), at(rtl[b], *i)};
    if (!first || here.cycle() < first->cycle()) first = here;
  }
  return first;
}

std::vector<Token> tokens_around(const std::vector<Token>& tokens, int64_t cycle) {
  const auto here =
      std::lower_bound(tokens.begin(), tokens.end(), cycle,
                       [](const Token& token, int64_t value) { return token.cycle < value; });
  return {here - std::min<std::ptrdiff_t>(2, here - tokens.begin()),
          here + std::min<std::ptrdiff_t>(3, tokens.end() - here)};
}

}  // namespace pineda::studies
