#include "studies/picture/labels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>

namespace pineda::studies {
namespace {

constexpr int kOrders = 6;
constexpr int kPasses = 6;
constexpr int kDirections = 32;
constexpr double kGapPx = 3;      // around a label
constexpr double kNearestPx = 3;  // beyond the marker
constexpr double kFarthestPx = 400;
// Costs of a placement, in px of leader line.
constexpr double kUnplaced = 1e6;
constexpr double kThroughLabel = 2000;
constexpr double kThroughLeader = 500;
constexpr double kThroughMarker = 300;
constexpr double kBesideAnother = 40;  // near enough to another point to be taken for its label
constexpr double kNotBeside = 4;       // a reader looks to the right of a point first

double cross(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool lines_cross(Point a, Point b, Point c, Point d) {
  return cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0;
}

bool line_meets(const Box& box, Point from, Point to) {
  double enters = 0;
  double leaves = 1;
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) {
      if (start < low || start > high) leaves = -1;
      return;
    }
    const double a = (low - start) / step;
    const double b = (high - start) / step;
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  };
  cut(from.x, to.x - from.x, box.left, box.right());
  cut(from.y, to.y - from.y, box.top, box.bottom());
  return enters <= leaves;
}

Box around(Point p, double radius) { return {p.x - radius, p.y - radius, 2 * radius, 2 * radius}; }

Box grown(const Box& b, double by) {
  return {b.left - by, b.top - by, b.width + 2 * by, b.height + 2 * by};
}

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

class Placement {
 public:
  Placement(const std::vector<Label>& labels, const Box& bounds, double marker_px)
      : labels_(labels), bounds_(bounds), marker_px_(marker_px) {
    boxes_.resize(labels.size());
  }

  // Finds the best place for one label while the others stay; has it moved?
  bool improve(size_t i) {
    std::optional<Box> best = boxes_[i];
    const double before = best ? cost(i, *best) : INFINITY;
    double least = before;
    for (double away = marker_px_ + kNearestPx; away < kFarthestPx; away *= 1.3) {
      for (int k = 0; k < kDirections; ++k) {
        const Box box = candidate(labels_[i], away, k * 2 * M_PI / kDirections);
        if (!is_free(i, box)) continue;
        const double price = cost(i, box);
        if (price >= least) continue;
        least = price;
        best = box;
      }
    }
    boxes_[i] = best;
    return least < before;
  }

  double total_cost() const {
    double total = 0;
    for (size_t i = 0; i < labels_.size(); ++i)
      total += boxes_[i] ? cost(i, *boxes_[i]) : kUnplaced;
    return total;
  }

  const std::vector<std::optional<Box>>& boxes() const { return boxes_; }

 private:
  static Box candidate(const Label& label, double away, double angle) {
    const double x = label.at.x + std::cos(angle) * (away + label.width / 2);
    const double y = label.at.y + std::sin(angle) * (away + label.height / 2);
    return {x - label.width / 2, y - label.height / 2, label.width, label.height};
  }

  bool is_free(size_t i, const Box& box) const {
    if (!bounds_.holds(box)) return false;
    const Box wide = grown(box, kGapPx);
    for (size_t j = 0; j < labels_.size(); ++j) {
      if (box.overlaps(around(labels_[j].at, marker_px_))) return false;
      if (j != i && boxes_[j] && wide.overlaps(*boxes_[j])) return false;
    }
    return true;
  }

  double cost(size_t i, const Box& box) const {
    const Point at = labels_[i].at;
    const Point end = nearest_point(box, at);
    double price = distance(at, end);
    if (box.left < at.x || std::abs(box.top + box.height / 2 - at.y) > 2) price += kNotBeside;
    for (size_t j = 0; j < labels_.size(); ++j) {
      if (j == i) continue;
      const Point other = labels_[j].at;
      if (line_meets(around(other, marker_px_), at, end)) price += kThroughMarker;
      if (distance(other, nearest_point(box, other)) < 2.2 * marker_px_) price += kBesideAnother;
      if (!boxes_[j]) continue;
      const Point other_end = nearest_point(*boxes_[j], other);
      if (line_meets(*boxes_[j], at, end) || line_meets(box, other, other_end)) {
        price += kThroughLabel;
      }
      if (lines_cross(at, end, other, other_end)) price += kThroughLeader;
    }
    return price;
  }

  const std::vector<Label>& labels_;
  Box bounds_;
  double marker_px_;
  std::vector<std::optional<Box>> boxes_;
};

}  // namespace

Point nearest_point(const Box& box, Point p) {
  return {std::clamp(p.x, box.left, box.right()), std::clamp(p.y, box.top, box.bottom())};
}

std::vector<std::optional<Box>> place_labels(const std::vector<Label>& labels, const Box& bounds,
                                             double marker_px) {
  std::vector<size_t> order(labels.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::optional<Box>> best(labels.size());
  double least = INFINITY;
  // A fixed sequence: another one would change the layout of existing pictures.
  std::linear_congruential_engine<uint32_t, 1664525, 1013904223, 0> random(1);
  for (int attempt = 0; attempt < kOrders; ++attempt) {
    Placement placement(labels, bounds, marker_px);
    bool moved = true;
    for (int pass = 0; pass < kPasses && moved; ++pass) {
      moved = false;
      for (const size_t i : order) moved = placement.improve(i) || moved;
    }
    const double cost = placement.total_cost();
    if (cost < least) {
      least = cost;
      best = placement.boxes();
    }
    for (size_t i = order.size(); i > 1; --i) {  // shuffle for the next attempt
      std::swap(order[i - 1], order[(random() >> 16) % i]);
    }
  }
  return best;
}

}  // namespace pineda::studies
