#include "model/scene/polygons/ears.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace pineda::scene {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

// Which ears may be cut; each value includes those before it.
enum class Care {
  kClear,     // left turns that no other corner touches; spikes and repeated corners
  kTouching,  // left turns that other corners touch from outside
  kStraight   // corners in the middle of a straight run, whose triangles have no area
};

// A corner that may be in the way of an ear: only corners that do not turn left need testing.
struct Blocker {
  uint32_t corner, u, v;
};

struct Box {
  uint32_t low_u, high_u, low_v, high_v;
  bool holds(const Blocker& b) const {
    return b.u >= low_u && b.u <= high_u && b.v >= low_v && b.v <= high_v;
  }
};

// The blockers in a grid of cells that each span equally many ranks, so that testing an ear only
// looks at blockers near it.
class Blockers {
 public:
  explicit Blockers(const PlanarPolygon& polygon) : polygon_(polygon) {
    const uint32_t n = polygon.size();
    uint32_t u_ranks = 1, v_ranks = 1;
    for (uint32_t i = 0; i < n; ++i) {
      u_ranks = std::max(u_ranks, polygon.u_rank(i) + 1);
      v_ranks = std::max(v_ranks, polygon.v_rank(i) + 1);
    }
    const uint32_t cells = n / kCornersInACell + 1;
    const auto side = static_cast<uint32_t>(std::sqrt(cells));
    // If one coordinate has few ranks (as for a comb), the other one gets more cells.
    const uint32_t columns = std::min(u_ranks, cells / std::min(v_ranks, side));
    const uint32_t rows = std::min(v_ranks, cells / columns);
    u_width_ = u_ranks / columns + 1;
    v_width_ = v_ranks / rows + 1;
    columns_ = u_ranks / u_width_ + 1;
    cell_.resize(size_t{columns_} * (v_ranks / v_width_ + 1));
  }

  void add(uint32_t i) {
    const Blocker blocker{i, polygon_.u_rank(i), polygon_.v_rank(i)};
    cell_[blocker.v / v_width_ * columns_ + blocker.u / u_width_].push_back(blocker);
  }

  // Does `is_hit` hold for any blocker in the box? Removes those for which `is_none` holds: they
  // are no blockers any more.
  template <class IsNone, class IsHit>
  bool any_in(const Box& box, IsNone&& is_none, IsHit&& is_hit) {
    for (size_t row = box.low_v / v_width_; row <= box.high_v / v_width_; ++row) {
      for (size_t column = box.low_u / u_width_; column <= box.high_u / u_width_; ++column) {
        auto& cell = cell_[row * columns_ + column];
        steps_ += 1 + cell.size();
        for (size_t i = 0; i < cell.size();) {
          const Blocker blocker = cell[i];
          if (box.holds(blocker)) {
            if (is_none(blocker.corner)) {
              cell[i] = cell.back();
              cell.pop_back();
              continue;
            }
            if (is_hit(blocker.corner)) return true;
          }
          ++i;
        }
      }
    }
    return false;
  }

  // Number of cells and blockers visited so far.
  uint64_t steps() const { return steps_; }

 private:
  static constexpr uint32_t kCornersInACell = 8;

  const PlanarPolygon& polygon_;
  uint32_t u_width_ = 1, v_width_ = 1;  // ranks
  size_t columns_ = 1;
  std::vector<std::vector<Blocker>> cell_;  // row by row; may contain corners no longer blocking
  uint64_t steps_ = 0;
};

class Cutter {
 public:
  explicit Cutter(const PlanarPolygon& polygon)
      : polygon_(polygon),
        blockers_(polygon),
        next_(polygon.size()),
        previous_(polygon.size()),
        turn_(polygon.size()),
        is_waiting_(polygon.size()) {
    const uint32_t n = polygon.size();
    for (uint32_t i = 0; i < n; ++i) {
      next_[i] = i + 1 < n ? i + 1 : 0;
      previous_[i] = i > 0 ? i - 1 : n - 1;
    }
    for (uint32_t i = 0; i < n; ++i) {
      turn_[i] = turn_at(i);
      if (turn_[i] <= 0) blockers_.add(i);
    }
    left_ = n;
  }

