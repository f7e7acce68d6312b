#include "studies/judge/frame_diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/judge/exact_terms.h"
#include "model/judge/visible_frame.h"
#include "model/spec/clear_depth.h"
#include "model/spec/widths.h"
#include "studies/judge/stated.h"

namespace pineda::studies {
namespace {

constexpr double kNearPx = 1;

/// Where a sample lies in a snapped triangle.
struct Place {
  std::array<double, 3> weight{};  // of the corners; their sum is 1
  bool is_on_edge = false;
  double distance_px = 0;  // from the border
};

/// In       not of zero area.
Place place_of(const exact::Triangle& t, int x, int y, int subpixel_bits) {
  const int64_t px = (2 * int64_t{x} + 1) << (subpixel_bits - 1);
  const int64_t py = (2 * int64_t{y} + 1) << (subpixel_bits - 1);
  std::array<int64_t, 3> e{};
  double inside = std::numeric_limits<double>::max();  // px, negative outside
  int64_t area = 0;
  for (size_t i = 0; i < 3; ++i) {
    const exact::Vertex &from = t[(i + 1) % 3], &to = t[(i + 2) % 3];
    e[i] = (to.x - from.x) * (py - from.y) - (to.y - from.y) * (px - from.x);
    area += e[i];
  }
  bool touches = true;
  Place place;
  for (size_t i = 0; i < 3; ++i) {
    const exact::Vertex &from = t[(i + 1) % 3], &to = t[(i + 2) % 3];
    const int64_t within = area > 0 ? e[i] : -e[i];
    touches &= within >= 0;
    place.is_on_edge |= within == 0;
    inside = std::min(inside,
                      static_cast<double>(within) / std::hypot(static_cast<double>(to.x - from.x),
                                                               static_cast<double>(to.y - from.y)));
    place.weight[i] = static_cast<double>(e[i]) / static_cast<double>(area);
  }
  place.is_on_edge &= touches;
  place.distance_px = std::fabs(inside) / static_cast<double>(int64_t{1} << subpixel_bits);
  return place;
}

exact::Value value_of(double value) {
  const double whole = std::floor(value);
  return {static_cast<int64_t>(whole), value - whole, static_cast<int64_t>(std::floor(value + .5))};
}

/// The values of a triangle's planes at a place, also outside of it.
Fragment extrapolated(const exact::ScreenTriangle& stated, const exact::Triangle& snapped,
                      const Place& place, bool flat) {
  Fragment fragment;
  double z = 0, sum = 0;
  std::array<double, 3> weight = place.weight;
  for (size_t i = 0; i < 3; ++i) {
    z += weight[i] * static_cast<double>(snapped[i].z);
    weight[i] /= double{stated[i].w};
    sum += weight[i];
  }
  fragment.z = value_of(std::max(0., std::ldexp(z, -spec::kDepthInputFractionBits)));
  for (size_t k = 0; k < 4; ++k) {
    double value = flat ? stated[0].rgba[k] : 0;
    for (size_t i = 0; i < 3 && !flat; ++i) value += weight[i] / sum * stated[i].rgba[k];
    fragment.color[k] = value_of(value);
  }
  return fragment;
}

double exact_of(const exact::Value& value) {
  return static_cast<double>(value.whole) + value.fraction;
}

std::string text_of(const std::array<uint8_t, 4>& rgba) {
  return fmt::format("{} {} {} {}", rgba[0], rgba[1], rgba[2], rgba[3]);
}

std::string color_text(const Fragment& fragment) {
  const auto& c = fragment.color;
  return fmt::format("{:.2f} {:.2f} {:.2f} {:.2f}", exact_of(c[0]), exact_of(c[1]), exact_of(c[2]),
                     exact_of(c[3]));
}

}  // namespace

FrameDiagnosis::FrameDiagnosis(const spec::FrameState& frame, const FrameTolerance& tolerance,
                               const FrameDump& dump, size_t sample, const scene::ClipMesh* mesh)
    : frame_(frame),
      exact_frame_(judge::exact_frame(frame)),
      tolerance_(tolerance),
      mesh_(mesh),
      x_(static_cast<int>(sample % static_cast<size_t>(frame.width))),
      y_(static_cast<int>(sample / static_cast<size_t>(frame.width))),
      is_in_scissor_(x_ >= frame.clip_x0() && x_ < frame.clip_x1() && y_ >= frame.clip_y0() &&
                     y_ < frame.clip_y1()) {
  if (dump.hits) hits_ = (*dump.hits)[sample];
  if (dump.depth) depth_ = (*dump.depth)[sample];
  if (dump.color) color_ = (*dump.color)[sample];
  exact_frame_.cull = exact::Cull::kNone;  // triangles that are culled are looked at too
  exact_frame_.x0 = exact_frame_.y0 = 0;
  exact_frame_.x1 = exact_frame_.y1 = INT32_MAX;
}

void FrameDiagnosis::triangle(const scene::ScreenTriangle& triangle) {
  const exact::ScreenTriangle floats = stated(triangle);
  const exact::ScreenJudge judge(floats, tolerance_.format, exact_frame_);
  if (judge.culled()) return;  // of zero area
  const exact::Judge& snapped = judge.snapped();
  const Place place = place_of(snapped.vertices(), x_, y_, tolerance_.format.subpixel_bits);
  Near near{triangle, SameDepth(snapped.vertices())};
  near.is_covering = snapped.covers(x_, y_);
  near.is_on_edge = place.is_on_edge;
  near.distance_px = place.distance_px;
  near.is_culled = (frame_.cull == spec::Cull::kBack && snapped.doubled_area() > 0) ||
                   (frame_.cull == spec::Cull::kFront && snapped.doubled_area() < 0);
  if (near.is_covering) {
    std::vector<exact::Sample> row;
    judge.row(y_, !judge.affine(), &row);
    near.fragment =
        fragment_of(row[static_cast<size_t>(x_ - judge.span(y_).first)], judge.affine());
  } else {
    near.fragment = extrapolated(floats, snapped.vertices(), place, exact_frame_.flat);
  }
  near.codes = codes_of(near.fragment.z, tolerance_);
  keep(near);
}

void FrameDiagnosis::keep(const Near& near) {
  const bool is_near = near.is_covering || near.is_on_edge || near.distance_px <= kNearPx;
  if (is_near && only_nearest_) near_.clear();
  if (is_near || near_.empty()) {
    only_nearest_ = !is_near;
    near_.push_back(near);
  } else if (only_nearest_ && near.distance_px < near_.front().distance_px) {
    near_.front() = near;
  }
}

bool FrameDiagnosis::is_drawn(const Near& near) const {
  return near.is_covering && !near.is_culled && is_in_scissor_;
}

bool FrameDiagnosis::is_shown(const Near& near) const {
  const bool writes = frame_.depth_write && frame_.depth != spec::DepthFunc::kOff;
  return (!depth_ || !writes || near.codes.holds(*depth_)) &&
         (!color_ || is_color(near.fragment, *color_, tolerance_.color_lsb));
}

bool FrameDiagnosis::is_cleared() const {
  const uint32_t code = spec::depth_code(frame_.clear_depth, tolerance_.format.depth_bits);
  return (!depth_ || *depth_ == code) && (!color_ || *color_ == std::array<uint8_t, 4>{});
}

// The triangle that is seen if all depths are rounded to the nearest code.
const FrameDiagnosis::Near* FrameDiagnosis::winner() const {
  int64_t stored = spec::depth_code(frame_.clear_depth, tolerance_.format.depth_bits);
  const Near* winner = nullptr;
  for (const Near& near : near_) {
    const int64_t z = near.fragment.z.nearest;
    const int order = z < stored ? -1 : z > stored ? 1 : 0;
    if (!is_drawn(near) || !judge::passes(frame_.depth, order)) continue;
    winner = &near;
    if (frame_.depth_write && frame_.depth != spec::DepthFunc::kOff) stored = z;
  }
  return winner;
}

Diagnosis FrameDiagnosis::told(Rule rule, const Near* blamed, const std::string& what) const {
  Diagnosis diagnosis{x_, y_, rule, std::nullopt, what, {}};
  if (blamed != nullptr) {
    diagnosis.triangle = blamed->stated.id;
    diagnosis.scene.push_back(blamed->stated);
  }
  return diagnosis;
}

Diagnosis FrameDiagnosis::result() const {
  const auto expected = std::count_if(near_.begin(), near_.end(),
                                      [this](const Near& near) { return is_drawn(near); });
  if (hits_ && *hits_ != std::min<int64_t>(expected, UINT16_MAX)) return of_hits(expected);
  return of_values();
}

Diagnosis FrameDiagnosis::of_hits(int64_t expected) const {
  const std::string what = fmt::format("hits are {}, expected {}", *hits_, expected);
  if (*hits_ > expected) return of_extra(what);
  const auto culled = std::count_if(near_.begin(), near_.end(), [](const Near& near) {
    return near.is_covering && near.is_culled;
  });
  if (frame_.cull != spec::Cull::kNone && *hits_ == culled) {
    const auto missing = std::find_if(near_.begin(), near_.end(),
                                      [this](const Near& near) { return is_drawn(near); });
    return told(Rule::kCull, &*missing, what + ": faces the other way than those culled");
  }
  return of_missing(what);
}

Diagnosis FrameDiagnosis::of_missing(const std::string& what) const {
  const Near* missing = nullptr;  // that whose border is nearest
  for (const Near& near : near_) {
    if (!is_drawn(near)) continue;
    if (missing == nullptr || near.distance_px < missing->distance_px) missing = &near;
  }
  if (missing->is_on_edge) {
    return told(Rule::kFillRule, missing, what + ": the sample lies on a top or left edge");
  }
  if (reaches_behind_near_plane(missing->stated.id)) {
    return told(Rule::kNearPlane, missing, what + ": in front of the near plane, which cuts it");
  }
  return told(Rule::kCoverage, missing,
              fmt::format("{}: {:.3f} px inside", what, missing->distance_px));
}

Diagnosis FrameDiagnosis::of_extra(const std::string& what) const {
  const auto first = [this](auto&& is_it) -> const Near* {
    const auto place = std::find_if(near_.begin(), near_.end(), is_it);
    return place == near_.end() ? nullptr : &*place;
  };
  if (!is_in_scissor_) {
    return told(Rule::kScissor, first([](const Near& near) { return near.is_covering; }),
                what + ": outside the scissor");
  }
  if (const Near* near =
          first([](const Near& n) { return n.is_on_edge && !n.is_covering && !n.is_culled; })) {
    return told(Rule::kFillRule, near, what + ": the sample lies on a bottom or right edge");
  }
  if (const auto behind = behind_near_plane()) {
    Diagnosis diagnosis = told(Rule::kNearPlane, nullptr, what + ": behind the near plane");
    diagnosis.triangle = behind;
    return diagnosis;
  }
  if (const Near* near = first([](const Near& n) { return n.is_covering && n.is_culled; })) {
    return told(Rule::kCull, near, what + ": to be culled");
  }
  const Near* nearest = nullptr;
  for (const Near& near : near_) {
    if (near.is_covering || near.is_culled) continue;
    if (nearest == nullptr || near.distance_px < nearest->distance_px) nearest = &near;
  }
  if (nearest == nullptr) {
    const Near* again = first([this](const Near& near) { return is_drawn(near); });
    return told(Rule::kCoverage, again, what + (again ? ": drawn again" : ": no triangle is near"));
  }
  return told(Rule::kCoverage, nearest,
              fmt::format("{}: {:.3f} px outside", what, nearest->distance_px));
}

// Hits are right or not known.
Diagnosis FrameDiagnosis::of_values() const {
  std::string got;
  if (depth_) got = fmt::format("depth is {}", *depth_);
  if (color_) got += fmt::format("{}colour is {}", depth_ ? ", " : "", text_of(*color_));
  const bool any_drawn =
      std::any_of(near_.begin(), near_.end(), [this](const Near& near) { return is_drawn(near); });
  const Near* const seen = winner();
  if (seen == nullptr && !any_drawn) {
    const bool is_of_a_triangle =
        behind_near_plane() || std::any_of(near_.begin(), near_.end(),
                                           [this](const Near& near) { return is_shown(near); });
    if (!hits_ && is_of_a_triangle) return of_extra(got + ", nothing is drawn there");
    return told(Rule::kClear, nullptr, got + ", nothing is drawn there");
  }
  if (seen == nullptr) {
    for (const Near& near : near_) {
      if (!is_drawn(near) || !is_shown(near)) continue;
      return told(Rule::kDepthFunc, &near, got + ", no triangle passes the depth test");
    }
    return told(Rule::kClear, nullptr, got + ", no triangle passes the depth test");
  }
  if (is_cleared()) {
    if (!hits_) return of_missing(got + ", as it was cleared");
    return told(Rule::kDepthFunc, seen, got + ", as it was cleared: it passes the depth test");
  }
  for (auto near = near_.rbegin(); near != near_.rend(); ++near) {
    if (&*near == seen || !is_shown(*near)) continue;
    if (is_drawn(*near)) return of_other_winner(*seen, *near);
    if (!hits_) return of_extra(got + ", which is a triangle that is not drawn there");
  }
  const bool writes = frame_.depth_write && frame_.depth != spec::DepthFunc::kOff;
  if (depth_ && writes && !seen->codes.holds(*depth_)) {
    return told(Rule::kDepthValue, seen,
                fmt::format("depth is {}, expected {:.3f} within {}", *depth_,
                            exact_of(seen->fragment.z), tolerance_.depth_ulp));
  }
  if (depth_ && !writes) {
    const uint32_t code = spec::depth_code(frame_.clear_depth, tolerance_.format.depth_bits);
    if (*depth_ != code) {
      return told(Rule::kClear, nullptr,
                  fmt::format("depth is {}, expected {}: it is not written", *depth_, code));
    }
  }
  return told(Rule::kColorValue, seen,
              fmt::format("colour is {}, expected {} within {}", text_of(*color_),
                          color_text(seen->fragment), tolerance_.color_lsb));
}

Diagnosis FrameDiagnosis::of_other_winner(const Near& winner, const Near& shown) const {
  const bool is_tie = winner.same_depth == shown.same_depth ||
                      exact_of(winner.fragment.z) == exact_of(shown.fragment.z);
  const Near& later = std::max(&winner, &shown) == &winner ? winner : shown;
  Diagnosis diagnosis = told(
      is_tie ? Rule::kDepthTie : Rule::kDepthFunc, &later,
      fmt::format("triangle {} is seen, expected {}: depths {:.3f} and {:.3f}", shown.stated.id,
                  winner.stated.id, exact_of(shown.fragment.z), exact_of(winner.fragment.z)));
  const Near& earlier = &later == &winner ? shown : winner;
  diagnosis.scene = {earlier.stated, later.stated};
  return diagnosis;
}

// A triangle of the mesh whose part behind the near plane the ray through the sample meets.
std::optional<uint32_t> FrameDiagnosis::behind_near_plane() const {
  if (mesh_ == nullptr || !mesh_->depth.low) return std::nullopt;
  const double ray_x = (2 * x_ + 1.) / frame_.width - 1;
  const double ray_y = 1 - (2 * y_ + 1.) / frame_.height;
  for (size_t n = 0; n < mesh_->triangle.size(); ++n) {
    if (!mesh_->drawable[n]) continue;
    std::array<double, 3> across{}, down{};
    std::array<const std::array<double, 4>*, 3> corner{};
    for (size_t i = 0; i < 3; ++i) {
      corner[i] = &mesh_->vertex[mesh_->triangle[n][i]].position;
      const auto& [x, y, z, w] = *corner[i];
      across[i] = x - ray_x * w;
      down[i] = y - ray_y * w;
    }
    double z = 0, w = 0;
    int positive = 0, negative = 0;
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double weight = across[j] * down[k] - across[k] * down[j];
      positive += weight > 0 ? 1 : 0;
      negative += weight < 0 ? 1 : 0;
      z += weight * (*corner[i])[2];
      w += weight * (*corner[i])[3];
    }
    if (positive != 0 && negative != 0) continue;
    if (negative != 0) {
      z = -z;
      w = -w;
    }
    if (z < 0 || w < 0) return static_cast<uint32_t>(n);
  }
  return std::nullopt;
}

bool FrameDiagnosis::reaches_behind_near_plane(uint32_t triangle) const {
  if (mesh_ == nullptr || !mesh_->depth.low || triangle >= mesh_->triangle.size()) return false;
  const auto& corners = mesh_->triangle[triangle];
  return std::any_of(corners.begin(), corners.end(),
                     [this](uint32_t corner) { return mesh_->vertex[corner].position[2] < 0; });
}

}  // namespace pineda::studies
