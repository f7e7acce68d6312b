#include "tb/scoreboard.h"

namespace pineda::tb {

struct Recorder {
  Reference& to;
  void prim(const spec::SetupPrim& token) { to.prims_.push_back(token); }
  void stamp(const spec::Stamp& token) { to.stamps_.push_back({token, false}); }
  void fragment(const spec::Stamp&, const spec::Fragment&) {}
  void depth(const spec::DepthWrite& token) { to.depths_.push_back(token); }
  void color(const spec::ColorWrite& token) {
    to.stamps_.back().is_seen = true;
    to.colors_.push_back(token);
  }
};

bool Reference::draw() {
  spec::Triangle triangle;
  if (!next_(&triangle)) return false;
  renderer_.draw(triangle, Recorder{*this});
  return true;
}

template <class T>
const T* Reference::front(std::deque<T>* queue) {
  while (queue->empty()) {
    if (!draw()) return nullptr;
  }
  return &queue->front();
}

Scoreboard::Scoreboard(std::string who, const spec::Contract& contract,
                       const spec::FrameState& frame, NextTriangle next)
    : who_(std::move(who)),
      may_leave_out_(contract.design.hierarchical_z),
      reference_(contract, frame, std::move(next)),
      prims_(contract),
      stamps_(contract),
      depths_(contract),
      colors_(contract) {}

void Scoreboard::diverge(const std::string& text, std::optional<Cycle> cycle) {
  ++mismatches_;
  if (!first_.empty()) return;
  first_ = fmt::format("{} {}", who_, text);
  first_cycle_ = cycle;
}

// True when a token was expected, which the caller then pops.
template <class T>
bool Scoreboard::compare(const char* unit, Cycle cycle, const T* expected, const T& got,
                         const spec::Comparer<T>& comparer) {
  ++compared_;
  if (expected == nullptr) {
    diverge(fmt::format("{}: triangle {}, cycle {}: a {} too many", unit, got.id, cycle,
                        spec::struct_name<T>()),
            cycle);
    return false;
  }
  if (const auto text = comparer.difference(*expected, got)) {
    diverge(fmt::format("{}: triangle {}, cycle {}: {}.{}", unit, expected->id, cycle,
                        spec::struct_name<T>(), *text),
            cycle);
  }
  return true;
}

void Scoreboard::prim(Cycle cycle, const spec::SetupPrim& got) {
  if (compare("setup", cycle, reference_.prim(), got, prims_)) reference_.pop_prim();
}
// Passes over the stamps that hierarchical z may have hidden: those before the one that came, or at
// the end all that are left.
void Scoreboard::pass_over_hidden(const spec::Stamp* got) {
  const auto is = [](const spec::Stamp& a, const spec::Stamp& b) {
    return a.id == b.id && a.x == b.x && a.y == b.y;
  };
  const spec::Stamp* next;
  while (may_leave_out_ && (next = reference_.stamp()) != nullptr &&
         (got == nullptr || !is(*next, *got)) && reference_.stamp_is_hidden()) {
    ++left_out_;
    reference_.pop_stamp();
  }
}

void Scoreboard::stamp(Cycle cycle, const spec::Stamp& got) {
  pass_over_hidden(&got);
  if (compare("traversal", cycle, reference_.stamp(), got, stamps_)) reference_.pop_stamp();
}
void Scoreboard::depth(Cycle cycle, const spec::DepthWrite& got) {
  if (compare("interp_ztest", cycle, reference_.depth(), got, depths_)) reference_.pop_depth();
}
void Scoreboard::color(Cycle cycle, const spec::ColorWrite& got) {
  if (compare("interp_ztest", cycle, reference_.color(), got, colors_)) reference_.pop_color();
}

void Scoreboard::finish() {
  pass_over_hidden(nullptr);
  const auto missing = [this](const char* unit, auto next, auto pop) {
    while (const auto* token = (reference_.*next)()) {
      diverge(fmt::format("{}: triangle {}: a {} never came", unit, token->id,
                          spec::struct_name<std::decay_t<decltype(*token)>>()));
      (reference_.*pop)();
    }
  };
  missing("setup", &Reference::prim, &Reference::pop_prim);
  missing("traversal", &Reference::stamp, &Reference::pop_stamp);
  missing("interp_ztest", &Reference::depth, &Reference::pop_depth);
  missing("interp_ztest", &Reference::color, &Reference::pop_color);
}

}  // namespace pineda::tb
