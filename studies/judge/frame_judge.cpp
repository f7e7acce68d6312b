#include "studies/judge/frame_judge.h"

#include <algorithm>
#include <cmath>

#include "model/judge/exact_terms.h"
#include "model/judge/visible_frame.h"
#include "model/spec/clear_depth.h"
#include "model/spec/package.h"
#include "studies/judge/stated.h"

namespace pineda::studies {
namespace {

using judge::passes;
using spec::DepthFunc;

/// The orders that a code may have to another one.
struct Orders {
  bool less, equal, greater;

  bool may(DepthFunc func, bool pass) const {
    return (less && passes(func, -1) == pass) || (equal && passes(func, 0) == pass) ||
           (greater && passes(func, 1) == pass);
  }
};

Orders orders_of(const Codes& code, const Codes& to) {
  return {code.low < to.high, code.low <= to.high && to.low <= code.high, code.high > to.low};
}

/// The part of `code` that is in such an order to `to`, as far as its ends tell.
Codes narrowed(Codes code, const Codes& to, bool less, bool equal, bool greater) {
  if (!greater) code.high = std::min(code.high, equal ? to.high : to.high - 1);
  if (!less) code.low = std::max(code.low, equal ? to.low : to.low + 1);
  return code;
}

}  // namespace

Fragment fragment_of(const exact::Sample& sample, bool affine) {
  return {sample.z, affine ? sample.affine : sample.perspective};
}

Codes codes_of(const exact::Value& z, const FrameTolerance& tolerance) {
  const double ulp = tolerance.depth_ulp;
  const int64_t top = (int64_t{1} << tolerance.format.depth_bits) - 1;
  const auto reach = static_cast<int64_t>(std::min(std::floor(ulp), static_cast<double>(top))) + 2;
  Codes codes{z.whole - reach, z.whole + reach};
  while (codes.low < z.nearest && z.error_of(codes.low) < -ulp) ++codes.low;
  while (codes.high > z.nearest && z.error_of(codes.high) > ulp) --codes.high;
  return {std::clamp<int64_t>(codes.low, 0, top), std::clamp<int64_t>(codes.high, 0, top)};
}

bool is_color(const Fragment& fragment, const std::array<uint8_t, 4>& rgba, double lsb) {
  for (size_t i = 0; i < 4; ++i) {
    if (std::fabs(fragment.color[i].error_of(rgba[i])) > lsb) return false;
  }
  return true;
}

SameDepth::SameDepth(const exact::Triangle& snapped) {
  const auto& [p, q, r] = snapped;
  if (p.z == q.z && q.z == r.z) {
    constant_z = p.z;
    return;
  }
  const std::array<int64_t, 9> numbers{p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z};
  corners =
      spec::text_hash(std::string(reinterpret_cast<const char*>(numbers.data()), sizeof numbers));
}

FrameJudge::FrameJudge(const spec::FrameState& frame, const FrameTolerance& tolerance,
                       const FrameDump& dump)
    : frame_(frame),
      exact_frame_(judge::exact_frame(frame)),
      tolerance_(tolerance),
      dump_(dump),
      hits_(static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height)) {
  const int64_t clear = spec::depth_code(frame.clear_depth, tolerance.format.depth_bits);
  state_.reserve(hits_.size());
  for (size_t i = 0; i < hits_.size(); ++i) {
    const bool is_black = dump.color && (*dump.color)[i] == std::array<uint8_t, 4>{};
    state_.push_back({{clear, clear}, kNone, is_black, -1});
  }
}

void FrameJudge::triangle(const scene::ScreenTriangle& triangle) {
  const exact::ScreenJudge judge(stated(triangle), tolerance_.format, exact_frame_);
  drawn_.emplace_back(judge.snapped().vertices());
  if (judge.culled()) return;
  const exact::Span rows = judge.rows();
  const bool has_values = dump_.depth || dump_.color;
  const bool with_perspective = dump_.color && !judge.affine();
  for (int y = rows.first; y <= rows.last; ++y) {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(frame_.width);
    const exact::Span span = judge.span(y);
    for (int x = span.first; x <= span.last; ++x) {
      uint16_t& hits = hits_[row + static_cast<size_t>(x)];
      if (hits < UINT16_MAX) ++hits;
    }
    if (!has_values) continue;
    row_.clear();
    judge.row(y, with_perspective, &row_);
    for (const exact::Sample& sample : row_) {
      draw(row + static_cast<size_t>(sample.x), fragment_of(sample, !with_perspective));
    }
  }
}

