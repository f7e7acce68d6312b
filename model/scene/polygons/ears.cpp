#include "model/scene/polygons/ears.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace pineda::scene {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

// Which ears are taken; each one takes those before it too.
enum class Care {
  kClear,     // turning left, touched by no other corner; and spikes and repeated corners
  kTouching,  // other corners may touch it from outside
  kStraight   // and corners in the middle of a straight run, of triangles without area
};

// A corner that may lie in the way of an ear: it does not turn left.
struct Blocker {
  uint32_t corner, u, v;
};

struct Box {
  uint32_t low_u, high_u, low_v, high_v;
  bool holds(const Blocker& b) const {
    return b.u >= low_u && b.u <= high_u && b.v >= low_v && b.v <= high_v;
  }
};

// The blockers, kept in cells of equally many ranks each: an ear looks at those around it alone.
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
    // Where one coordinate has few ranks (the teeth of a comb) the other one has the more cells.
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

  // Does `is_hit` hold for one in the box? Those for which `is_none` holds are forgotten.
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

  // How many cells and blockers were looked at.
  uint64_t steps() const { return steps_; }

 private:
  static constexpr uint32_t kCornersInACell = 8;

  const PlanarPolygon& polygon_;
  uint32_t u_width_ = 1, v_width_ = 1;  // ranks
  size_t columns_ = 1;
  std::vector<std::vector<Blocker>> cell_;  // row by row; among them some that are none any more
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

  // As many as can be cut in so many steps; the corners that are left, in order.
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

  // Does a corner without a turn lie between its neighbours?
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
    for (const size_t k : {2, 0, 1}) {  // most lie beyond the side that is cut
      side[k] = polygon_.turn(ear[k], ear[(k + 1) % 3], i);
      if (side[k] < 0) return false;
    }
    if (care_ == Care::kClear) return true;
    // On the ear's border it is, if one of its edges leads inside.
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
      // A cut may turn a spike's corner to the right again.
      const int turn = turn_at(i);
      if (turn_[i] > 0 && turn <= 0) blockers_.add(i);
      turn_[i] = turn;
      wait_for(i);
    }
  }

  const PlanarPolygon& polygon_;
  Blockers blockers_;
  std::vector<uint32_t> next_, previous_;  // of the corners left; a corner that is cut: itself
  std::vector<int> turn_;
  std::vector<bool> is_waiting_;
  std::deque<uint32_t> waiting_;
  uint32_t left_ = 0;
  Care care_ = Care::kClear;
};

// Every way to cut a polygon: from the shortest runs of corners on, a run is closed by its chord if
// a triangle on it leaves two closed runs.
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

constexpr size_t kMostForEveryWay = 256;  // it takes n^3 / 6 steps

bool cut_every_way(const PlanarPolygon& polygon, const std::vector<uint32_t>& corner,
                   Triangles* triangles) {
  return corner.size() <= kMostForEveryWay && EveryWay(polygon, corner).run(triangles);
}

}  // namespace

EarCut cut_ears(const PlanarPolygon& polygon, Triangles* triangles, uint64_t most_steps) {
  const size_t before = triangles->size();
  const auto left = Cutter(polygon).run(most_steps, triangles);
  // Usually a triangle is left. Where ears were cut that led to no end, the rest, or all of a
  // polygon that is small enough, is searched.
  if (cut_every_way(polygon, left, triangles)) return EarCut::kDone;
  triangles->resize(before);
  if (polygon.size() > kMostForEveryWay) return EarCut::kUnknown;
  std::vector<uint32_t> all(polygon.size());
  std::iota(all.begin(), all.end(), 0U);
  return cut_every_way(polygon, all, triangles) ? EarCut::kDone : EarCut::kImpossible;
}

}  // namespace pineda::scene
