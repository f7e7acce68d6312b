#include "vectors/grammar/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/spec/clear_depth.h"

namespace pineda::vectors {
namespace {

constexpr const char* kReset = "reset";
constexpr const char* kSample = "sample";

core::Drop read_drop(Lines* lines) {
  for (int i = 1; i < core::kDropCauses; ++i) {
    const auto drop = static_cast<core::Drop>(i);
    if (lines->line() == fmt::format("drop {}", spec::name_of(drop))) {
      lines->next();
      return drop;
    }
  }
  lines->refuse("'drop' and zero_area, facing, no_sample or outside");
}

constexpr const char* kClearDepth = "clear_depth";

std::vector<spec::Field<spec::FrameState>> fields_of_the_line(const spec::Contract& c) {
  auto table = spec::fields<spec::FrameState>(c);
  table.erase(std::remove_if(table.begin(), table.end(),
                             [](const auto& f) { return std::string(f.name) == kClearDepth; }),
              table.end());
  return table;
}

}  // namespace

FrameCodec::FrameCodec(const spec::Contract& c) : contract_(c), row_(c, fields_of_the_line(c)) {}

std::string FrameCodec::write(const spec::FrameState& frame) const {
  const spec::Design& d = contract_.design;
  const uint32_t code = spec::cleared_depth(d, frame);
  if (code == spec::cleared_depth(d, {})) return row_.write(frame);
  return row_.write(frame) + fmt::format("{} {}\n", kClearDepth, hex(code, d.depth_bits));
}

// Reads a frame line: values must fit the struct's widths and have a meaning.
spec::FrameState FrameCodec::read(Lines* lines) const {
  if (!lines->starts_with(row_.keyword())) lines->refuse("'frame'");
  const int number = lines->number();
  const std::string line = lines->line();
  spec::FrameState frame = row_.read(lines);
  const auto expect = [&](bool holds, const std::string& expected) {
    if (!holds) lines->refuse_at(number, expected, "'" + line + "'");
  };
  const int greatest = 1 << contract_.design.guard_bits;
  expect(
      frame.width >= 1 && frame.height >= 1 && frame.width <= greatest && frame.height <= greatest,
      fmt::format("a frame of 1 x 1 to {0} x {0} px", greatest));
  expect(frame.cull <= spec::Cull::kFront, "cull 0, 1 or 2");
  expect(frame.depth <= spec::DepthFunc::kAlways, "depth 0 to 8");
  const spec::Design& d = contract_.design;
  if (!d.depth_test || !lines->starts_with(kClearDepth)) return frame;
  const uint64_t code = parse_hex(*lines, lines->word(1, kClearDepth), d.depth_bits, kClearDepth);
  if (lines->words() != 2 || code == spec::cleared_depth(d, {})) {
    lines->refuse("'clear_depth' and a code less than the greatest");
  }
  frame.clear_depth = spec::depth_of_code(static_cast<uint32_t>(code), d.depth_bits);
  lines->next();
  return frame;
}

std::string Codec<SetupCase>::columns() const { return triangle_.columns() + prim_.columns(); }

std::string Codec<SetupCase>::write(const SetupCase& value) const {
  std::string text = triangle_.write_all(value.in);
  auto prim = value.out.begin();
  for (const core::Drop drop : value.drops) {
    text += drop == core::Drop::kNone ? prim_.write(*prim++)
                                      : fmt::format("drop {}\n", spec::name_of(drop));
  }
  return text;
}

void Codec<SetupCase>::read(Lines* lines, SetupCase* value) const {
  value->in = triangle_.read_all(lines);
  for (size_t i = 0; i < value->in.size(); ++i) {
    if (lines->starts_with("drop")) {
      value->drops.push_back(read_drop(lines));
    } else if (lines->starts_with(prim_.keyword())) {
      value->drops.push_back(core::Drop::kNone);
      value->out.push_back(prim_.read(lines));
    } else {
      lines->refuse(fmt::format("'setup_prim' or 'drop' for triangle {}", i));
    }
  }
}

std::string Codec<TraversalCase>::columns() const { return prim_.columns() + stamp_.columns(); }

std::string Codec<TraversalCase>::write(const TraversalCase& value) const {
  return prim_.write_all(value.in) + stamp_.write_all(value.out);
}

void Codec<TraversalCase>::read(Lines* lines, TraversalCase* value) const {
  value->in = prim_.read_all(lines);
  value->out = stamp_.read_all(lines);
}

std::string Codec<InterpZtestCase>::columns() const {
  return stamp_.columns() + depth_.columns() + color_.columns();
}

std::string Codec<InterpZtestCase>::write(const InterpZtestCase& value) const {
  return stamp_.write_all(value.in) + depth_.write_all(value.depth) + color_.write_all(value.color);
}

void Codec<InterpZtestCase>::read(Lines* lines, InterpZtestCase* value) const {
  while (lines->starts_with(stamp_.keyword())) {
    const int number = lines->number();
    value->in.push_back(stamp_.read(lines));
    if (!covers_frame(value->in.back(), value->frame)) {
      lines->refuse_at(number, "a stamp that covers samples of the frame, and no others",
                       fmt::format("stamp {} of case {}", value->in.size() - 1, value->name));
    }
  }
  value->depth = depth_.read_all(lines);
  value->color = color_.read_all(lines);
}

// Is the stamp not empty, and inside the frame? Memory holds no other samples.
bool Codec<InterpZtestCase>::covers_frame(const spec::Stamp& stamp,
                                          const spec::FrameState& frame) const {
  const int w_log2 = contract_.design.stamp_width_log2;
  bool inside = stamp.mask != 0;
  for (int lane = 0; lane < contract_.width.lanes; ++lane) {
    if ((stamp.mask >> lane & 1) == 0) continue;
    const int x = (stamp.x << w_log2) + (lane & ((1 << w_log2) - 1));
    const int y = (stamp.y << contract_.design.stamp_height_log2) + (lane >> w_log2);
    inside &= x < frame.width && y < frame.height;
  }
  return inside;
}

std::string Codec<FrameCase>::columns() const {
  std::string text = triangle_.columns() + "columns counters";
  for (const auto& counter : counters()) text += fmt::format(" {}", counter.name);
  return text + fmt::format("\ncolumns {} x y depth color hits\n", kSample);
}

std::string Codec<FrameCase>::write(const FrameCase& value) const {
  std::string text = triangle_.write_all(value.in);
  if (value.reset_cycle) text += fmt::format("{} {}\n", kReset, *value.reset_cycle);
  text += "counters";
  for (const auto& counter : counters()) {
    text += " " + hex(static_cast<int64_t>(counter.row->of(value.counters)), kCounterBits);
  }
  text += "\n";
  for (const Sample& s : value.samples) text += write_sample(s);
  return text;
}

std::string Codec<FrameCase>::write_sample(const Sample& s) const {
  const spec::Design& d = contract_.design;
  std::string color;
  for (size_t i = 0; i < static_cast<size_t>(spec::channels(d)); ++i) {
    color += hex(s.color[i], d.attribute_bits);
  }
  return fmt::format("{} {} {} {} {} {}\n", kSample, hex(s.x, kPlaceBits), hex(s.y, kPlaceBits),
                     hex(s.depth, d.depth_bits), color, hex(s.hits, kHitBits));
}

void Codec<FrameCase>::read(Lines* lines, FrameCase* value) const {
  value->in = triangle_.read_all(lines);
  if (lines->starts_with(kReset)) {
    value->reset_cycle = parse_decimal(*lines, lines->word(1, kReset), kReset);
    if (lines->words() != 2) lines->refuse("'reset' and a cycle");
    lines->next();
  }
  if (!lines->starts_with("counters")) lines->refuse("'triangle' or 'counters'");
  size_t word = 0;
  for (const auto& counter : counters()) {
    const std::string what = fmt::format("counter {}", counter.name);
    const std::string text = lines->word(++word, what);
    counter.row->of(value->counters) = parse_hex(*lines, text, kCounterBits, what);
  }
  if (lines->words() != word + 1) lines->refuse(fmt::format("{} counters", word));
  lines->next();
  while (lines->starts_with(kSample)) {
    const Sample sample = read_sample(*lines);
    const bool is_inside = sample.x < value->frame.width && sample.y < value->frame.height;
    const bool is_next =
        value->samples.empty() ||
        std::pair(value->samples.back().y, value->samples.back().x) < std::pair(sample.y, sample.x);
    if (!is_inside || !is_next) lines->refuse("samples of the frame, row by row");
    value->samples.push_back(sample);
    lines->next();
  }
}

// Of the current line.
Sample Codec<FrameCase>::read_sample(const Lines& lines) const {
  const spec::Design& d = contract_.design;
  size_t word = 0;
  const auto number = [&](const char* what, int bits) {
    return parse_hex(lines, lines.word(++word, what), bits, what);
  };
  Sample sample;
  sample.x = static_cast<int>(number("sample x", kPlaceBits));
  sample.y = static_cast<int>(number("sample y", kPlaceBits));
  sample.depth = static_cast<uint32_t>(number("sample depth", d.depth_bits));
  const std::string color = lines.word(++word, "sample color");
  const auto channels = static_cast<size_t>(spec::channels(d));
  const size_t digits = static_cast<size_t>(d.attribute_bits + 3) / 4;
  if (color.size() != channels * digits) {
    lines.refuse(fmt::format("{} hex digits of sample color", channels * digits),
                 "'" + color + "'");
  }
  for (size_t i = 0; i < channels; ++i) {
    sample.color[i] = static_cast<uint16_t>(
        parse_hex(lines, color.substr(i * digits, digits), d.attribute_bits, "sample color"));
  }
  sample.hits = static_cast<uint16_t>(number("sample hits", kHitBits));
  if (lines.words() != word + 1) lines.refuse(fmt::format("{} columns of sample", word));
  return sample;
}

}  // namespace pineda::vectors
