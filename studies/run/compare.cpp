#include "studies/run/compare.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pineda::studies {
namespace {

using Place = std::tuple<std::string, std::string, std::string, std::string>;

std::map<Place, const Row*> by_place(const std::vector<Row>& rows) {
  std::map<Place, const Row*> found;
  for (const Row& row : rows) {
    if (row.measure == spec::name_of(Measure::kHostSpeed)) continue;
    found[{row.scene, row.design, row.memory, row.measure}] = &row;
  }
  return found;
}

}  // namespace

Comparison compare(const std::vector<Row>& before, const std::vector<Row>& after,
                   double tolerance) {
  Comparison result;
  const auto old_rows = by_place(before);
  const auto new_rows = by_place(after);
  for (const auto& [place, row] : old_rows) {
    if (new_rows.count(place) == 0) result.only_before.push_back(row);
  }
  for (const auto& [place, row] : new_rows) {
    const auto old = old_rows.find(place);
    if (old == old_rows.end()) {
      result.only_after.push_back(row);
      continue;
    }
    ++result.rows;
    std::map<std::string, std::pair<double, double>> figures;  // one that a side lacks is 0 there
    for (const Figure& f : old->second->figures) figures[f.name].first = f.value;
    for (const Figure& f : row->figures) figures[f.name].second = f.value;
    for (const auto& [name, values] : figures) {
      ++result.figures;
      const auto [was, is] = values;
      if (std::abs(is - was) > tolerance * std::abs(was))
        result.changes.push_back({row, name, was, is});
    }
  }
  std::stable_sort(
      result.changes.begin(), result.changes.end(),
      [](const Change& a, const Change& b) { return std::abs(a.share()) > std::abs(b.share()); });
  return result;
}

}  // namespace pineda::studies
