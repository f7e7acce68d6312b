#include "model/scene/mesh_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/scene/snap.h"

namespace pineda::scene {
namespace {

constexpr std::array<double, 4> kClay = {232, 190, 140, 255};  // colour of a mesh that has none
constexpr double kAmbient = .2;

// Diffuse light from behind the eye, from the upper left: it moves with the camera, so that shapes
// are visible from every side.
double light(const Vec3& normal, const View& view) {
  const Vec3 lamp = normalized(-.45 * view.right + .55 * view.up + .7 * view.back);
  return kAmbient + (1 - kAmbient) * std::max(0.0, dot(normal, lamp));
}

std::array<double, 4> shaded(const Mesh& mesh, size_t i, const View& view) {
  std::array<double, 4> rgba = kClay;
  if (!mesh.color.empty()) std::copy(mesh.color[i].begin(), mesh.color[i].end(), rgba.begin());
  if (!mesh.color.empty() && !mesh.is_lit) return rgba;
  const double intensity = light(mesh.normal[i], view);
  for (size_t k = 0; k < 3; ++k) rgba[k] *= intensity;
  return rgba;
}

uint8_t to_byte(double channel) { return static_cast<uint8_t>(std::lround(channel)); }

// The greatest binary32 number <= limit, for a limit > 0.
float floor_float(double limit) {
  const auto nearest = static_cast<float>(limit);
  return static_cast<double>(nearest) <= limit ? nearest : std::nextafter(nearest, 0.f);
}

// Is the part of the triangle in front of the eye counter-clockwise on the screen?
bool is_counter_clockwise(const std::array<ClipVertex, 3>& corner) {
  const auto point = [&](size_t i) {
    const auto& p = corner[i].position;
    return Vec3{p[0], p[1], p[3]};
  };
  return dot(point(0), cross(point(1), point(2))) > 0;
}

// Coordinates so far from overflow that the distances from the clip planes are finite too.
bool can_be_cut(const std::array<double, 4>& position) {
  return std::all_of(position.begin(), position.end(),
                     [](double value) { return std::abs(value) < 1e300; });
}

// The greatest difference between affine and perspective-correct colours in a triangle: for w's of
// a ratio of at most r it is (sqrt(r) - 1) / (sqrt(r) + 1) of the range of the corners' colours.
double affine_error(const std::array<const ClipVertex*, 3>& corner, size_t channels) {
  const auto [near, far] =
      std::minmax({corner[0]->position[3], corner[1]->position[3], corner[2]->position[3]});
  if (near == far) return 0;
  double range = 0;
  for (size_t k = 0; k < channels; ++k) {
    const auto [least, greatest] =
        std::minmax({corner[0]->rgba[k], corner[1]->rgba[k], corner[2]->rgba[k]});
    range = std::max(range, greatest - least);
  }
  const double root = std::sqrt(far / near);
  return range * (root - 1) / (root + 1);
}

}  // namespace

ClipMesh clip_mesh(Mesh mesh, const View& view) {
  ClipMesh seen;
  seen.vertex.resize(mesh.position.size());
  for (size_t i = 0; i < seen.vertex.size(); ++i) {
    seen.vertex[i].position = view.clip(mesh.position[i]);
    seen.vertex[i].rgba = shaded(mesh, i, view);
  }
  seen.drawable.reserve(mesh.triangle.size());
  for (const auto& t : mesh.triangle) {
    seen.drawable.push_back(std::all_of(
        t.begin(), t.end(), [&](uint32_t i) { return can_be_cut(seen.vertex[i].position); }));
  }
  seen.triangle = std::move(mesh.triangle);
  seen.provoking = std::move(mesh.provoking);
  seen.polygon = std::move(mesh.polygon);
  seen.corner = std::move(mesh.corner);
  seen.depth =
      view.is_reversed ? DepthPlanes{view.far_cuts, true} : DepthPlanes{true, view.far_cuts};
  return seen;
}

MeshReader::MeshReader(std::shared_ptr<const ClipMesh> mesh, const spec::FrameState& frame,
                       const spec::Contract& contract)
    : mesh_(std::move(mesh)),
      width_(frame.width),
      height_(frame.height),
      contract_(contract),
      smooth_(frame.shade == spec::Shade::kFlat
                  ? 0
                  : std::min<size_t>(static_cast<size_t>(contract.design.attributes), 4)),
      low_(static_cast<float>(-(1 << contract.design.guard_bits))),
      high_(floor_float((1 << contract.design.guard_bits) -
                        1. / (1 << contract.design.subpixel_bits))),
      volume_(frame.width, frame.height, contract.design, mesh_->depth) {}

void MeshReader::rewind() {
  next_ = 0;
  noted_ = 0;
  pieces_.clear();
  piece_ = 0;
}

// Reads and clips triangles until something is left of one. False at the end.
bool MeshReader::next_polygon(Counters* counters) {
  piece_ = 0;
  while (next_ < mesh_->triangle.size()) {
    const size_t current = next_++;
    ++counters->triangles;
    if (!mesh_->drawable[current]) {
      ++counters->nan_dropped;
      continue;
    }
    std::array<ClipVertex, 3> corner;
    unsigned outside = 0;
    for (size_t i = 0; i < 3; ++i) {
      corner[i] = mesh_->vertex[mesh_->triangle[current][i]];
      outside |= volume_.outside(corner[i]);
    }
    if (outside == 0) {
      std::copy(corner.begin(), corner.end(), polygon_.v.begin());
      pieces_.assign(1, {0, 1, 2});
      return true;
    }
    polygon_ = volume_.clip(corner);
    if (polygon_.size < 3) {
      ++counters->clipped_away;
      continue;
    }
    ++counters->clipped;
    snap_and_partition(is_counter_clockwise(corner));
    return true;
  }
  pieces_.clear();
  return false;
}

// Cuts the clipped polygon into pieces.
void MeshReader::snap_and_partition(bool counter_clockwise) {
  Counters none;  // not counted here, but when the pieces are snapped
  std::vector<GridPoint> points;
  for (size_t i = 0; i < polygon_.size; ++i) {
    const ScreenVertex v = project(polygon_.v[i]);
    if (std::isnan(v.x) || std::isnan(v.y)) {  // one piece, which snapping will drop
      pieces_.assign(1, {static_cast<uint8_t>(i), 0, 1});
      return;
    }
    points.push_back(
        {snap_coordinate(contract_, v.x, &none), snap_coordinate(contract_, v.y, &none)});
  }
  partition(points, !counter_clockwise, &pieces_);
}

ScreenVertex MeshReader::project(const ClipVertex& vertex) const {
  const auto& p = vertex.position;
  ScreenVertex v;
  v.x = static_cast<float>((p[0] / p[3] + 1) * (width_ / 2.0));
  v.y = static_cast<float>((1 - p[1] / p[3]) * (height_ / 2.0));
  v.z = static_cast<float>(p[2] / p[3]);
  // A cut may lie beyond its clip plane by a rounding error.
  v.x = std::clamp(v.x, low_, high_);
  v.y = std::clamp(v.y, low_, high_);
  v.z = std::clamp(v.z, 0.f, 1.f);
  for (size_t i = 0; i < 4; ++i) v.rgba[i] = to_byte(vertex.rgba[i]);
  return v;
}

void MeshReader::set_w(const std::array<const ClipVertex*, 3>& corners,
                       std::array<ScreenVertex, 3>* vertices) {
  const auto w = [&](size_t i) { return corners[i]->position[3]; };
  const double greatest = std::max({w(0), w(1), w(2)});
  const double least = std::min({w(0), w(1), w(2)});
  constexpr double kLow = std::numeric_limits<float>::min();
  constexpr double kHigh = std::numeric_limits<float>::max();
  // Only the ratios of the w's matter, so all are scaled by a power of two into the range of
  // floats. A w that is still too small is 2^126 times smaller than another, so the smallest normal
  // float is as good.
  int exponent = 0;
  if (least < kLow || greatest > kHigh) std::frexp(greatest, &exponent);
  for (size_t i = 0; i < 3; ++i) {
    (*vertices)[i].w = static_cast<float>(std::max(kLow, std::ldexp(w(i), -exponent)));
  }
}

void MeshReader::note_affine_error(double lsb, Counters* counters) {
  if (lsb < 1) return;
  counters->affine_lsb = std::max(counters->affine_lsb, lsb);
  // Count a triangle once, not each of its pieces.
  if (std::exchange(noted_, next_) != next_) ++counters->affine_colors;
}

uint64_t MeshReader::skip(uint64_t triangles) {
  pieces_.clear();
  piece_ = 0;
  const uint64_t skipped = std::min<uint64_t>(triangles, mesh_->triangle.size() - next_);
  next_ += skipped;
  return skipped;
}

bool MeshReader::read(ScreenTriangle* triangle, Counters* counters) {
  if (piece_ == pieces_.size() && !next_polygon(counters)) return false;
  const Piece& piece = pieces_[piece_++];
  triangle->id = static_cast<uint32_t>(next_ - 1);
  const std::array<const ClipVertex*, 3> corners{&polygon_.v[piece[0]], &polygon_.v[piece[1]],
                                                 &polygon_.v[piece[2]]};
  for (size_t i = 0; i < 3; ++i) triangle->v[i] = project(*corners[i]);
  set_w(corners, &triangle->v);
  note_affine_error(affine_error(corners, smooth_), counters);
  if (smooth_ < 4) {
    const ClipVertex& provoking = mesh_->provoking_vertex(next_ - 1);
    for (ScreenVertex& v : triangle->v) {
      for (size_t k = smooth_; k < 4; ++k) v.rgba[k] = to_byte(provoking.rgba[k]);
    }
  }
  return true;
}

}  // namespace pineda::scene
