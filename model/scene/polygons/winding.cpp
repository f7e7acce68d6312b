#include "model/scene/polygons/winding.h"

#include <algorithm>

namespace pineda::scene {
namespace {

// An edge between two points; `low` comes first in the order of points, by u, then by v.
struct Edge {
  uint32_t low = 0, high = 0;  // corners
  int step = 0;   // 1: the polygon runs from low to high, its inside above; -1: reverse
  int above = 0;  // winding number just above the edge
};

// A sweep line visits the points in order. cut_ holds the edges that it crosses, from below to
// above. Edges that coincide are neighbours in it; only the last one's `above` is valid.
class Sweep {
 public:
  explicit Sweep(const PlanarPolygon& polygon) : polygon_(polygon) {
    const uint32_t n = polygon.size();
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t next = i + 1 < n ? i + 1 : 0;
      const uint32_t from = polygon.place(i), to = polygon.place(next);
      if (from < to) edges_.push_back({i, next, 1, 0});
      if (from > to) edges_.push_back({next, i, -1, 0});
    }
    std::sort(edges_.begin(), edges_.end(), [&](const Edge& a, const Edge& b) {
      return polygon.place(a.low) < polygon.place(b.low);
    });
    corner_at_.resize(polygon.places());
    for (uint32_t i = 0; i < n; ++i) corner_at_[polygon.place(i)] = i;
  }

  bool run() {
    size_t next = 0;
    for (const uint32_t corner : corner_at_) {
      batch_.clear();
      const size_t at = take_those_through(corner);
      while (next < edges_.size() && polygon_.place(edges_[next].low) == polygon_.place(corner)) {
        batch_.push_back(edges_[next++]);
      }
      if (!put_back(corner, at)) return false;
    }
    return true;
  }

 private:
  int side(const Edge& edge, uint32_t corner) const {
    return polygon_.turn(edge.low, edge.high, corner);
  }

  bool cross(const Edge& a, const Edge& b) const {
    return side(a, b.low) * side(a, b.high) < 0 && side(b, a.low) * side(b, a.high) < 0;
  }

  // Removes from cut_ the edges that pass through the corner; those that go on beyond it join the
  // batch. Returns their position in cut_.
  size_t take_those_through(uint32_t corner) {
    const auto first = std::partition_point(
        cut_.begin(), cut_.end(), [&](const Edge& edge) { return side(edge, corner) > 0; });
    auto end = first;
    for (; end != cut_.end() && side(*end, corner) == 0; ++end) {
      if (polygon_.place(end->high) != polygon_.place(corner)) batch_.push_back(*end);
    }
    return static_cast<size_t>(cut_.erase(first, end) - cut_.begin());
  }

  // Inserts the batch, the edges that leave the corner to the right. False if edges cross or a
  // winding number is not 0 or 1.
  bool put_back(uint32_t corner, size_t at) {
    std::sort(batch_.begin(), batch_.end(), [&](const Edge& a, const Edge& b) {
      return polygon_.turn(corner, a.high, b.high) > 0;
    });
    int winding = at > 0 ? cut_[at - 1].above : 0;
    for (size_t i = 0; i < batch_.size(); ++i) {
      batch_[i].above = winding += batch_[i].step;
      const bool is_last =
          i + 1 == batch_.size() || polygon_.turn(corner, batch_[i].high, batch_[i + 1].high) != 0;
      if (is_last && (winding < 0 || winding > 1)) return false;
    }
    cut_.insert(cut_.begin() + static_cast<std::ptrdiff_t>(at), batch_.begin(), batch_.end());
    const size_t end = at + batch_.size();
    if (at > 0 && at < cut_.size() && cross(cut_[at - 1], cut_[at])) return false;
    return end == at || end == 0 || end == cut_.size() || !cross(cut_[end - 1], cut_[end]);
  }

  const PlanarPolygon& polygon_;
  std::vector<Edge> edges_;          // in the order of their points `low`
  std::vector<uint32_t> corner_at_;  // one corner at each point
  std::vector<Edge> cut_;
  std::vector<Edge> batch_;
};

}  // namespace

bool winds_once(const PlanarPolygon& polygon) { return Sweep(polygon).run(); }

}  // namespace pineda::scene
