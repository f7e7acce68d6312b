// The first output in which two runs of a case differ.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/spec/difference.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {

using spec::Contract;

namespace {

using Text = std::optional<std::string>;

template <class Case>
Text named(const Case& c, const Text& text) {
  if (!text) return text;
  return fmt::format("{} case {}: {}", spec::name_of(Case::kUnit), c.name, *text);
}

const char* outcome(core::Drop drop) {
  return drop == core::Drop::kNone ? "a setup_prim" : core::drop_name(drop);
}

Text drop_difference(const SetupCase& expected, const SetupCase& got) {
  for (size_t i = 0; i < expected.in.size(); ++i) {
    if (i >= got.drops.size()) return fmt::format("triangle {}: expected an outcome, got none", i);
    if (expected.drops[i] == got.drops[i]) continue;
    return fmt::format("triangle {}: expected {}, got {}", i, outcome(expected.drops[i]),
                       outcome(got.drops[i]));
  }
  if (got.drops.size() == expected.drops.size()) return std::nullopt;
  return fmt::format("expected {} outcomes, got {}", expected.drops.size(), got.drops.size());
}

// The first sample that differs: one that is there on one side only, or one of its values.
Text sample_difference(const spec::Design& d, const FrameCase& expected, const FrameCase& got) {
  const auto place = [](const Sample& s) { return std::pair(s.y, s.x); };
  for (size_t i = 0; i < std::max(expected.samples.size(), got.samples.size()); ++i) {
    const bool is_missing =
        i >= got.samples.size() ||
        (i < expected.samples.size() && place(expected.samples[i]) < place(got.samples[i]));
    const bool is_extra =
        i >= expected.samples.size() ||
        (i < got.samples.size() && place(got.samples[i]) < place(expected.samples[i]));
    const Sample& at = is_extra ? got.samples[i] : expected.samples[i];
    const std::string name = fmt::format("sample ({}, {}): ", at.x, at.y);
    if (is_missing) return name + "expected to be drawn, got as cleared";
    if (is_extra) return name + "expected as cleared, got drawn";
    const Sample& a = expected.samples[i];
    const Sample& b = got.samples[i];
    if (a.depth != b.depth) {
      return spec::difference_text(name + "depth", d.depth_bits, 0, "code", a.depth, b.depth);
    }
    for (size_t k = 0; k < a.color.size(); ++k) {
      if (a.color[k] == b.color[k]) continue;
      return spec::difference_text(fmt::format("{}color[{}]", name, k), d.attribute_bits, 0, "LSB",
                                   a.color[k], b.color[k]);
    }
    if (a.hits != b.hits)
      return spec::difference_text(name + "hits", kHitBits, 0, "", a.hits, b.hits);
  }
  return std::nullopt;
}

Text counter_difference(const FrameCase& expected, const FrameCase& got) {
  for (const auto& counter : counters()) {
    const uint64_t a = counter.row->of(expected.counters);
    const uint64_t b = counter.row->of(got.counters);
    if (a != b) return fmt::format("counter {}: expected {}, got {}", counter.name, a, b);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> difference(const Contract& c, const SetupCase& expected,
                                      const SetupCase& got) {
  if (const Text text = drop_difference(expected, got)) return named(expected, text);
  return named(expected, spec::difference(c, expected.out, got.out));
}

std::optional<std::string> difference(const Contract& c, const TraversalCase& expected,
                                      const TraversalCase& got) {
  return named(expected, spec::difference(c, expected.out, got.out));
}

std::optional<std::string> difference(const Contract& c, const InterpZtestCase& expected,
                                      const InterpZtestCase& got) {
  if (const Text text = spec::difference(c, expected.depth, got.depth)) {
    return named(expected, text);
  }
  return named(expected, spec::difference(c, expected.color, got.color));
}

std::optional<std::string> difference(const Contract& c, const FrameCase& expected,
                                      const FrameCase& got) {
  if (const Text text = sample_difference(c.design, expected, got)) return named(expected, text);
  return named(expected, counter_difference(expected, got));
}

}  // namespace pineda::vectors
