// The first output in which two runs of a case differ.
#include <fmt/format.h>

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

// One memory of the frame: `per_sample` values a sample, row-major.
template <class Value>
Text memory_difference(const FrameCase& c, const char* name, int bits, int per_sample,
                       const char* unit, const std::vector<Value>& expected,
                       const std::vector<Value>& got) {
  if (expected.size() != got.size()) {
    return fmt::format("{}: expected {} values, got {}", name, expected.size(), got.size());
  }
  for (size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == got[i]) continue;
    const int sample = static_cast<int>(i) / per_sample;
    const std::string element =
        per_sample > 1 ? fmt::format("[{}]", static_cast<int>(i) % per_sample) : "";
    return spec::difference_text(fmt::format("sample ({}, {}): {}{}", sample % c.frame.width,
                                             sample / c.frame.width, name, element),
                                 bits, 0, unit, expected[i], got[i]);
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
  const spec::Design& d = c.design;
  const core::FrameBuffer& a = expected.buffer;
  const core::FrameBuffer& b = got.buffer;
  for (const Text& text :
       {memory_difference(expected, "depth", d.depth_bits, 1, "code", a.depth, b.depth),
        memory_difference(expected, "color", d.attribute_bits, d.attributes, "LSB", a.color,
                          b.color),
        memory_difference(expected, "hits", 16, 1, "", a.hits, b.hits),
        counter_difference(expected, got)}) {
    if (text) return named(expected, text);
  }
  return std::nullopt;
}

}  // namespace pineda::vectors
