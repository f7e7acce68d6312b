// The rows of the coverage table for one kind of thing seen, with what was hit.
#pragma once

#include "vectors/coverage/coverage.h"

namespace pineda::vectors {

/// The points of `Seen` that the design has.
template <class Seen>
class Table {
 public:
  Table(const std::vector<Point<Seen>>& points, const spec::Contract& contract) {
    for (const Point<Seen>& point : points) {
      const Bins bins = point.bins(contract);
      if (!bins.empty()) rows_.push_back({&point, bins, Hits(bins)});
    }
  }

  void see(const Seen& seen) {
    for (Row& row : rows_) row.point->see(seen, &row.hits);
  }
  size_t hit() const {
    size_t sum = 0;
    for (const Row& row : rows_) sum += row.hits.hit();
    return sum;
  }
  void list(std::vector<PointHits>* all) const {
    for (const Row& row : rows_) {
      all->push_back({row.point->name, row.point->what, row.bins, row.hits.counts()});
    }
  }

 private:
  struct Row {
    const Point<Seen>* point;
    Bins bins;
    Hits hits;
  };
  std::vector<Row> rows_;
};

}  // namespace pineda::vectors
