#include "studies/area/liberty.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <memory>
#include <optional>

#include "studies/area/area_error.h"

namespace pineda::studies {
namespace {

constexpr const char* kUnreadable = "expected a Liberty file, cannot read it";

std::string read_plain_or_gzip(const std::string& file) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(gzopen(file.c_str(), "rb"), gzclose);
  if (stream == nullptr) {
    throw AreaError(fmt::format("{}: {}", file, kUnreadable));
  }
  std::string text;
  std::array<char, 1 << 16> block;
  int bytes = 0;
  while ((bytes = gzread(stream.get(), block.data(), static_cast<unsigned>(block.size()))) > 0) {
    text.append(block.data(), static_cast<size_t>(bytes));
  }
  int error = Z_OK;
  gzerror(stream.get(), &error);
  if (error == Z_ERRNO) throw AreaError(fmt::format("{}: {}", file, kUnreadable));
  if (error != Z_OK) {
    throw AreaError(
        fmt::format("{}: expected a Liberty file, its compressed data are damaged", file));
  }
  return text;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

/// Units by their SI prefix: "1ps" -> {1, 'p'}.
std::optional<double> scaled(const std::string& text, char unit, double of_pico) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  while (*end == ' ') ++end;
  const char prefix = *end == '\0' ? ' ' : static_cast<char>(std::tolower(*end));
  const char name = prefix == ' ' ? ' ' : static_cast<char>(std::tolower(end[1]));
  if (value <= 0 || name != unit) return std::nullopt;
  const std::string prefixes = "fpnu";
  const size_t place = prefixes.find(prefix);
  if (place == std::string::npos) return std::nullopt;
  constexpr std::array<double, 4> kPico{1e-3, 1, 1e3, 1e6};
  return value * kPico[place] * of_pico;
}

/// Groups that are not needed.
bool is_power(const std::string& group) {
  static constexpr std::array<const char*, 8> kGroups{
      "internal_power",      "leakage_power",
      "power_lut_template",  "output_current_rise",
      "output_current_fall", "receiver_capacitance",
      "dc_current",          "normalized_driver_waveform"};
  return std::find(kGroups.begin(), kGroups.end(), group) != kGroups.end();
}

}  // namespace

/// Walks the groups of a file once.
class LibertyReader {
 public:
  LibertyReader(const std::string& file, Liberty* out)
      : file_(file), text_(out->text_), out_(*out) {}

