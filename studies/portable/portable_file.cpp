#include "studies/portable/portable_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "model/scene/error.h"
#include "model/scene/readers/lines.h"
#include "model/scene/readers/tri_reader.h"

namespace pineda::studies {
namespace {

constexpr const char* kMagic = "pineda-portable 1";

/// Names become folders.
bool is_name(const std::string& name) {
  constexpr const char* kCharacters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return !name.empty() && name[0] != '.' &&
         name.find_first_not_of(kCharacters) == std::string::npos;
}

bool is_derived(const std::string& line) {
  for (const char* keyword : {"snapped ", "fragment ", "pixel "}) {
    if (line.rfind(keyword, 0) == 0) return true;
  }
  return false;
}

}  // namespace

bool is_portable(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) && line == kMagic;
}

std::string portable_header(const PortableHeader& h) {
  const exact::Format& f = h.tolerance.format;
  return fmt::format(
      "{}\ndesign {}\nlevel {}\nseed {}\nsubpixel_bits {}\nguard_bits {}\ndepth_bits {}\n"
      "depth_ulp {}\ncolor_lsb {}\n",
      kMagic, h.design, h.level, h.seed, f.subpixel_bits, f.guard_bits, f.depth_bits,
      h.tolerance.depth_ulp, h.tolerance.color_lsb);
}

std::string portable_end(uint64_t cases) { return fmt::format("cases {}\n", cases); }

PortableReader::PortableReader(const std::string& path)
    : PortableReader(path, scene::open_file(path)) {}

PortableReader::PortableReader(const std::string& path, std::unique_ptr<std::istream> stream)
    : path_(path), lines_(path, std::move(stream)) {
  read_header();
}

std::string PortableReader::value(const char* key) {
  if (!lines_.next() || !lines_.starts_with(key) || lines_.words() != 2) {
    lines_.refuse(fmt::format("'{}' and its value", key));
  }
  return lines_.word(1);
}

double PortableReader::number(const char* key) {
  const std::string word = value(key);
  double number = 0;
  const bool is_number = scene::parse_number(word.c_str(), word.c_str() + word.size(), &number);
  if (!is_number || !(number >= 0 && number <= 4294967296.)) {
    lines_.refuse(fmt::format("'{}' and a number from 0 to 4294967296", key));
  }
  return number;
}

void PortableReader::read_header() {
  if (!lines_.next() || lines_.line() != kMagic) lines_.refuse(fmt::format("'{}'", kMagic));
  header_.design = value("design");
  header_.level = static_cast<int>(vectors::parse_decimal(lines_, value("level"), "level"));
  header_.seed = vectors::parse_decimal(lines_, value("seed"), "seed");
  exact::Format& format = header_.tolerance.format;
  for (const auto& [key, member] : {std::pair{"subpixel_bits", &exact::Format::subpixel_bits},
                                    {"guard_bits", &exact::Format::guard_bits},
                                    {"depth_bits", &exact::Format::depth_bits}}) {
    const uint64_t bits = vectors::parse_decimal(lines_, value(key), key);
    if (bits > 64) lines_.refuse(fmt::format("'{}' and a number of bits", key));
    format.*member = static_cast<int>(bits);
  }
  contract_ = portable_contract(format, path_, static_cast<uint64_t>(lines_.number()));
  header_.tolerance.depth_ulp = number("depth_ulp");
  header_.tolerance.color_lsb = number("color_lsb");
}

bool PortableReader::next(PortableCase* value) {
  if (!lines_.next() || (!lines_.starts_with("case") && !lines_.starts_with("cases"))) {
    lines_.refuse("'case' and its name, or 'cases' and their number");
  }
  if (lines_.starts_with("cases")) {
    const std::string expected = fmt::format("cases {}", cases_);
    if (lines_.line() != expected) lines_.refuse("'" + expected + "'");
    if (lines_.next()) lines_.refuse("the end of the file");
    return false;
  }
  if (lines_.words() != 2 || !is_name(lines_.word(1))) {
    lines_.refuse("'case' and a name of letters, digits and '_', '-', '.'");
  }
  *value = {};
  value->name = lines_.word(1);
  case_lines_.clear();
  do {
    case_lines_.emplace_back(lines_.number(), lines_.line());
    if (!lines_.next()) lines_.refuse("'end'");
  } while (lines_.line() != "end");
  case_lines_.emplace_back(lines_.number(), lines_.line());
  read_scene(value);
  compare(*value);
  ++cases_;
  return true;
}

// Its lines are those of a .tri file, whose reader counts them.
void PortableReader::read_scene(PortableCase* value) {
  std::string text(static_cast<size_t>(case_lines_.front().first - 1), '\n');
  text += "pineda-tri 1\n";
  for (size_t i = 1; i + 1 < case_lines_.size() && !is_derived(case_lines_[i].second); ++i) {
    text += case_lines_[i].second + "\n";
  }
  scene::TriReader reader(contract_, path_, std::make_unique<std::istringstream>(text));
  value->frame = reader.frame();
  if (value->samples() > kPortableSamples) {
    throw scene::InputError(
        path_, static_cast<uint64_t>(case_lines_.front().first),
        fmt::format("expected a frame of {} samples at most", kPortableSamples));
  }
  scene::Counters counters;
  for (scene::ScreenTriangle triangle; reader.read(&triangle, &counters);) {
    value->triangles.push_back(triangle);
  }
}

void PortableReader::compare(const PortableCase& value) {
  std::istringstream right(portable_text(value, header_.tolerance));
  std::string expected;
  for (const auto& [number, line] : case_lines_) {
    std::getline(right, expected);
    if (line != expected) lines_.refuse_at(number, "'" + expected + "'", "'" + line + "'");
  }
}

}  // namespace pineda::studies
