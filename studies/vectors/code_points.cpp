#include "studies/vectors/code_points.h"

#include <fmt/format.h>

#include <fstream>
#include <tuple>

#include "vectors/grammar/text.h"

namespace pineda::vectors {
namespace {

// A record is "C 'KEY-VALUE...' COUNT", with these before each key of a letter and each value.
constexpr char kKey = '\1', kValue = '\2';
constexpr const char* kFirstLine = "# SystemC::Coverage-3";

std::string value_of(const std::string& record, char key) {
  const size_t at = record.find(std::string{kKey, key, kValue});
  if (at == std::string::npos) return {};
  return record.substr(at + 3, record.find(kKey, at + 3) - at - 3);
}

// The path from rtl/ on. The package is generated elsewhere.
std::string file_in_rtl(const std::string& path) {
  const std::string folder = "/rtl/";
  const size_t at = path.rfind(folder);
  return at == std::string::npos ? path.substr(path.rfind('/') + 1)
                                 : path.substr(at + folder.size());
}

CodePoint point_of(const std::string& record) {
  CodePoint point;
  point.file = file_in_rtl(value_of(record, 'f'));
  point.line = std::stoi(value_of(record, 'l'));
  point.column = std::stoi(value_of(record, 'n'));
  point.is_bit = record.find("v_toggle/") != std::string::npos;
  point.name = value_of(record, 'o');
  return point;
}

auto place_of(const CodePoint& p) { return std::tie(p.file, p.line, p.column, p.is_bit, p.name); }

}  // namespace

std::pair<std::string, int> split_bit(const std::string& name) {
  const size_t at = name.rfind('[');
  if (at == std::string::npos || name.back() != ']') return {name, -1};
  return {name.substr(0, at), std::stoi(name.substr(at + 1))};
}

void CodeCounts::add(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  const auto refuse = [&](const char* expected) {
    throw Refused(fmt::format("{}: expected {}, got '{}'", file, expected, line));
  };
  if (!std::getline(stream, line) || line != kFirstLine) refuse(kFirstLine);
  while (std::getline(stream, line)) {
    const size_t end = line.rfind("' ");
    if (line.rfind("C '", 0) != 0 || end == std::string::npos) refuse("C 'POINT' COUNT");
    const std::string record = line.substr(3, end - 3);
    const auto [at, is_new] = records_.try_emplace(record);
    if (is_new) at->second.point = point_of(record);
    at->second.count += std::stoull(line.substr(end + 2));
  }
}

std::vector<CodePoint> CodeCounts::points() const {
  std::map<std::tuple<std::string, int, int, bool, std::string>, CodePoint> all;
  for (const auto& [text, record] : records_) {
    CodePoint& point = all.try_emplace(place_of(record.point), record.point).first->second;
    // What changes twice rises and falls.
    point.is_hit |= record.count >= (point.is_bit ? 2 : 1);
  }
  std::vector<CodePoint> points;
  points.reserve(all.size());
  for (auto& [place, point] : all) points.push_back(std::move(point));
  return points;
}

std::string CodeCounts::text(const std::string& package) const {
  std::string all = std::string(kFirstLine) + "\n";
  for (const auto& [text, record] : records_) {
    std::string placed = text;
    if (record.point.file == kPackageFile) {
      const std::string path = value_of(text, 'f');
      placed.replace(placed.find(path), path.size(), package);
    }
    all += fmt::format("C '{}' {}\n", placed, record.count);
  }
  return all;
}

}  // namespace pineda::vectors
