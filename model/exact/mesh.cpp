#include "model/exact/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "model/exact/lines.h"

namespace exact {

namespace {

// value / 2^least as an integer.
Integer scaled(double value, int least) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  Integer integer(static_cast<int64_t>(std::ldexp(mantissa, 53)));
  return value == 0 ? Integer(0) : Integer(integer << (exponent - 53 - least));
}

// An exponent e such that all coordinates of the corners are multiples of 2^e.
int least_exponent(const std::vector<ClipCorner>& corners) {
  int least = std::numeric_limits<int>::max();
  for (const ClipCorner& c : corners) {
    for (const double value : {c.x, c.y, c.z, c.w}) {
      int exponent = 0;
      std::frexp(value, &exponent);
      if (value != 0) least = std::min(least, exponent - 53);
    }
  }
  return least == std::numeric_limits<int>::max() ? 0 : least;
}

void convert(const std::vector<ClipCorner>& from, std::vector<Corner<Approximate>>* to) {
  for (const ClipCorner& c : from) {
    to->push_back({Approximate(c.x), Approximate(c.y), Approximate(c.z), Approximate(c.w)});
  }
}

void convert(const std::vector<ClipCorner>& from, std::vector<Corner<Integer>>* to) {
  const int e = least_exponent(from);
  for (const ClipCorner& c : from) {
    to->push_back({scaled(c.x, e), scaled(c.y, e), scaled(c.z, e), scaled(c.w, e)});
  }
}

Span common(const Span& a, const Span& b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

bool is_empty(const Span& s) { return s.first > s.last; }

}  // namespace

struct FaceJudge::Planes {
  /// The lines of the edges in order, then those of add_lines(), which are positive where the face
  /// is drawn.
  template <class T>
  struct Lines {
    std::vector<Corner<T>> corner;
    std::vector<Line<T>> line;
    T area;                 // the sum of `pieces`: positive when counter-clockwise on screen
    std::vector<T> pieces;  // for each triangle of the fan, the determinant of its corners
  };

  Planes(const std::vector<ClipCorner>& corner, const MeshFrame& frame)
      : corner_(corner), frame_(frame) {
    start(&approximate);
    best =
        static_cast<size_t>(std::max_element(approximate.pieces.begin(), approximate.pieces.end(),
                                             [](const Approximate& a, const Approximate& b) {
                                               return std::abs(a.value) < std::abs(b.value);
                                             }) -
                            approximate.pieces.begin());
    facing = sign([](const auto& lines) { return lines.area; });
    best_way = sign([this](const auto& lines) { return lines.pieces[best]; });
    add_lines(&approximate);
    exact_.reset();  // made before best and best_way were known, so its further lines are wrong
  }

  /// The sign of call(lines): from floating point if certain, else from integers.
  template <class Call>
  int sign(Call call) const {
    const Approximate value = call(approximate);
    if (is_certain(value)) return sign_of(value);
    return sign_of(static_cast<Integer>(call(exactly())));
  }

  /// The sign of way * line i at pixel (x, y), plus `margin` bands.
  int sign(size_t i, int way, int x, int y, int margin) const {
    return sign([&](const auto& lines) {
      using T = std::decay_t<decltype(lines.area)>;
      const Line<T>& l = lines.line[i];
      return T(T(way) * (l.a * T(x) + l.b * T(y) + l.c) + T(margin) * l.band);
    });
  }

  /// Does corner i lie above the samples of row y?
  bool is_above(size_t i, int y) const {
    return sign([&](const auto& lines) {
             using T = std::decay_t<decltype(lines.area)>;
             const Corner<T>& p = lines.corner[i];
             return T(T(frame_.height) * p.y - T(frame_.height - 2 * y - 1) * p.w);
           }) > 0;
  }

  Lines<Approximate> approximate;
  size_t best = 0;   // the fan's greatest triangle, which defines the face's plane most accurately
  int best_way = 0;  // the sign of its determinant: its facing
  int facing = 0;

 private:
  template <class T>
  void start(Lines<T>* lines) const {
    convert(corner_, &lines->corner);
    const auto& c = lines->corner;
    for (size_t i = 0; i < c.size(); ++i) {
      lines->line.push_back(line_of(cross(c[i], c[(i + 1) % c.size()]), frame_));
    }
    lines->area = T(0);
    for (size_t i = 1; i + 1 < c.size(); ++i) {
      lines->pieces.push_back(determinant(c[0], c[i], c[i + 1]));
      lines->area = lines->area + lines->pieces.back();
    }
    widen(&lines->area, lines->pieces.size());
  }

