// Where the cycles of model and RTL part: the first triangle, the unit, the token.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "model/timing/counted/listener.h"

namespace pineda::studies {

/// By number of the triangle, the cycle of its last depth or colour write.
class RetireCycles {
 public:
  void note(int64_t cycle, uint32_t triangle) {
    if (triangle >= cycles_.size()) cycles_.resize(size_t{triangle} + 1, -1);
    if (cycle > cycles_[triangle]) cycles_[triangle] = cycle;
  }
  /// -1 where a triangle wrote nothing.
  const std::vector<int64_t>& cycles() const { return cycles_; }

 private:
  std::vector<int64_t> cycles_;
};

/// A triangle that retires in two cycles; -1: it never does.
struct RetireDifference {
  uint32_t triangle = 0;
  int64_t model = -1;
  int64_t rtl = -1;
};
/// The first by number, of RetireCycles::cycles() of both sides.
std::optional<RetireDifference> first_retire_difference(const std::vector<int64_t>& model,
                                                        const std::vector<int64_t>& rtl);

/// Where tokens leave a unit, down the pipeline.
enum class Boundary : uint8_t { kPrim, kStamp, kDepthWrite, kColorWrite };
inline constexpr size_t kBoundaries = 4;
/// "prim", "stamp", "depth write", "colour write".
const char* boundary_name(Boundary boundary);
/// The unit before it: "setup", "traversal", "interp_ztest".
const char* unit_before(Boundary boundary);

template <class T>
using ByBoundary = std::array<std::vector<T>, kBoundaries>;

/// A token of one triangle that leaves its unit in two cycles; -1: it never does.
struct TokenDifference {
  Boundary boundary = Boundary::kPrim;
  size_t index = 0;  // among the triangle's tokens there
  int64_t model = -1;
  int64_t rtl = -1;

  /// The earlier of the two: from here on the sides are not the same.
  int64_t cycle() const { return model < 0 || (rtl >= 0 && rtl < model) ? rtl : model; }
};
/// Of one triangle's tokens, by their cycles in order: the first difference in time, since a unit
/// that is late holds up those before it later on. Of two in one cycle, the one up the pipeline.
std::optional<TokenDifference> first_token_difference(const ByBoundary<int64_t>& model,
                                                      const ByBoundary<int64_t>& rtl);

struct Token {
  int64_t cycle = 0;
  uint32_t triangle = 0;
};
/// Of tokens in order, the two before `cycle` and three from there on.
std::vector<Token> tokens_around(const std::vector<Token>& tokens, int64_t cycle);

/// Listens to the model or to a bench; see(boundary, token) hears of every token.
class TokenListener : public timing::Listener {
 public:
  using See = std::function<void(Boundary, const Token&)>;

  explicit TokenListener(See see) : see_(std::move(see)) {}
  void prim(timing::Cycle cycle, const spec::SetupPrim& t) override {
    tell(Boundary::kPrim, cycle, t.id);
  }
  void stamp(timing::Cycle cycle, const spec::Stamp& t) override {
    tell(Boundary::kStamp, cycle, t.id);
  }
  void depth(timing::Cycle cycle, const spec::DepthWrite& t) override {
    tell(Boundary::kDepthWrite, cycle, t.id);
  }
  void color(timing::Cycle cycle, const spec::ColorWrite& t) override {
    tell(Boundary::kColorWrite, cycle, t.id);
  }

 private:
  void tell(Boundary boundary, timing::Cycle cycle, uint32_t triangle) {
    see_(boundary, {cycle, triangle});
  }
  See see_;
};

}  // namespace pineda::studies