  // Cuts ears until none is found or the steps are used up. Returns the corners left, in order.
  std::vector<uint32_t> run(uint64_t most_steps, Triangles* triangles) {
    bool has_cut = false;
    wait_for_all();
    while (left_ > 3 && blockers_.steps() <= most_steps) {
      if (waiting_.empty()) {
        if (!has_cut && care_ == Care::kStraight) break;
        if (!has_cut) care_ = care_ == Care::kClear ? Care::kTouching : Care::kStraight;
        has_cut = false;
        wait_for_all();
      }
      const uint32_t tip = waiting_.front();
      waiting_.pop_front();
      is_waiting_[tip] = false;
      if (is_cut(tip) || !is_ear(tip)) continue;
      cut(tip, triangles);
      has_cut = true;
    }
    return rest();
  }

 private:
  int turn_at(uint32_t i) const { return polygon_.turn(previous_[i], i, next_[i]); }
  bool is_cut(uint32_t i) const { return next_[i] == i; }

  void wait_for(uint32_t i) {
    if (is_waiting_[i]) return;
    is_waiting_[i] = true;
    waiting_.push_back(i);
  }

  void wait_for_all() {
    for (const uint32_t i : rest()) wait_for(i);
  }

  std::vector<uint32_t> rest() const {
    std::vector<uint32_t> all;
    for (uint32_t i = 0; i < polygon_.size(); ++i) {
      if (!is_cut(i)) all.push_back(i);
    }
    return all;
  }

  bool is_ear(uint32_t tip) {
    if (turn_[tip] < 0) return false;
    if (turn_[tip] > 0) return is_free(previous_[tip], tip, next_[tip]);
    return care_ == Care::kStraight || !is_between(tip);
  }

  // Does a corner on a straight line lie between its neighbours (no spike, no repeated corner)?
  bool is_between(uint32_t tip) const {
    const uint32_t a = polygon_.place(previous_[tip]), b = polygon_.place(tip),
                   c = polygon_.place(next_[tip]);
    return (a < b && b < c) || (a > b && b > c);
  }

  bool is_free(uint32_t a, uint32_t b, uint32_t c) {
    const auto u = std::minmax({polygon_.u_rank(a), polygon_.u_rank(b), polygon_.u_rank(c)});
    const auto v = std::minmax({polygon_.v_rank(a), polygon_.v_rank(b), polygon_.v_rank(c)});
    const Box box{u.first, u.second, v.first, v.second};
    return !blockers_.any_in(
        box, [&](uint32_t i) { return is_cut(i) || turn_[i] > 0; },
        [&](uint32_t i) {
          return is_in_the_way(i, {a, b, c});
        });
  }

  bool is_in_the_way(uint32_t i, const std::array<uint32_t, 3>& ear) const {
    if (i == ear[0] || i == ear[1] || i == ear[2]) return false;
    std::array<int, 3> side;
    for (const size_t k : {2, 0, 1}) {  // side 2, the cut, first: most corners lie beyond it
      side[k] = polygon_.turn(ear[k], ear[(k + 1) % 3], i);
      if (side[k] < 0) return false;
    }
    if (care_ == Care::kClear) return true;
    // On the border of the ear a corner is in the way only if one of its edges leads inside.
    for (const uint32_t other : {previous_[i], next_[i]}) {
      bool leads_inside = true;
      for (size_t k = 0; k < 3; ++k) {
        if (side[k] == 0 && polygon_.turn(ear[k], ear[(k + 1) % 3], other) <= 0) {
          leads_inside = false;
        }
      }
      if (leads_inside) return true;
    }
    return false;
  }