void FrameJudge::draw(size_t sample, const Fragment& fragment) {
  const auto number = static_cast<uint32_t>(drawn_.size() - 1);
  const bool is_color =
      dump_.color && studies::is_color(fragment, (*dump_.color)[sample], tolerance_.color_lsb);
  const Codes code = codes_of(fragment.z, tolerance_);
  const bool writes = frame_.depth_write && frame_.depth != DepthFunc::kOff;
  const bool less = passes(frame_.depth, -1), equal = passes(frame_.depth, 0),
             greater = passes(frame_.depth, 1);

  before_.clear();
  for (auto at = static_cast<int32_t>(sample); at >= 0;) {
    const State& state = state_[static_cast<size_t>(at)];
    before_.push_back(state);
    const int32_t next = state.next;
    if (static_cast<size_t>(at) >= hits_.size()) {
      state_[static_cast<size_t>(at)].next = free_;
      free_ = at;
    }
    at = next;
  }
  // Where it passes, one state for all that it hides; where it fails, what was there.
  std::optional<State> seen;
  std::vector<State>& after = after_;
  after.clear();
  for (State state : before_) {
    const bool is_tie =
        writes && state.triangle != kNone && drawn_[state.triangle] == drawn_.back();
    const Orders orders = is_tie ? Orders{false, true, false} : orders_of(code, state.stored);
    if (orders.may(frame_.depth, true)) {
      const Codes stored =
          writes ? narrowed(code, state.stored, less, equal, greater) : state.stored;
      if (!seen) {
        seen = State{stored, number, is_color, -1};
      } else {
        seen->stored = {std::min(seen->stored.low, stored.low),
                        std::max(seen->stored.high, stored.high)};
      }
    }
    if (!orders.may(frame_.depth, false)) continue;
    // code fails against stored: stored is greater where code is not less, and so on.
    state.stored = narrowed(state.stored, code, !greater, !equal, !less);
    after.push_back(state);
  }
  if (seen) after.push_back(*seen);
  int32_t next = -1;
  for (size_t i = after.size(); i-- > 1;) {
    after[i].next = next;
    next = new_state(after[i]);
  }
  after.front().next = next;
  state_[sample] = after.front();
}

int32_t FrameJudge::new_state(const State& state) {
  if (free_ < 0) {
    state_.push_back(state);
    return static_cast<int32_t>(state_.size() - 1);
  }
  const int32_t at = free_;
  free_ = state_[static_cast<size_t>(at)].next;
  state_[static_cast<size_t>(at)] = state;
  return at;
}

bool FrameJudge::is_wrong(size_t sample) const {
  if (dump_.hits && (*dump_.hits)[sample] != hits_[sample]) return true;
  if (!dump_.depth && !dump_.color) return false;
  for (auto at = static_cast<int32_t>(sample); at >= 0; at = state_[static_cast<size_t>(at)].next) {
    const State& state = state_[static_cast<size_t>(at)];
    if ((!dump_.depth || state.stored.holds((*dump_.depth)[sample])) &&
        (!dump_.color || state.is_color)) {
      return false;
    }
  }
  return true;
}

std::vector<std::optional<uint32_t>> FrameJudge::seen(size_t sample) const {
  std::vector<std::optional<uint32_t>> triangles;
  for (auto at = static_cast<int32_t>(sample); at >= 0; at = state_[static_cast<size_t>(at)].next) {
    const uint32_t triangle = state_[static_cast<size_t>(at)].triangle;
    triangles.push_back(triangle == kNone ? std::nullopt : std::optional(triangle));
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<size_t> FrameJudge::wrong() const {
  std::vector<size_t> samples;
  for (size_t i = 0; i < hits_.size(); ++i) {
    if (is_wrong(i)) samples.push_back(i);
  }
  return samples;
}

}  // namespace pineda::studies
