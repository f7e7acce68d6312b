#include "model/scene/mesh_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pineda::scene {
namespace {

constexpr std::array<double, 4> kClay = {232, 190, 140, 255};  // a mesh without colours
constexpr double kAmbient = .2;

// Diffuse light from the upper left behind the eye, so that a form shows from wherever it is seen.
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

}  // namespace

MeshReader::MeshReader(const Mesh& mesh, const View& view, int width, int height, int guard_bits)
    : width_(width),
      height_(height),
      volume_(width, height, guard_bits),
      vertices_(mesh.position.size()),
      triangles_(mesh.triangle) {
  for (size_t i = 0; i < vertices_.size(); ++i) {
    vertices_[i].position = view.clip(mesh.position[i]);
    vertices_[i].rgba = shaded(mesh, i, view);
  }
  drawable_.reserve(triangles_.size());
  for (const auto& t : triangles_) drawable_.push_back(mesh.is_finite(t));
}

void MeshReader::rewind() {
  next_ = 0;
  polygon_.size = 0;
}

// The next triangle of which something is left.
bool MeshReader::next_polygon(Counters* counters) {
  while (next_ < triangles_.size()) {
    const size_t current = next_++;
    ++counters->triangles;
    if (!drawable_[current]) {
      ++counters->nan_dropped;
      continue;
    }
    std::array<ClipVertex, 3> corner;
    unsigned outside = 0;
    for (size_t i = 0; i < 3; ++i) {
      corner[i] = vertices_[triangles_[current][i]];
      outside |= volume_.outside(corner[i]);
    }
    polygon_.size = 3;
    std::copy(corner.begin(), corner.end(), polygon_.v.begin());
    if (outside != 0) polygon_ = volume_.clip(corner);
    if (polygon_.size < 3) {
      ++counters->clipped_away;
      continue;
    }
    counters->clipped += outside != 0 ? 1 : 0;
    piece_ = 0;
    return true;
  }
  polygon_.size = 0;
  return false;
}

ScreenVertex MeshReader::project(const ClipVertex& vertex) const {
  const auto& p = vertex.position;
  ScreenVertex v;
  v.x = static_cast<float>((p[0] / p[3] + 1) * (width_ / 2.0));
  v.y = static_cast<float>((1 - p[1] / p[3]) * (height_ / 2.0));
  v.z = static_cast<float>(std::max(0., p[2] / p[3]));  // a cut may end a rounding before near
  for (size_t i = 0; i < 4; ++i) v.rgba[i] = static_cast<uint8_t>(std::lround(vertex.rgba[i]));
  return v;
}

void MeshReader::set_w(const std::array<const ClipVertex*, 3>& corners,
                       std::array<ScreenVertex, 3>* vertices) {
  const auto w = [&](size_t i) { return corners[i]->position[3]; };
  const double greatest = std::max({w(0), w(1), w(2)});
  const double least = std::min({w(0), w(1), w(2)});
  constexpr double kLow = std::numeric_limits<float>::min();
  constexpr double kHigh = std::numeric_limits<float>::max();
  // Only the ratios of the w's matter, so a power of two brings them into the range of floats. One
  // that stays below it is 2^126 times nearer than another: the nearest float is as good.
  int exponent = 0;
  if (least < kLow || greatest > kHigh) std::frexp(greatest, &exponent);
  for (size_t i = 0; i < 3; ++i) {
    (*vertices)[i].w = static_cast<float>(std::max(kLow, std::ldexp(w(i), -exponent)));
  }
}

uint64_t MeshReader::skip(uint64_t triangles) {
  polygon_.size = 0;
  const uint64_t skipped = std::min<uint64_t>(triangles, triangles_.size() - next_);
  next_ += skipped;
  return skipped;
}

bool MeshReader::read(ScreenTriangle* triangle, Counters* counters) {
  const bool has_piece = polygon_.size != 0 && piece_ + 2 < polygon_.size;
  if (!has_piece && !next_polygon(counters)) return false;
  ++piece_;
  triangle->id = static_cast<uint32_t>(next_ - 1);
  const std::array<const ClipVertex*, 3> corners{&polygon_.v[0], &polygon_.v[piece_],
                                                 &polygon_.v[piece_ + 1]};
  for (size_t i = 0; i < 3; ++i) triangle->v[i] = project(*corners[i]);
  set_w(corners, &triangle->v);
  return true;
}

}  // namespace pineda::scene