  void cut(uint32_t tip, Triangles* triangles) {
    const uint32_t a = previous_[tip], c = next_[tip];
    triangles->push_back({a, tip, c});
    next_[a] = c;
    previous_[c] = a;
    next_[tip] = tip;
    --left_;
    for (const uint32_t i : {a, c}) {
      // Cutting a spike can change a left turn of its neighbours into a right turn.
      const int turn = turn_at(i);
      if (turn_[i] > 0 && turn <= 0) blockers_.add(i);
      turn_[i] = turn;
      wait_for(i);
    }
  }

  const PlanarPolygon& polygon_;
  Blockers blockers_;
  std::vector<uint32_t> next_, previous_;  // among the corners left; next_[i] == i: corner i is cut
  std::vector<int> turn_;
  std::vector<bool> is_waiting_;
  std::deque<uint32_t> waiting_;
  uint32_t left_ = 0;
  Care care_ = Care::kClear;
};

// Searches all triangulations by dynamic programming. A run of corners i .. j can be triangulated
// ("closed" by the chord i-j) if some corner k between them makes a triangle i, k, j that does not
// turn right, and i .. k and k .. j can be triangulated. Shorter runs are done first.
class EveryWay {
 public:
  EveryWay(const PlanarPolygon& polygon, const std::vector<uint32_t>& corner)
      : polygon_(polygon), corner_(corner), n_(corner.size()), apex_(n_ * n_, kNone) {}

  bool run(Triangles* triangles) {
    for (size_t length = 2; length < n_; ++length) {
      for (size_t i = 0; i + length < n_; ++i) close(i, i + length);
    }
    if (!is_closed(0, n_ - 1)) return false;
    add(0, n_ - 1, triangles);
    return true;
  }

 private:
  static constexpr uint32_t kNone = UINT32_MAX;

  bool is_closed(size_t i, size_t j) const { return j == i + 1 || apex_[i * n_ + j] != kNone; }

  void close(size_t i, size_t j) {
    for (size_t k = i + 1; k < j; ++k) {
      if (is_closed(i, k) && is_closed(k, j) &&
          polygon_.turn(corner_[i], corner_[k], corner_[j]) >= 0) {
        apex_[i * n_ + j] = static_cast<uint32_t>(k);
        return;
      }
    }
  }

  void add(size_t i, size_t j, Triangles* triangles) const {
    if (j == i + 1) return;
    const size_t k = apex_[i * n_ + j];
    triangles->push_back({corner_[i], corner_[k], corner_[j]});
    add(i, k, triangles);
    add(k, j, triangles);
  }

  const PlanarPolygon& polygon_;
  const std::vector<uint32_t>& corner_;
  size_t n_;
  std::vector<uint32_t> apex_;
};

constexpr size_t kMostForEveryWay = 256;  // corners; the search takes n^3 / 6 steps

bool cut_every_way(const PlanarPolygon& polygon, const std::vector<uint32_t>& corner,
                   Triangles* triangles) {
  return corner.size() <= kMostForEveryWay && EveryWay(polygon, corner).run(triangles);
}

}  // namespace

EarCut cut_ears(const PlanarPolygon& polygon, Triangles* triangles, uint64_t most_steps) {
  const size_t before = triangles->size();
  const auto left = Cutter(polygon).run(most_steps, triangles);
  // Usually only a triangle is left. Otherwise search all ways to cut the rest, and then, since the
  // ears cut so far may have been the wrong ones, all ways to cut the whole polygon.
  if (cut_every_way(polygon, left, triangles)) return EarCut::kDone;
  triangles->resize(before);
  if (polygon.size() > kMostForEveryWay) return EarCut::kUnknown;
  std::vector<uint32_t> all(polygon.size());
  std::iota(all.begin(), all.end(), 0U);
  return cut_every_way(polygon, all, triangles) ? EarCut::kDone : EarCut::kImpossible;
}

}  // namespace pineda::scene
