#include "studies/run/rows_csv.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>

namespace pineda::studies {
namespace {

constexpr const char* kHead = "scene,design,memory,measure,figure,value,key,made_by";
constexpr size_t kColumns = 8;

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::vector<std::string> columns_of(const std::string& line) {
  std::vector<std::string> columns(1);
  bool is_quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      columns.back() += line[++i];
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      columns.emplace_back();
    } else {
      columns.back() += c;
    }
  }
  return columns;
}

}  // namespace

std::string csv_of(const std::vector<Row>& rows) {
  std::string text = std::string(kHead) + "\n";
  for (const Row& row : rows) {
    for (const Figure& figure : row.figures) {
      text += fmt::format("{},{},{},{},{},{},{},{}\n", quoted(row.scene), quoted(row.design),
                          quoted(row.memory), row.measure, figure.name, figure.value, row.key,
                          quoted(row.made_by));
    }
  }
  return text;
}

std::vector<Row> read_csv(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  size_t number = 1;
  const auto refuse = [&](const std::string& expected) {
    throw ResultsError(fmt::format("{}:{}: expected {}", file, number, expected));
  };
  if (!std::getline(in, line))
    throw ResultsError(file + ": expected rows of results, cannot read them");
  if (line != kHead) refuse(fmt::format("the line '{}'", kHead));
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    ++number;
    const auto columns = columns_of(line);
    if (columns.size() != kColumns) {
      refuse(fmt::format("{} columns, got {}", kColumns, columns.size()));
    }
    Figure figure{columns[4], 0};
    const char* const end = columns[5].data() + columns[5].size();
    const auto read = std::from_chars(columns[5].data(), end, figure.value);
    if (read.ec != std::errc() || read.ptr != end)
      refuse("a number as value, got '" + columns[5] + "'");
    if (columns[6].empty()) refuse("a key");
    if (rows.empty() || rows.back().key != columns[6]) {
      rows.push_back({columns[6], columns[0], columns[1], columns[2], columns[3], columns[7], {}});
    }
    rows.back().figures.push_back(figure);
  }
  return rows;
}

}  // namespace pineda::studies