  // Lines that are positive where a sample's ray hits the face's plane in front of the eye, and
  // where the hit lies inside the depth planes that cut.
  template <class T>
  void add_lines(Lines<T>* lines) const {
    const auto& c = lines->corner;
    const Corner<T>&p = c[0], &q = c[best + 1], &r = c[best + 2];
    const std::array<Vector<T>, 3> weight = {cross(q, r), cross(r, p), cross(p, q)};
    const auto add = [&](const T& u, const T& v, const T& t) {
      Vector<T> n;
      for (size_t i = 0; i < 3; ++i) {
        n[i] = T(best_way) * (u * weight[0][i] + v * weight[1][i] + t * weight[2][i]);
      }
      lines->line.push_back(line_of(n, frame_));
    };
    add(T(1), T(1), T(1));
    if (frame_.low_cuts) add(p.z, q.z, r.z);
    if (frame_.high_cuts) add(p.w - p.z, q.w - q.z, r.w - r.z);
  }

  const Lines<Integer>& exactly() const {
    if (!exact_) {
      exact_ = std::make_unique<Lines<Integer>>();
      start(exact_.get());
      add_lines(exact_.get());
    }
    return *exact_;
  }

  const std::vector<ClipCorner>& corner_;
  const MeshFrame& frame_;
  mutable std::unique_ptr<Lines<Integer>> exact_;
};

FaceJudge::FaceJudge(std::vector<ClipCorner> corners, const MeshFrame& frame)
    : corner_(std::move(corners)), frame_(frame) {
  if (corner_.size() < 3) throw std::out_of_range("exact: a face has three corners or more");
  for (const ClipCorner& c : corner_) {
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z) || !std::isfinite(c.w)) {
      throw std::out_of_range("exact: a corner must be finite");
    }
  }
  planes_ = std::make_unique<Planes>(corner_, frame_);
  facing_ = planes_->facing;
  culled_ =
      (frame.cull == Cull::kBack && facing_ <= 0) || (frame.cull == Cull::kFront && facing_ > 0);
  // At a sharp corner the bands of both edges reach far beyond it, so boxes limit them.
  box_ = box_of(corner_);
  if (is_empty(box_.columns)) box_.rows = {};
  for (size_t i = 0; i < corner_.size() && corner_.size() > 3; ++i) {
    edge_box_.push_back(box_of({corner_[i], corner_[(i + 1) % corner_.size()]}));
  }
}

FaceJudge::~FaceJudge() = default;

// The pixels whose samples lie in the bounding box of some corners, enlarged by the band.
FaceJudge::Box FaceJudge::box_of(const std::vector<ClipCorner>& corners) const {
  Box all{common({frame_.x0, frame_.x1 - 1}, {0, frame_.width - 1}),
          common({frame_.y0, frame_.y1 - 1}, {0, frame_.height - 1})};
  const bool is_behind =
      std::all_of(corners.begin(), corners.end(), [](const ClipCorner& c) { return c.w <= 0; });
  if (is_behind) return {};
  long double low_x = std::numeric_limits<long double>::infinity(), high_x = -low_x;
  long double low_y = low_x, high_y = high_x;
  for (const ClipCorner& c : corners) {
    if (!(c.w > 0)) return all;
    const long double x = (c.x / static_cast<long double>(c.w) + 1) * frame_.width / 2;
    const long double y = (1 - c.y / static_cast<long double>(c.w)) * frame_.height / 2;
    low_x = std::min(low_x, x), high_x = std::max(high_x, x);
    low_y = std::min(low_y, y), high_y = std::max(high_y, y);
  }
  constexpr long double kRoundings = 1e-6;  // px, far more than the rounding errors above
  const long double reach =
      std::ldexp(static_cast<long double>(frame_.band), -MeshFrame::kBandFractionBits) + kRoundings;
  const auto pixels = [&](long double low, long double high, int size) {
    const auto bounded = [&](long double v) {
      return static_cast<int>(std::clamp<long double>(v, -1, size + 1.L));
    };
    return Span{bounded(std::ceil(low - reach - .5L)), bounded(std::floor(high + reach - .5L))};
  };
  return {common(all.columns, pixels(low_x, high_x, frame_.width)),
          common(all.rows, pixels(low_y, high_y, frame_.height))};
}

