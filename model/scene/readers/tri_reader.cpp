#include "model/scene/readers/tri_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "model/scene/state.h"

namespace pineda::scene {
namespace {

constexpr std::string_view kFirstLine = "pineda-tri 1";

}  // namespace

struct TriReader::StateLine {
  const char* key;
  const char* form;
  size_t words;
  void (TriReader::*read)();
};

const std::array<TriReader::StateLine, 8> TriReader::kStateLines{{
    {"size", "size WIDTH HEIGHT", 3, &TriReader::read_size},
    {"cull", "cull none|back|front", 2, &TriReader::read_word<spec::Cull, &spec::FrameState::cull>},
    {"depth", "depth FUNCTION", 2,
     &TriReader::read_word<spec::DepthFunc, &spec::FrameState::depth>},
    {"scissor", "scissor X Y WIDTH HEIGHT", 5, &TriReader::read_scissor},
    {"depthwrite", "depthwrite on|off", 2,
     &TriReader::read_word<bool, &spec::FrameState::depth_write>},
    {"depthbias", "depthbias CONSTANT SLOPE", 3, &TriReader::read_bias},
    {"cleardepth", "cleardepth Z", 2, &TriReader::read_clear_depth},
    {"shade", "shade smooth|flat", 2, &TriReader::read_word<spec::Shade, &spec::FrameState::shade>},
}};

// The index of a key in kStateLines; the table's size if it is not there.
size_t TriReader::find_state_line(const char* key) {
  size_t i = 0;
  while (i < kStateLines.size() && std::string_view(key) != kStateLines[i].key) ++i;
  return i;
}

TriReader::TriReader(const spec::Contract& contract, const std::string& file,
                     std::unique_ptr<std::istream> stream)
    : design_(contract.design), lines_(file, std::move(stream)) {
  read_state();
}

void TriReader::rewind() {
  lines_.rewind();
  seen_ = {};
  next_ = 0;
  read_state();
}

// Is the line exactly kFirstLine, apart from a CR at its end?
bool TriReader::is_first_line() const {
  std::string_view line = lines_.raw();
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line == kFirstLine;
}

void TriReader::read_state() {
  frame_ = {};
  if (!lines_.next() || !is_first_line()) {
    lines_.fail(fmt::format("the first line '{}'", kFirstLine), lines_.raw());
  }
  while ((at_vertex_ = lines_.next()) && !lines_.is("v")) state_line();
  if (!seen_[find_state_line("size")]) {
    lines_.fail("a line 'size WIDTH HEIGHT' before the vertices", lines_.raw());
  }
}

void TriReader::state_line() {
  const size_t i = find_state_line(lines_.words()[0]);
  if (i == kStateLines.size()) {
    std::string known;
    for (const StateLine& line : kStateLines) known += fmt::format("{}, ", line.key);
    lines_.fail(known + "or v", lines_.raw());
  }
  if (std::exchange(seen_[i], true)) lines_.fail("each state line once", lines_.raw());
  lines_.expect_words(kStateLines[i].words, kStateLines[i].form);
  (this->*kStateLines[i].read)();
}

void TriReader::read_size() {
  const int greatest_px = 1 << design_.guard_bits;
  frame_.width = lines_.integer(1, 1, greatest_px, "a width");
  frame_.height = lines_.integer(2, 1, greatest_px, "a height");
}

void TriReader::read_scissor() {
  constexpr int kLeast = std::numeric_limits<int>::min();
  constexpr int kGreatest = std::numeric_limits<int>::max();
  const int x = lines_.integer(1, kLeast, kGreatest, "a column");
  const int y = lines_.integer(2, kLeast, kGreatest, "a row");
  const int width = lines_.integer(3, 0, kGreatest, "a width");
  const int height = lines_.integer(4, 0, kGreatest, "a height");
  set_scissor(x, y, width, height, &frame_);
}

void TriReader::read_bias() {
  const auto constant = parse_bias_constant(lines_.words()[1], design_.depth_bits);
  if (!constant) lines_.fail(expected_bias_constant(design_.depth_bits), lines_.words()[1]);
  const auto slope = parse_bias_slope(lines_.words()[2]);
  if (!slope) lines_.fail(kExpectedBiasSlope, lines_.words()[2]);
  frame_.bias_constant = *constant;
  frame_.bias_slope = slope->units;
  rounded_slope_ = slope->rounded;
}

void TriReader::read_clear_depth() {
  const auto z = parse_clear_depth(lines_.words()[1]);
  if (!z) lines_.fail(kExpectedClearDepth, lines_.words()[1]);
  frame_.clear_depth = *z;
}

template <class T, T spec::FrameState::*Member>
void TriReader::read_word() {
  const auto value = spec::named<T>(lines_.words()[1]);
  if (!value) {
    lines_.fail(fmt::format("{} {}", lines_.words()[0], spec::alternatives<T>()), lines_.raw());
  }
  frame_.*Member = *value;
}

ScreenVertex TriReader::vertex(Counters* counters) const {
  if (!lines_.is("v")) {
    if (find_state_line(lines_.words()[0]) != kStateLines.size()) {
      lines_.fail("state lines before the first v", lines_.raw());
    }
    lines_.fail("a vertex 'v X Y Z W R G B A'", lines_.raw());
  }
  lines_.expect_words(9, "v X Y Z W R G B A");
  ScreenVertex v;
  v.x = lines_.number(1);
  v.y = lines_.number(2);
  v.z = lines_.number(3);
  v.w = lines_.number(4);
  if (!std::isnan(v.w) && !(std::isnormal(v.w) && v.w > 0)) {
    lines_.fail("W > 0, neither denormal nor infinite", lines_.words()[4]);
  }
  for (size_t i = 0; i < 4; ++i) {
    v.rgba[i] = static_cast<uint8_t>(lines_.integer(5 + i, 0, 255, "a colour"));
  }
  counters->perspective += v.w != 1 && !std::isnan(v.w) ? 1 : 0;
  return v;
}

bool TriReader::read(ScreenTriangle* triangle, Counters* counters) {
  if (!at_vertex_) return false;
  if (next_ >> spec::kTriangleIdBits != 0) {
    lines_.fail("at most 2^32 triangles", "one more");
  }
  triangle->id = static_cast<uint32_t>(next_++);
  for (size_t i = 0; i < 3; ++i) {
    if (!at_vertex_) lines_.fail("a multiple of three vertices", fmt::format("{} more", i));
    triangle->v[i] = vertex(counters);
    at_vertex_ = lines_.next();
  }
  ++counters->triangles;
  return true;
}

}  // namespace pineda::scene
