#include "vectors/runner/shrink.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace pineda::vectors {

namespace {

template <class Token>
void leave_out(std::vector<Token>* tokens, size_t from, size_t count) {
  const auto first = tokens->begin() + static_cast<std::ptrdiff_t>(from);
  const auto last = first + static_cast<std::ptrdiff_t>(std::min(count, tokens->size() - from));
  // Of a tile's stamps one must be its first.
  if constexpr (std::is_same_v<Token, spec::Stamp>) {
    const bool begins_a_tile =
        std::any_of(first, last, [](const auto& stamp) { return stamp.first; });
    if (begins_a_tile && last != tokens->end()) last->first = true;
  }
  tokens->erase(first, last);
}

template <class Case>
class Shrinker {
 public:
  Shrinker(const spec::Contract& contract, const Case& failing,
           const std::function<bool(const Case&)>& fails)
      : contract_(contract), fails_(fails), case_(failing) {}

  Case run() {
    leave_out_inputs();
    keep_at_any_reset([](Case* c) { c->ports = {}; });
    if constexpr (std::is_same_v<Case, FrameCase>) keep([](Case* c) { c->reset_cycle.reset(); });
    simplify_state();
    halve([](Case* c) -> int& { return c->frame.width; });
    halve([](Case* c) -> int& { return c->frame.height; });
    if constexpr (std::is_same_v<Case, FrameCase> || std::is_same_v<Case, SetupCase>) {
      simplify_vertices();
    }
    leave_out_inputs();
    return case_;
  }

 private:
  // Takes the change if the case still fails.
  template <class Change>
  bool keep(Change&& change) {
    Case candidate = case_;
    change(&candidate);
    candidate = run_model(contract_, candidate);
    if (!fails_(candidate)) return false;
    case_ = std::move(candidate);
    return true;
  }

  // The same, and if need be with the reset in an earlier cycle: what is left out moves what it meets.
  template <class Change>
  bool keep_at_any_reset(Change&& change) {
    if (keep(change)) return true;
    if constexpr (std::is_same_v<Case, FrameCase>) {
      if (!case_.reset_cycle) return false;
      Case candidate = case_;
      change(&candidate);
      candidate = run_model(contract_, candidate);
      for (uint64_t cycle = 0; cycle < *case_.reset_cycle; ++cycle) {
        candidate.reset_cycle = cycle;
        if (!fails_(candidate)) continue;
        case_ = std::move(candidate);
        return true;
      }
    }
    return false;
  }

  // Runs of inputs, from half of them down to single ones.
  void leave_out_inputs() {
    for (size_t length = std::max<size_t>(case_.in.size() / 2, 1); length > 0; length /= 2) {
      for (size_t from = 0; from < case_.in.size();) {
        const bool is_left_out =
            keep_at_any_reset([&](Case* c) { leave_out(&c->in, from, length); });
        if (!is_left_out) from += length;
      }
    }
  }

  void simplify_state() {
    const spec::FrameState plain;
    keep([&](Case* c) {
      spec::FrameState frame;
      frame.width = c->frame.width;
      frame.height = c->frame.height;
      c->frame = frame;
    });
    keep([&](Case* c) {
      c->frame.scissor_x0 = plain.scissor_x0;
      c->frame.scissor_y0 = plain.scissor_y0;
      c->frame.scissor_x1 = plain.scissor_x1;
      c->frame.scissor_y1 = plain.scissor_y1;
    });
    keep([&](Case* c) { c->frame.bias_constant = 0; });
    keep([&](Case* c) { c->frame.bias_slope = 0; });
    keep([&](Case* c) { c->frame.shade = plain.shade; });
    keep([&](Case* c) { c->frame.cull = plain.cull; });
    keep([&](Case* c) { c->frame.clear_depth = plain.clear_depth; });
    keep([&](Case* c) { c->frame.depth = plain.depth; });
    keep([&](Case* c) { c->frame.depth_write = plain.depth_write; });
  }

  // Stamps that are given must stay inside the frame, so theirs is left alone.
  template <class Size>
  void halve(Size&& size) {
    if constexpr (std::is_same_v<Case, InterpZtestCase>) return;
    while (size(&case_) > 1 && keep([&](Case* c) { size(c) = (size(c) + 1) / 2; })) {
    }
  }

  void simplify_vertices() {
    for (size_t i = 0; i < case_.in.size(); ++i) {
      for (size_t k = 0; k < 3; ++k) {
        keep([&](Case* c) { c->in[i].v[k].attr = {}; });
        keep([&](Case* c) { c->in[i].v[k].z = 0; });
      }
    }
  }

  const spec::Contract& contract_;
  const std::function<bool(const Case&)>& fails_;
  Case case_;
};

}  // namespace

template <class Case>
Case shrunk(const spec::Contract& contract, const Case& failing,
            const std::function<bool(const Case&)>& fails) {
  return Shrinker<Case>(contract, failing, fails).run();
}

template SetupCase shrunk(const spec::Contract&, const SetupCase&,
                          const std::function<bool(const SetupCase&)>&);
template TraversalCase shrunk(const spec::Contract&, const TraversalCase&,
                              const std::function<bool(const TraversalCase&)>&);
template InterpZtestCase shrunk(const spec::Contract&, const InterpZtestCase&,
                                const std::function<bool(const InterpZtestCase&)>&);
template FrameCase shrunk(const spec::Contract&, const FrameCase&,
                          const std::function<bool(const FrameCase&)>&);

std::string kind_of(const std::string& difference) {
  const size_t of_case = difference.find(" case ");
  const size_t behind = of_case == std::string::npos ? 0 : difference.find(": ", of_case) + 2;
  std::string kind = difference.substr(behind, difference.find(": expected", behind) - behind);
  // Numbers and what stands in brackets are places.
  std::string text;
  int depth = 0;
  for (const char c : kind) {
    depth += c == '[' || c == '(' ? 1 : 0;
    if (depth == 0 && std::isdigit(static_cast<unsigned char>(c)) == 0) text += c;
    depth -= c == ']' || c == ')' ? 1 : 0;
  }
  return text;
}

}  // namespace pineda::vectors