// The columns of row y where way * line i + margin * band is positive (`strictly`) or not negative.
// Since the line is linear in x, they are all columns, none, or those on one side of its zero.
Span FaceJudge::where(size_t i, int way, int y, int margin, bool strictly) const {
  const int least = strictly ? 1 : 0;
  const auto holds = [&](int x) { return planes_->sign(i, way, x, y, margin) >= least; };
  const bool at_first = holds(box_.columns.first), at_last = holds(box_.columns.last);
  if (at_first == at_last) return at_first ? box_.columns : Span{};
  // Bisection, starting near the line's zero: columns up to `low` are like the first one, columns
  // from `high` on like the last one.
  int low = box_.columns.first, high = box_.columns.last;
  const Line<Approximate>& l = planes_->approximate.line[i];
  const long double zero =
      -(way * (l.b.value * y + l.c.value) + margin * l.band.value) / (way * l.a.value);
  for (int guess = zero > low && zero < high ? static_cast<int>(zero) : low; low + 1 < high;
       guess = low + (high - low) / 2) {
    for (const int x : {guess, guess + 1}) {
      if (x <= low || x >= high) continue;
      (holds(x) == at_first ? low : high) = x;
    }
  }
  return at_first ? Span{box_.columns.first, low} : Span{high, box_.columns.last};
}

void FaceJudge::row(int y, std::vector<int8_t>* hits) const {
  hits->assign(place_of(box_.columns.last) + 1, 0);
  if (corner_.size() == 3) {
    convex_row(y, hits);
  } else {
    polygon_row(y, hits);
  }
}

void FaceJudge::fill(Span columns, int8_t value, std::vector<int8_t>* hits) const {
  const Span s = common(columns, box_.columns);
  if (is_empty(s)) return;
  const auto from = hits->begin() - box_.columns.first;
  std::fill(from + s.first, from + s.last + 1, value);
}

// The columns of row y that lie in the band of line i.
Span FaceJudge::band(size_t i, int y) const {
  return common(where(i, 1, y, 1, false), where(i, -1, y, 1, false));
}

// A triangle covers the samples where all of its lines are positive.
void FaceJudge::convex_row(int y, std::vector<int8_t>* hits) const {
  constexpr size_t kEdges = 3;
  Span may = box_.columns, must = box_.columns;
  for (size_t i = 0; i < kEdges && facing_ == 0; ++i) may = common(may, band(i, y));
  for (size_t i = 0; i < planes_->approximate.line.size() && facing_ != 0; ++i) {
    if (i == kEdges) continue;  // a triangle's edges imply that the ray hits in front of the eye
    const int way = i < kEdges ? facing_ : 1;
    may = common(may, where(i, way, y, 1, false));
    must = common(must, where(i, way, y, -1, true));
    if (is_empty(may)) return;
  }
  fill(may, kEither, hits);
  if (facing_ != 0) fill(must, culled_ ? 0 : 1, hits);
}

// The winding number of the polygon around each sample of a row, seen in the face's plane: the sum
// of the directions of the edges that pass it on one side.
std::vector<int> FaceJudge::windings(int y) const {
  std::vector<int> steps(place_of(box_.columns.last) + 2);
  std::vector<bool> above(corner_.size());
  for (size_t i = 0; i < corner_.size(); ++i) above[i] = planes_->is_above(i, y);
  for (size_t i = 0; i < corner_.size(); ++i) {
    const bool goes_up = above[(i + 1) % corner_.size()];
    if (above[i] == goes_up) continue;
    const int way = goes_up ? 1 : -1;
    const Span beside = where(i, way, y, 0, true);
    if (is_empty(beside)) continue;
    steps[place_of(beside.first)] += way;
    steps[place_of(beside.last) + 1] -= way;
  }
  for (size_t i = 1; i < steps.size(); ++i) steps[i] += steps[i - 1];
  steps.pop_back();
  return steps;
}

void FaceJudge::polygon_row(int y, std::vector<int8_t>* hits) const {
  const auto winding = windings(y);
  std::transform(winding.begin(), winding.end(), hits->begin(), [&](int n) {
    return static_cast<int8_t>(culled_ ? 0 : std::min(std::abs(n), INT8_MAX));
  });
  for (size_t i = 0; i < corner_.size(); ++i) {
    const Box& box = edge_box_[i];
    if (y < box.rows.first || y > box.rows.last) continue;
    fill(common(box.columns, band(i, y)), kEither, hits);
  }
  if (planes_->best_way == 0) return;
  const size_t front = corner_.size();
  for (size_t i = front; i < planes_->approximate.line.size(); ++i) {
    const Span may = where(i, 1, y, i == front ? 0 : 1, i == front);
    const Span must = i == front ? may : where(i, 1, y, -1, true);
    for (int x = box_.columns.first; x <= box_.columns.last; ++x) {
      int8_t& hit = (*hits)[place_of(x)];
      const bool is_there = x >= may.first && x <= may.last;
      const bool is_sure = x >= must.first && x <= must.last;
      if (!is_there) hit = 0;
      if (is_there && !is_sure && winding[place_of(x)] != 0) {
        hit = kEither;
      }
    }
  }
}

}  // namespace exact
