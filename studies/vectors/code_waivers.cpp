#include "studies/vectors/code_waivers.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "model/files/data_folder.h"
#include "model/spec/design.h"
#include "vectors/grammar/text.h"

namespace pineda::vectors {
namespace {

std::filesystem::path rtl(const std::string& file) { return files::data_folder() / "rtl" / file; }

[[noreturn]] void refuse(const std::string& place, const std::string& expected) {
  throw Refused(fmt::format("{}: expected {}", place, expected));
}

/// One table [[waiver]].
class WaiverReader {
 public:
  WaiverReader(const std::string& file, const toml::table& table)
      : place_(fmt::format("{}:{}", file, table.source().begin.line)), table_(table) {}

  CodeWaiver read() const {
    const std::vector<std::string> keys{"file", "blocks", "bits", "designs", "reason"};
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(keys.begin(), keys.end(), name) == keys.end()) {
        refuse(place_, fmt::format("{}, got {}", fmt::join(keys, ", "), name));
      }
    }
    CodeWaiver waiver{place_,        text("file"),     texts("blocks"),
                      texts("bits"), texts("designs"), text("reason")};
    if (waiver.reason.find_first_not_of(' ') == std::string::npos) refuse(place_, "a reason");
    if (waiver.blocks.empty() && waiver.bits.empty()) refuse(place_, "blocks or bits");
    if (waiver.designs.empty()) refuse(place_, "designs");
    if (!std::filesystem::exists(rtl(waiver.file)))
      refuse(place_, "a file in rtl/, got " + waiver.file);
    for (const std::string& design : waiver.designs) {
      if (spec::find_design(design) == nullptr) refuse(place_, "named designs, got " + design);
    }
    return waiver;
  }

 private:
  std::string text(const char* key) const {
    const auto value = table_[key].value_exact<std::string>();
    if (!value) refuse(place_, fmt::format("a text {}", key));
    return *value;
  }
  std::vector<std::string> texts(const char* key) const {
    std::vector<std::string> all;
    if (!table_.contains(key)) return all;
    const toml::array* array = table_[key].as_array();
    if (array == nullptr) refuse(place_, fmt::format("a list of texts {}", key));
    for (const toml::node& item : *array) {
      const auto value = item.value_exact<std::string>();
      if (!value) refuse(place_, fmt::format("a list of texts {}", key));
      all.push_back(*value);
    }
    return all;
  }

  std::string place_;
  const toml::table& table_;
};

bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern[0] == '*') {
    return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
  }
  return !text.empty() && pattern[0] == text[0] && matches(pattern.substr(1), text.substr(1));
}

bool covers_bit(const std::string& pattern, const CodePoint& point) {
  if (!point.is_bit) return false;
  const size_t range = pattern.rfind('[');
  int high = 0, low = 0;
  if (range != std::string::npos &&
      std::sscanf(pattern.c_str() + range, "[%d:%d]", &high, &low) == 2) {
    const auto [signal, bit] = split_bit(point.name);
    const std::string_view named(pattern.data(), range);
    return bit >= low && bit <= high && matches(named, signal);
  }
  for (std::string name = point.name;;) {
    if (matches(pattern, name)) return true;
    const auto [signal, bit] = split_bit(name);
    if (bit < 0) return false;
    name = signal;
  }
}

bool covers_block(const std::string& pattern, const CodePoint& point, RtlSource* source) {
  const size_t colon = pattern.find(": ");
  return !point.is_bit && colon != std::string::npos && pattern.substr(0, colon) == point.name &&
         source->line(point.file, point.line).find(pattern.substr(colon + 2)) != std::string::npos;
}

bool is_for(const CodeWaiver& waiver, const std::string& design) {
  const auto& names = waiver.designs;
  return std::find(names.begin(), names.end(), design) != names.end();
}

}  // namespace

std::vector<CodeWaiver> read_code_waivers(const std::string& file) {
  toml::table table;
  try {
    table = toml::parse_file(file);
  } catch (const toml::parse_error& error) {
    const auto line = error.source().begin.line;
    refuse(line == 0 ? file : fmt::format("{}:{}", file, line),
           fmt::format("TOML: {}", error.description()));
  }
  std::vector<CodeWaiver> waivers;
  for (const auto& [key, node] : table) {
    if (key.str() != "waiver" || node.as_array() == nullptr)
      refuse(file, "tables [[waiver]] alone");
    for (const toml::node& item : *node.as_array()) {
      if (item.as_table() == nullptr) refuse(file, "tables [[waiver]] alone");
      waivers.push_back(WaiverReader(file, *item.as_table()).read());
    }
  }
  return waivers;
}

const std::string& RtlSource::line(const std::string& file, int number) {
  auto [at, is_new] = files_.try_emplace(file);
  if (is_new) {
    std::ifstream from_file(rtl(file));
    std::istringstream from_package(package_);
    std::istream& stream =
        file == kPackageFile ? static_cast<std::istream&>(from_package) : from_file;
    for (std::string line; std::getline(stream, line);) {
      const size_t first = line.find_first_not_of(' ');
      at->second.push_back(first == std::string::npos ? "" : line.substr(first));
    }
  }
  static const std::string kNone;
  const auto index = static_cast<size_t>(number) - 1;
  return index < at->second.size() ? at->second[index] : kNone;
}

std::vector<JudgedPoint> judge_points(const std::vector<CodePoint>& points,
                                      const std::vector<CodeWaiver>& waivers,
                                      const std::string& design, RtlSource* source) {
  std::vector<JudgedPoint> judged;
  for (const CodePoint& point : points) judged.push_back({point, nullptr});
  for (const CodeWaiver& waiver : waivers) {
    const bool has_points = std::any_of(points.begin(), points.end(), [&](const CodePoint& point) {
      return point.file == waiver.file;
    });
    if (!is_for(waiver, design) || !has_points) continue;
    const auto apply = [&](const std::string& pattern, auto covers) {
      size_t waived = 0;
      for (JudgedPoint& p : judged) {
        if (p.point.file != waiver.file || p.point.is_hit || !covers(p.point)) continue;
        if (p.waiver == nullptr) p.waiver = &waiver;
        ++waived;
      }
      if (waived > 0) return;
      refuse(waiver.place, fmt::format("a point of {} that {} does not hit, got '{}'", waiver.file,
                                       design, pattern));
    };
    for (const std::string& pattern : waiver.blocks) {
      apply(pattern, [&](const CodePoint& p) { return covers_block(pattern, p, source); });
    }
    for (const std::string& pattern : waiver.bits) {
      apply(pattern, [&](const CodePoint& p) { return covers_bit(pattern, p); });
    }
  }
  return judged;
}

}  // namespace pineda::vectors
