#include "model/scene/readers/ply_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

// An element's name in a message: as it is if it is short, else shortened and in quotes.
std::string shown(const std::string& name) {
  constexpr size_t kLongest = 40;
  return name.size() <= kLongest ? name : quoted(name);
}

struct TypeRow {
  const char* short_name;
  const char* long_name;
  size_t bytes;
  double low, high;  // range; unlimited for floats
};

// In the order of PlyType.
constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr TypeRow kTypes[] = {{"char", "int8", 1, -128, 127},
                              {"uchar", "uint8", 1, 0, 255},
                              {"short", "int16", 2, -32768, 32767},
                              {"ushort", "uint16", 2, 0, 65535},
                              {"int", "int32", 4, -2147483648., 2147483647.},
                              {"uint", "uint32", 4, 0, 4294967295.},
                              {"float", "float32", 4, -kAny, kAny},
                              {"double", "float64", 8, -kAny, kAny}};

const TypeRow& row(PlyType type) { return kTypes[static_cast<size_t>(type)]; }

bool is_float(PlyType type) { return type == PlyType::kF32 || type == PlyType::kF64; }

template <class T>
double as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

}  // namespace

// In PLY '#' begins no comment inside a word: it may be part of a name.
PlyFile::PlyFile(const std::string& file)
    : file_(file), lines_(file, open_file(file), {false, false}) {
  read_header();
}

void PlyFile::read_header() {
  if (!lines_.next() || !lines_.is("ply")) lines_.fail("'ply'", lines_.raw());
  if (lines_.words().size() > 1)
    lines_.fail("'ply' alone in a line that ends with LF", lines_.raw());
  while (lines_.next()) {
    if (lines_.is("end_header")) {
      if (!has_format_) lines_.fail("a line 'format ...'", lines_.raw());
      return close_element();
    }
    header_line();
  }
  lines_.fail("end_header", "");
}

void PlyFile::header_line() {
  if (lines_.is("comment") || lines_.is("obj_info")) return;
  const bool is_element = lines_.is("element");
  if (!has_format_ && (is_element || lines_.is("property"))) {
    lines_.fail("a line 'format ...'", lines_.raw());
  }
  if (lines_.is("format")) {
    if (has_format_) lines_.fail("one line 'format ...'", lines_.raw());
    read_format();
    has_format_ = true;
  } else if (is_element) {
    close_element();
    read_element();
  } else if (lines_.is("property")) {
    if (elements_.empty()) lines_.fail("an element before its properties", lines_.raw());
    read_property();
  } else if (unknown_lines_++ == 0) {
    first_unknown_line_ = lines_.raw();
  }
}

// Checks the last element when its properties are complete.
void PlyFile::close_element() {
  if (elements_.empty()) return;
  const PlyElement& last = elements_.back();
  if (last.properties.empty()) lines_.fail("a property first", lines_.raw());
  if (!names_.insert(last.name).second) lines_.fail("elements of different names", last.name);
}

void PlyFile::read_format() {
  lines_.expect_words(3, "format ENCODING 1.0");
  const std::string name = lines_.words()[1];
  if (name == "ascii") {
    encoding_ = Encoding::kAscii;
  } else if (name == "binary_little_endian") {
    encoding_ = Encoding::kLittleEndian;
  } else if (name == "binary_big_endian") {
    encoding_ = Encoding::kBigEndian;
  } else {
    lines_.fail("ascii, binary_little_endian or binary_big_endian", name);
  }
  if (std::strcmp(lines_.words()[2], "1.0") != 0) lines_.fail("version 1.0", lines_.words()[2]);
}

void PlyFile::read_element() {
  lines_.expect_words(3, "element NAME COUNT");
  PlyElement element;
  element.name = lines_.words()[1];
  const char* count = lines_.words()[2];
  const char* end = count + std::strlen(count);
  const auto result = std::from_chars(count, end, element.count);
  if (result.ec != std::errc() || result.ptr != end) lines_.fail("a count", count);
  elements_.push_back(std::move(element));
}

