#include "model/scene/tri_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace pineda::scene {
namespace {

constexpr const char* kFirstLine = "pineda-tri 1";

bool one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  for (const auto candidate : list) {
    if (word == candidate) return true;
  }
  return false;
}

void once(const LineReader& lines, bool* seen) {
  if (std::exchange(*seen, true)) lines.fail("each state line once", lines.raw());
}

}  // namespace

TriReader::TriReader(const spec::Contract& contract, const std::string& file,
                     std::unique_ptr<std::istream> stream)
    : greatest_size_px_(1 << contract.design.guard_bits), lines_(file, std::move(stream)) {
  read_state();
}

void TriReader::rewind() {
  lines_.rewind();
  has_size_ = has_cull_ = has_depth_ = false;
  next_ = 0;
  read_state();
}

void TriReader::read_state() {
  frame_ = {};
  if (!lines_.next_raw() || lines_.raw() != kFirstLine) {
    lines_.fail(fmt::format("the first line '{}'", kFirstLine), lines_.raw());
  }
  while ((at_vertex_ = lines_.next()) && !lines_.is("v")) state_line();
  if (!has_size_) lines_.fail("a line 'size WIDTH HEIGHT' before the vertices", lines_.raw());
}

void TriReader::state_line() {
  const std::string_view key = lines_.words()[0];
  if (key == "size") {
    once(lines_, &has_size_);
    lines_.expect_words(3, "size WIDTH HEIGHT");
    frame_.width = lines_.integer(1, 1, greatest_size_px_, "a width");
    frame_.height = lines_.integer(2, 1, greatest_size_px_, "a height");
  } else if (key == "cull") {
    once(lines_, &has_cull_);
    lines_.expect_words(2, "cull none|back|front");
    const std::string_view value = lines_.words()[1];
    if (!one_of(value, {"none", "back", "front"})) {
      lines_.fail("cull none, back or front", lines_.raw());
    }
    frame_.cull = value == "none"   ? spec::Cull::kNone
                  : value == "back" ? spec::Cull::kBack
                                    : spec::Cull::kFront;
  } else if (key == "depth") {
    once(lines_, &has_depth_);
    lines_.expect_words(2, "depth less|lequal|off");
    const std::string_view value = lines_.words()[1];
    if (one_of(value, {"never", "equal", "greater", "notequal", "gequal", "always"})) {
      lines_.fail("depth less, lequal or off: this version does not support the others",
                  lines_.raw());
    }
    if (!one_of(value, {"less", "lequal", "off"})) {
      lines_.fail("depth less, lequal or off", lines_.raw());
    }
    frame_.depth = value == "less"     ? spec::DepthFunc::kLess
                   : value == "lequal" ? spec::DepthFunc::kLequal
                                       : spec::DepthFunc::kOff;
  } else if (one_of(key, {"scissor", "depthwrite", "depthbias", "shade"})) {
    lines_.fail(fmt::format("no '{}' line: this version does not support it", key), lines_.raw());
  } else {
    lines_.fail("size, cull, depth or v", lines_.raw());
  }
}

ScreenVertex TriReader::vertex(Counters* counters) const {
  if (!lines_.is("v")) {
    if (one_of(lines_.words()[0],
               {"size", "cull", "depth", "scissor", "depthwrite", "depthbias", "shade"})) {
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
