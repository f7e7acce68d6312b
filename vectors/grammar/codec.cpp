#include "vectors/grammar/codec.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/spec/clear_depth.h"

namespace pineda::vectors {
namespace {

constexpr int kCounterBits = 32;
constexpr int kHitBits = 16;

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

void refuse_large(const Lines& lines, const spec::FrameState& frame) {
  const int64_t samples = int64_t{frame.width} * frame.height;
  if (samples <= kMaxFrameSamples) return;
  lines.refuse_at(lines.number() - 1,
                  fmt::format("a frame of at most {} samples", kMaxFrameSamples),
                  fmt::format("{}", samples));
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
  const auto expect = [&](bool holds, const char* expected) {
    if (!holds) lines->refuse_at(number, expected, "'" + line + "'");
  };
  expect(frame.width >= 1 && frame.height >= 1, "a frame of at least 1 x 1 px");
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
  refuse_large(*lines, value->frame);
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
  return text +
         "\ncolumns depth code of each sample of the row\n"
         "columns color attributes of each sample of the row, the first attribute first\n"
         "columns hits triangles that cover each sample of the row\n";
}

std::string Codec<FrameCase>::write(const FrameCase& value) const {
  const spec::Design& d = contract_.design;
  const core::FrameBuffer& b = value.buffer;
  std::string text = triangle_.write_all(value.in) + "counters";
  for (const auto& counter : counters()) {
    text += " " + hex(static_cast<int64_t>(counter.row->of(value.counters)), kCounterBits);
  }
  return text + "\n" + write_rows("depth", b.depth, b.width, d.depth_bits, 1) +
         write_rows("color", b.color, b.width, d.attribute_bits, b.channels) +
         write_rows("hits", b.hits, b.width, kHitBits, 1);
}

void Codec<FrameCase>::read(Lines* lines, FrameCase* value) const {
  refuse_large(*lines, value->frame);
  value->in = triangle_.read_all(lines);
  if (!lines->starts_with("counters")) lines->refuse("'triangle' or 'counters'");
  size_t word = 0;
  for (const auto& counter : counters()) {
    const std::string what = fmt::format("counter {}", counter.name);
    const std::string text = lines->word(++word, what);
    counter.row->of(value->counters) = parse_hex(*lines, text, kCounterBits, what);
  }
  if (lines->words() != word + 1) lines->refuse(fmt::format("{} counters", word));
  lines->next();
  const spec::Design& d = contract_.design;
  core::FrameBuffer& b = value->buffer;
  b = core::FrameBuffer(contract_, value->frame);
  read_rows(lines, "depth", &b.depth, b.width, d.depth_bits, 1);
  read_rows(lines, "color", &b.color, b.width, d.attribute_bits, b.channels);
  read_rows(lines, "hits", &b.hits, b.width, kHitBits, 1);
}

template <class Value>
std::string Codec<FrameCase>::write_rows(const char* keyword, const std::vector<Value>& memory,
                                         int width, int bits, int per_sample) const {
  std::string text;
  const auto row = static_cast<size_t>(width) * static_cast<size_t>(per_sample);
  for (size_t i = 0; i < memory.size(); ++i) {
    if (i % row == 0) text += keyword;
    if (i % static_cast<size_t>(per_sample) == 0) text += " ";
    text += hex(memory[i], bits);
    if (i % row == row - 1) text += "\n";
  }
  return text;
}

// Reads rows until the memory is full. A word holds the values of one sample.
template <class Value>
void Codec<FrameCase>::read_rows(Lines* lines, const char* keyword, std::vector<Value>* memory,
                                 int width, int bits, int per_sample) const {
  const size_t digits = static_cast<size_t>(bits + 3) / 4;
  const auto values = static_cast<size_t>(per_sample);
  size_t i = 0;
  while (i < memory->size()) {
    if (!lines->starts_with(keyword) || lines->words() != static_cast<size_t>(width) + 1) {
      lines->refuse(fmt::format("'{}' and {} samples", keyword, width));
    }
    for (size_t x = 1; x < lines->words(); ++x) {
      const std::string& word = lines->word(x, keyword);
      if (word.size() != digits * values) {
        lines->refuse(fmt::format("{} hex digits of {}", digits * values, keyword),
                      "'" + word + "'");
      }
      for (size_t v = 0; v < values; ++v) {
        (*memory)[i++] =
            static_cast<Value>(parse_hex(*lines, word.substr(v * digits, digits), bits, keyword));
      }
    }
    lines->next();
  }
}

}  // namespace pineda::vectors