  void run() {
    skip_blank();
    const std::string name = word();
    if (name != "library") fail("library (NAME) {");
    arguments();
    skip_blank();
    take('{', "{ after library (NAME)");
    statements(0);
    if (at_ >= text_.size()) fail("} at the end of the library");
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    const auto line =
        1 + std::count(text_.begin(),
                       text_.begin() + static_cast<ptrdiff_t>(std::min(at_, text_.size())), '\n');
    throw AreaError(fmt::format("{}:{}: expected {}", file_, line, expected));
  }

  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_blank() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (std::isspace(static_cast<unsigned char>(c)) != 0 || c == '\\') {
        ++at_;
      } else if (text_.compare(at_, 2, "/*") == 0) {
        const size_t end = text_.find("*/", at_ + 2);
        if (end == std::string::npos) fail("the end of the comment");
        at_ = end + 2;
      } else if (text_.compare(at_, 2, "//") == 0) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        return;
      }
    }
  }

  void take(char c, const char* expected) {
    if (here() != c) fail(expected);
    ++at_;
  }

  std::string word() {
    const size_t first = at_;
    while (is_word(here())) ++at_;
    if (at_ == first) fail("the name of a group or of an attribute");
    return text_.substr(first, at_ - first);
  }

  void skip_string() {
    ++at_;
    while (here() != '"') {
      if (at_ >= text_.size()) fail("the end of the string");
      ++at_;
    }
    ++at_;
  }

  // What stands between parentheses, without quotes and blanks.
  std::string arguments() {
    skip_blank();
    take('(', "(");
    const size_t first = at_;
    while (here() != ')') {
      if (at_ >= text_.size()) fail(")");
      if (here() == '"') {
        skip_string();
      } else {
        ++at_;
      }
    }
    std::string text = text_.substr(first, at_ - first);
    ++at_;
    return bare(text);
  }

  static std::string bare(std::string text) {
    text.erase(std::remove_if(text.begin(), text.end(),
                              [](char c) {
                                return c == '"' || std::isspace(static_cast<unsigned char>(c)) != 0;
                              }),
               text.end());
    return text;
  }

  // The value of a simple attribute: to the semicolon, or to the end of the line where it is missing.
  std::string value() {
    const size_t first = at_;
    while (at_ < text_.size() && here() != ';' && here() != '\n' && here() != '}') {
      if (here() == '"') {
        skip_string();
      } else {
        ++at_;
      }
    }
    std::string text = text_.substr(first, at_ - first);
    if (here() == ';') ++at_;
    return bare(text);
  }

  void attribute(int depth, const std::string& name, const std::string& value) {
    if (depth == 0 && name == "time_unit") {
      const auto unit = scaled(value, 's', 1);
      if (!unit) fail("a unit of time");
      out_.time_unit_ps_ = *unit;
    } else if (depth == 0 && name == "capacitive_load_unit") {
      std::string unit = value;
      unit.erase(std::remove(unit.begin(), unit.end(), ','), unit.end());
      const auto load = scaled(unit, 'f', 1e3);
      if (!load) fail("a unit of capacitance");
      out_.capacitance_unit_ff_ = *load;
    } else if (depth == 1 && cell_ != nullptr && name == "area") {
      char* end = nullptr;
      cell_->area_um2 = std::strtod(value.c_str(), &end);
      if (end == value.c_str() || *end != '\0' || cell_->area_um2 < 0) fail("an area in um^2");
    }
  }

  void begin_group(int depth, const std::string& name, const std::string& arguments) {
    if (depth == 0 && name == "cell") {
      const auto [place, is_new] = out_.cells_.try_emplace(arguments);
      if (!is_new) fail(fmt::format("one cell {}, this is another", arguments));
      cell_ = &place->second;
    } else if (depth == 1 && cell_ != nullptr) {
      if (name == "ff") cell_->flip_flops += 1;
      if (name == "ff_bank") {
        cell_->flip_flops += std::atoi(arguments.substr(arguments.rfind(',') + 1).c_str());
      }
      if (name == "latch" || name == "latch_bank" || name == "statetable") cell_->is_latch = true;
    }
  }

  // To the brace that closes the group, which is taken.
  void statements(int depth) {
    constexpr int kDeepest = 64;
    if (depth > kDeepest) fail("fewer groups inside one another");
    while (true) {
      skip_blank();
      if (at_ >= text_.size()) fail("}");
      if (here() == '}') {
        if (depth > 0) ++at_;
        return;
      }
      if (here() == ';') {
        ++at_;
        continue;
      }
      const size_t first = at_;
      const std::string name = word();
      skip_blank();
      if (here() == ':') {
        ++at_;
        attribute(depth, name, value());
        continue;
      }
      if (here() != '(') fail(fmt::format(": or ( after {}", name));
      const std::string given = arguments();
      skip_blank();
      if (here() != '{') {
        attribute(depth, name, given);
        continue;
      }
      ++at_;
      begin_group(depth, name, given);
      statements(depth + 1);
      if (is_power(name)) out_.parts_.push_back({first, at_, ""});
      if (depth == 0 && name == "cell") {
        out_.parts_.push_back({first, at_, given});
        cell_ = nullptr;
      }
    }
  }

  const std::string& file_;
  const std::string& text_;
  Liberty& out_;
  LibertyCell* cell_ = nullptr;
  size_t at_ = 0;
};

Liberty Liberty::read(const std::string& file) {
  Liberty library;
  library.text_ = read_plain_or_gzip(file);
  LibertyReader(file, &library).run();
  const bool has_area = std::any_of(library.cells_.begin(), library.cells_.end(),
                                    [](const auto& cell) { return cell.second.area_um2 > 0; });
  if (!has_area) throw AreaError(fmt::format("{}: expected a cell with an area", file));
  if (library.time_unit_ps_ == 0 || library.capacitance_unit_ff_ == 0) {
    throw AreaError(fmt::format("{}: expected time_unit and capacitive_load_unit", file));
  }
  return library;
}

std::string Liberty::text(const std::function<bool(const std::string&)>& keep) const {
  std::string kept;
  size_t done = 0;
  // Outer parts come after the inner ones that they hold.
  std::vector<Part> left_out;
  for (const Part& part : parts_) {
    if (!part.cell.empty() && keep(part.cell)) continue;
    while (!left_out.empty() && left_out.back().first >= part.first) left_out.pop_back();
    left_out.push_back(part);
  }
  for (const Part& part : left_out) {
    kept.append(text_, done, part.first - done);
    done = part.end;
  }
  kept.append(text_, done, std::string::npos);
  return kept;
}

}  // namespace pineda::studies
