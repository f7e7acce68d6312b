#include "studies/error/error_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/picture/numbers.h"

namespace pineda::studies {
namespace {

constexpr size_t kLineChars = 110;

using Row = std::vector<std::string>;

void add_errors(const Distribution& d, Row* row) {
  if (d.count() == 0) {
    row->insert(row->end(), 4, "-");
    return;
  }
  for (const double value : {d.max(), d.quantile(.999), d.rms(), 100 * d.misrounded()}) {
    row->push_back(figure(value));
  }
}

Row accuracy_row(const Subject& s) {
  Row row{s.judged_by_frame ? s.name + " (frame)" : s.name, count_figure(s.missing),
          count_figure(s.extra)};
  add_errors(s.depth, &row);
  add_errors(s.color, &row);
  std::string bound = "-";
  if (s.bounds) {
    bound = fmt::format("{}/{}", figure(s.bounds->depth_ulp), figure(s.bounds->attribute_lsb));
  }
  row.push_back(s.is_design && !s.holds() ? bound + " !" : bound);
  return row;
}

// a / b, or "-" where one of them is not known.
std::string ratio(double a, double b, const char* mark = "") {
  return a > 0 && b > 0 ? figure(a / b) + mark : "-";
}

Row speed_row(const ErrorStudy& study, const Subject& s) {
  const auto triangles = static_cast<double>(study.triangles);
  const auto samples = static_cast<double>(study.samples);
  const bool visits = !s.cycles && s.visited;
  const double cycles = s.cycles.value_or(s.visited.value_or(0));
  const char* mark = visits ? "*" : "";
  return {s.name,
          ratio(triangles / 1e6, s.seconds),
          ratio(samples / 1e6, s.seconds),
          ratio(cycles, triangles, mark),
          ratio(cycles, samples, mark),
          s.summary};
}

template <class RowOf>
void fill(const ErrorStudy& study, Table* table, RowOf row_of) {
  for (const Subject& s : study.subjects) {
    (s.is_design ? table->designs : table->baselines).push_back(row_of(s));
  }
}

bool any(const ErrorStudy& study, bool (*is)(const Subject&)) {
  return std::any_of(study.subjects.begin(), study.subjects.end(), is);
}

// Columns of a group stand closer together than groups.
size_t gap(const Column& column) { return column.group.empty() ? 1 : 2; }

std::string line(const Table& table, const std::vector<size_t>& widths, const Row& cells) {
  std::string text;
  for (size_t i = 0; i < cells.size(); ++i) {
    if (i != 0) text.append(gap(table.columns[i]), ' ');
    const bool is_text = table.columns[i].is_text;
    text += is_text ? fmt::format("{:<{}}", cells[i], widths[i])
                    : fmt::format("{:>{}}", cells[i], widths[i]);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  if (text.size() > kLineChars) text = text.substr(0, kLineChars - 3) + "...";
  return text;
}

// The names of groups, each from where its first column starts.
std::string group_line(const Table& table, const std::vector<size_t>& widths) {
  std::string text;
  size_t at = 0;
  for (size_t i = 0; i < table.columns.size(); ++i) {
    if (i != 0) at += gap(table.columns[i]);
    const std::string& group = table.columns[i].group;
    if (!group.empty()) {
      text.resize(std::max(at, text.size() + 1), ' ');
      text += group;
    }
    at += widths[i];
  }
  return text;
}

std::vector<std::string> lines(const Table& table) {
  std::vector<size_t> widths;
  Row heads;
  for (const Column& column : table.columns) {
    heads.push_back(column.name);
    widths.push_back(column.name.size());
  }
  for (const auto* rows : {&table.designs, &table.baselines}) {
    for (const Row& row : *rows) {
      for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::vector<std::string> result{group_line(table, widths), line(table, widths, heads)};
  const auto add_rule = [&] { result.emplace_back(result[1].size(), '-'); };
  add_rule();
  for (const Row& row : table.designs) result.push_back(line(table, widths, row));
  if (!table.designs.empty() && !table.baselines.empty()) add_rule();
  for (const Row& row : table.baselines) result.push_back(line(table, widths, row));
  result.insert(result.end(), table.notes.begin(), table.notes.end());
  return result;
}

}  // namespace

Table accuracy(const ErrorStudy& study) {
  Table table;
  table.columns = {{"", "", true},        {"samples", "missing"}, {"", "extra"},
                   {"depth, ulp", "max"}, {"", "p99.9"},          {"", "rms"},
                   {"", "off%"},          {"colour, LSB", "max"}, {"", "p99.9"},
                   {"", "rms"},           {"", "off%"},           {"bound", "ulp/LSB", true}};
  fill(study, &table, accuracy_row);
  if (any(study, [](const Subject& s) { return s.is_design && !s.holds(); })) {
    table.notes.emplace_back("! the design misses a sample, draws a wrong one or breaks its bound");
  }
  if (any(study, [](const Subject& s) { return s.judged_by_frame; })) {
    table.notes.emplace_back("(frame) only the visible samples of the finished frame are judged");
  }
  return table;
}

Table speed(const ErrorStudy& study) {
  Table table;
  table.columns = {{"", "", true},           {"software", "Mtri/s"}, {"", "Mpx/s"},
                   {"cycles a", "triangle"}, {"", "pixel"},          {"what it is", "", true}};
  fill(study, &table, [&](const Subject& s) { return speed_row(study, s); });
  if (any(study, [](const Subject& s) { return !s.cycles && s.visited; })) {
    table.notes.emplace_back("* pixels that its loops look at, one a clock");
  }
  return table;
}

std::vector<std::string> accuracy_table(const ErrorStudy& study) { return lines(accuracy(study)); }
std::vector<std::string> speed_table(const ErrorStudy& study) { return lines(speed(study)); }

}  // namespace pineda::studies
