// Where the names of a plot's points go: beside them, or further away on a leader line.
#pragma once

#include <optional>
#include <vector>

#include "studies/svg.h"

namespace pineda::studies {

/// A point and the size of what is written about it.
struct Label {
  Point at;
  double width = 0;
  double height = 0;
};

/// A box for each label, inside `bounds`, that overlaps no other box, no marker (a square of twice
/// `marker_px` around each point) and none of `taken`; none where nothing is left. Greedy, then
/// each label in turn is moved while that helps: short leaders, that cross nothing.
std::vector<std::optional<Box>> place_labels(const std::vector<Label>& labels, const Box& bounds,
                                             const std::vector<Box>& taken, double marker_px);

/// The point of the box that is nearest to `p`: where a leader ends.
Point nearest_point(const Box& box, Point p);

}  // namespace pineda::studies
