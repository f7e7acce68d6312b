#include "model/scene/readers/obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

// Keywords that are ignored: groups, names, display settings, and the details of curves and
// surfaces, which are counted themselves. Materials are counted where they are used.
constexpr std::array<std::string_view, 29> kLeftOut{
    "vt",       "g",         "o",          "s",        "mtllib", "vp",    "mg",    "maplib",
    "usemap",   "bevel",     "lod",        "c_interp", "step",   "ctech", "stech", "cstype",
    "d_interp", "trace_obj", "shadow_obj", "deg",      "bmat",   "parm",  "trim",  "hole",
    "scrv",     "sp",        "end",        "con",      "res"};
constexpr std::array<std::string_view, 7> kSurfaces{"curv", "curv2", "surf", "bzp",
                                                    "bsp",  "cdc",   "cdp"};

template <size_t Count>
bool is_one_of(const std::array<std::string_view, Count>& all, std::string_view word) {
  return std::find(all.begin(), all.end(), word) != all.end();
}

// Parses an index; returns the position after it, or nullptr if there is none.
const char* parse_index(const char* from, const char* end, int* value) {
  const auto result = std::from_chars(from, end, *value);
  return result.ec == std::errc() ? result.ptr : nullptr;
}

}  // namespace

ObjFile::ObjFile(const std::string& file)
    : file_(file), lines_(file, open_file(file), {true, true}) {}

ObjStatements ObjFile::read() {
  while (lines_.next()) statement();
  check_indices();
  if (is_.corners.empty()) lines_.fail("faces (lines 'f ...')", "none");
  return std::move(is_);
}

void ObjFile::statement() {
  const std::string_view keyword = lines_.words()[0];
  if (keyword == "v") return vertex();
  if (keyword == "f") return face();
  if (keyword == "vn") return normal();
  other_statement(keyword);
}

void ObjFile::other_statement(std::string_view keyword) {
  if (is_one_of(kLeftOut, keyword)) return;
  if (keyword == "p") {
    is_.points += lines_.words().size() - 1;
  } else if (keyword == "l") {
    ++is_.lines;
  } else if (is_one_of(kSurfaces, keyword)) {
    ++is_.surfaces;
  } else if (keyword == "usemtl") {
    ++is_.materials;
  } else if (is_.unknown++ == 0) {
    is_.first_unknown = keyword;
    is_.first_unknown_line = lines_.line();
  }
}

void ObjFile::vertex() {
  const size_t numbers = lines_.words().size() - 1;
  if (numbers != 3 && numbers != 4 && numbers != 6 && numbers != 7) {
    throw InputError(
        file_, lines_.line(),
        fmt::format("expected 'v X Y Z [W]' or 'v X Y Z R G B [A]', got {} numbers in {}", numbers,
                    quoted(std::string(lines_.raw()))));
  }
  is_.position.push_back({lines_.number(1), lines_.number(2), lines_.number(3)});
  if (numbers == 4 && lines_.number(4) != 1) lines_.fail("W = 1", lines_.words()[4]);
  if (numbers < 6) return;
  const uint8_t alpha = numbers == 7 ? channel(7) : 255;
  is_.color.push_back({channel(4), channel(5), channel(6), alpha});
}

uint8_t ObjFile::channel(size_t i) const {
  const float value = lines_.number(i);
  if (!(value >= 0 && value <= 1)) lines_.fail("a colour from 0 to 1", lines_.words()[i]);
  return static_cast<uint8_t>(std::lround(value * 255.0));
}

void ObjFile::normal() {
  lines_.expect_words(4, "vn X Y Z");
  is_.normal.push_back({lines_.number(1), lines_.number(2), lines_.number(3)});
}

void ObjFile::face() {
  const size_t corners = lines_.words().size() - 1;
  if (corners < 3) lines_.fail("a face of three or more corners", lines_.raw());
  for (size_t i = 1; i <= corners; ++i) is_.corner.push_back(corner(i));
  is_.corners.push_back(static_cast<uint32_t>(corners));
}

// Parses V, V/VT, V//VN or V/VT/VN, where VT and VN may be missing after their slash.
ObjCorner ObjFile::corner(size_t i) {
  const char* word = lines_.words()[i];
  const char* end = lines_.end_of_word(i);
  int value = 0;
  const char* at = parse_index(word, end, &value);
  if (at == nullptr) bad_corner(word);
  ObjCorner corner;
  corner.vertex = vertex_index(word, value);
  if (at == end) return corner;
  if (*at++ != '/') bad_corner(word);
  if (at != end && *at != '/') at = parse_index(at, end, &value);  // a texture coordinate: not used
  if (at == nullptr) bad_corner(word);
  if (at == end) return corner;
  if (*at++ != '/') bad_corner(word);
  if (at == end) return corner;
  if (parse_index(at, end, &value) != end) bad_corner(word);
  corner.normal = normal_index(value);
  return corner;
}

// Positive indices are checked at the end of the file, since a face may use a vertex that follows
// later.
uint32_t ObjFile::vertex_index(const char* word, int value) {
  const auto count = static_cast<int64_t>(is_.position.size());
  if (value == 0 || value < -count) {
    lines_.fail(fmt::format("an index from 1 on, or from -{} to -1", count), word);
  }
  if (value > greatest_vertex_.index) greatest_vertex_ = {value, lines_.line()};
  return static_cast<uint32_t>(value > 0 ? value - 1 : count + value);
}

// An invalid index becomes one beyond the last, which check_indices() finds at the end of the file.
uint32_t ObjFile::normal_index(int value) const {
  const auto count = static_cast<int64_t>(is_.normal.size());
  if (value > 0) return static_cast<uint32_t>(value - 1);
  return value < 0 && value >= -count ? static_cast<uint32_t>(count + value)
                                      : ObjCorner::kNoNormal - 1;
}

void ObjFile::bad_corner(const char* word) const {
  lines_.fail("a corner V, V/VT, V//VN or V/VT/VN", word);
}

void ObjFile::check_indices() {
  if (greatest_vertex_.index > static_cast<int64_t>(is_.position.size())) {
    throw InputError(file_, greatest_vertex_.line,
                     fmt::format("expected an index of {} vertices, got {}", is_.position.size(),
                                 greatest_vertex_.index));
  }
  for (ObjCorner& corner : is_.corner) {
    if (corner.normal == ObjCorner::kNoNormal || corner.normal < is_.normal.size()) continue;
    corner.normal = ObjCorner::kNoNormal;
    ++is_.missing_normals;
  }
}

}  // namespace pineda::scene
