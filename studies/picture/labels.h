// Where the names of a plot's points go: beside them, or further away on a leader line.
#pragma once

#include <optional>
#include <vector>

#include "studies/picture/svg.h"

namespace pineda::studies {

/// A point and the size of what is written about it.
struct Label {
  Point at;
  double width = 0;
  double height = 0;
};

/// A box for each label, inside `bounds`, that overlaps no other box and no marker (a square of
/// twice `marker_px` around each point); none where nothing is left. Greedy in several orders, each
/// label in turn moved while that helps; the best is taken: short leaders that cross nothing.
std::vector<std::optional<Box>> place_labels(const std::vector<Label>& labels, const Box& bounds,
                                             double marker_px);

/// The point of the box that is nearest to `p`: where a leader ends.
Point nearest_point(const Box& box, Point p);

}  // namespace pineda::studies