void PlyFile::read_property() {
  PlyProperty property;
  const auto& words = lines_.words();
  if (words.size() > 1 && std::strcmp(words[1], "list") == 0) {
    lines_.expect_words(5, "property list TYPE TYPE NAME");
    property.count = type_of(words[2]);
    if (is_float(*property.count)) lines_.fail("an integer type", words[2]);
  } else {
    lines_.expect_words(3, "property TYPE NAME");
  }
  property.type = type_of(words[words.size() - 2]);
  property.name = words.back();
  elements_.back().properties.push_back(std::move(property));
}

PlyType PlyFile::type_of(const char* word) const {
  for (size_t i = 0; i < std::size(kTypes); ++i) {
    if (std::strcmp(word, kTypes[i].short_name) == 0 ||
        std::strcmp(word, kTypes[i].long_name) == 0) {
      return static_cast<PlyType>(i);
    }
  }
  lines_.fail("a type from char to double", word);
}

void PlyFile::begin(const PlyElement& element, uint64_t i) {
  element_ = &element;
  number_ = i;
  next_word_ = 0;
  if (encoding_ == Encoding::kAscii && !lines_.next()) {
    lines_.fail(fmt::format("{} {} of {}", shown(element.name), i, element.count), "");
  }
}

void PlyFile::end() const {
  if (encoding_ == Encoding::kAscii && next_word_ != lines_.words().size()) {
    lines_.fail(fmt::format("the {} words of a {}", next_word_, shown(element_->name)),
                lines_.raw());
  }
}

bool PlyFile::has_more() {
  if (encoding_ == Encoding::kAscii) return lines_.next();
  return lines_.bytes().size() > 0 || lines_.bytes().read_more();
}

void PlyFile::fail(const std::string& expected, const std::string& got) const {
  if (encoding_ == Encoding::kAscii) lines_.fail(expected, got);
  throw InputError(file_, fmt::format("{} {}: expected {}, got {}", quoted(element_->name), number_,
                                      expected, quoted(got)));
}

uint64_t PlyFile::list_size(PlyType type) {
  const double size = number(type);
  if (size < 0) fail("the length of a list", fmt::format("{}", size));
  return static_cast<uint64_t>(size);
}

double PlyFile::word(PlyType type) {
  if (next_word_ == lines_.words().size()) {
    lines_.fail(fmt::format("more words of a {}", shown(element_->name)), lines_.raw());
  }
  const char* text = lines_.words()[next_word_];
  const char* text_end = lines_.end_of_word(next_word_++);
  double value = 0;
  float single = 0;
  const bool is_single = type == PlyType::kF32;
  if (!(is_single ? parse_number(text, text_end, &single) : parse_number(text, text_end, &value))) {
    lines_.fail("a number", text);
  }
  if (is_single) return single;
  if (is_float(type)) return value;
  if (!(value >= row(type).low && value <= row(type).high) || value != std::floor(value)) {
    lines_.fail(fmt::format("a number of type {}", row(type).short_name), text);
  }
  return value;
}

double PlyFile::bytes(PlyType type) {
  const size_t size = row(type).bytes;
  const char* value = lines_.bytes().take_all(size);
  if (value == nullptr) {
    if (lines_.bytes().is_bad()) throw InputError(file_, "expected more bytes, got a read error");
    fail(fmt::format("more bytes, {} of {} elements read", number_, element_->count), "");
  }
  // The host is assumed to be little-endian, as for vectors and .ptrb files.
  char turned[8];
  if (encoding_ == Encoding::kBigEndian) {
    std::reverse_copy(value, value + size, turned);
    value = turned;
  }
  switch (type) {
    case PlyType::kI8:
      return as<int8_t>(value);
    case PlyType::kU8:
      return as<uint8_t>(value);
    case PlyType::kI16:
      return as<int16_t>(value);
    case PlyType::kU16:
      return as<uint16_t>(value);
    case PlyType::kI32:
      return as<int32_t>(value);
    case PlyType::kU32:
      return as<uint32_t>(value);
    case PlyType::kF32:
      return as<float>(value);
    case PlyType::kF64:
      return as<double>(value);
  }
  return 0;
}

}  // namespace pineda::scene
