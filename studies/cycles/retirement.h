// Finds where the cycles of model and RTL first differ: triangle, unit and token.
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

/// The cycle of each triangle's last depth or colour write, by triangle number.
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

/// A triangle that model and RTL retire in different cycles; -1: that side never retires it.
struct RetireDifference {
  uint32_t triangle = 0;
  int64_t model = -1;
  int64_t rtl = -1;
};
/// The first such triangle by number, from RetireCycles::cycles() of both sides.
std::optional<RetireDifference> first_retire_difference(const std::vector<int64_t>& model,
                                                        const std::vector<int64_t>& rtl);

/// The boundaries behind each unit where tokens are compared, in pipeline order.
enum class Boundary : uint8_t { kPrim, kStamp, kDepthWrite, kColorWrite };
inline constexpr size_t kBoundaries = 4;
/// "prim", "stamp", "depth write", "colour write".
const char* boundary_name(Boundary boundary);
/// The unit whose output the boundary is: "setup", "traversal", "interp_ztest".
const char* unit_before(Boundary boundary);

template <class T>
using ByBoundary = std::array<std::vector<T>, kBoundaries>;

/// A token of one triangle that leaves its unit in different cycles in model and RTL; -1: never.
struct TokenDifference {
  Boundary boundary = Boundary::kPrim;
  size_t index = 0;  // among the triangle's tokens at this boundary
  int64_t model = -1;
  int64_t rtl = -1;

  /// The earlier of the two cycles: from here on the two sides differ.
  int64_t cycle() const { return model < 0 || (rtl >= 0 && rtl < model) ? rtl : model; }
};
/// Finds the earliest difference, from the cycles of one triangle's tokens in order: a late unit
/// holds up the units before it only later. If two boundaries differ first in the same cycle, the
/// one further up the pipeline is returned.
std::optional<TokenDifference> first_token_difference(const ByBoundary<int64_t>& model,
                                                      const ByBoundary<int64_t>& rtl);

struct Token {
  int64_t cycle = 0;
  uint32_t triangle = 0;
};
/// The last two tokens before `cycle` and the first three from there on; `tokens` are in order.
std::vector<Token> tokens_around(const std::vector<Token>& tokens, int64_t cycle);

/// A listener for the model or a bench; calls see(boundary, token) for every token.
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
