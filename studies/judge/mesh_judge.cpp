#include "studies/judge/mesh_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace pineda::studies {
namespace {

using Corners = std::array<uint32_t, 3>;
using List = scene::MeshPolygon;

// The corners of a triangle of a strip or a fan; the first one is the provoking vertex.
Corners listed(const std::vector<uint32_t>& corner, const List& list, uint32_t triangle) {
  const uint32_t i = triangle - list.first_triangle;
  const auto at = [&](uint32_t k) { return corner[list.first_corner + k]; };
  Corners c = list.kind == List::Kind::kFan ? Corners{at(i + 1), at(i + 2), at(0)}
              : i % 2 == 0                  ? Corners{at(i), at(i + 1), at(i + 2)}
                                            : Corners{at(i), at(i + 2), at(i + 1)};
  if (list.is_mirrored) std::swap(c[1], c[2]);
  return c;
}

exact::MeshFrame mesh_frame(const scene::ClipMesh& mesh, const spec::Design& design,
                            const spec::FrameState& frame) {
  const exact::Frame state = judge::exact_frame(frame);
  exact::MeshFrame result{frame.width, frame.height, state.cull,     state.x0,       state.y0,
                          state.x1,    state.y1,     mesh.depth.low, mesh.depth.high};
  // Half a subpixel, plus one unit of a binary32 at the guard band's border.
  constexpr int kUnits = exact::MeshFrame::kBandFractionBits;
  result.band = (1 << (kUnits - design.subpixel_bits - 1)) +
                (1 << std::max(0, kUnits + design.guard_bits - 24));
  return result;
}

exact::ClipCorner clip_corner(const scene::ClipVertex& v) {
  return {v.position[0], v.position[1], v.position[2], v.position[3]};
}

}  // namespace

struct MeshJudge::Face {
  uint32_t first = 0, end = 0;  // triangles
  bool drawable = true;
  const List* list = nullptr;  // the polygon, strip or fan that it comes from
  std::vector<exact::ClipCorner> corner;
  int moved = 0;         // how far corners moved into the polygon's plane, in units of a band
  bool is_bent = false;  // the first triangle of a polygon that is not planar

  uint64_t most_hits() const { return end - first; }
};

MeshJudge::MeshJudge(const scene::ClipMesh& mesh, const spec::Contract& contract,
                     const spec::FrameState& frame)
    : mesh_(mesh),
      contract_(contract),
      frame_(frame),
      exact_frame_(mesh_frame(mesh, contract.design, frame)),
      bounds_(spec::error_bounds(contract.design)) {}

void MeshJudge::hit(const MeshHit& hit) {
  if (hit.triangle < next_ || hit.triangle >= mesh_.triangle.size()) {
    throw std::out_of_range("studies: hits of a mesh come in the order of its triangles");
  }
  if (hits_.empty() || hits_.back().triangle != hit.triangle) judge_until(hit.triangle);
  hits_.push_back(hit);
}

MeshJudgement MeshJudge::finish() {
  judge_until(static_cast<uint32_t>(mesh_.triangle.size()));
  return judgement_;
}

// Judges all faces that end before `triangle`.
void MeshJudge::judge_until(uint32_t triangle) {
  while (next_ < triangle) {
    const Face face = face_at(next_);
    if (face.end > triangle) return;
    judge(face);
    next_ = face.end;
  }
}

// The face whose first triangle is `triangle`.
MeshJudge::Face MeshJudge::face_at(uint32_t triangle) {
  while (list_ < mesh_.polygon.size() &&
         mesh_.polygon[list_].first_triangle + mesh_.polygon[list_].triangles <= triangle) {
    ++list_;
  }
  Face face;
  face.first = triangle;
  face.end = triangle + 1;
  face.drawable = mesh_.drawable[triangle];
  const bool is_listed =
      list_ < mesh_.polygon.size() && mesh_.polygon[list_].first_triangle <= triangle;
  if (is_listed) face.list = &mesh_.polygon[list_];
  for (const uint32_t i : corners_of(face, triangle)) {
    face.corner.push_back(clip_corner(mesh_.vertex[i]));
  }
  const bool is_polygon = is_listed && face.list->kind == List::Kind::kPolygon;
  if (is_polygon && triangle == face.list->first_triangle) take_polygon(&face);
  return face;
}

// Extends the face to the whole polygon that begins with this triangle, if all of the polygon is
// drawable and near enough to a plane.
void MeshJudge::take_polygon(Face* face) {
  const uint32_t end = face->first + face->list->triangles;

  for (uint32_t i = face->first; i < end; ++i) {
    if (!mesh_.drawable[i]) return;
  }
  std::vector<exact::ClipCorner> corners;
  for (uint32_t i = 0; i < face->list->corners; ++i) {
    corners.push_back(clip_corner(mesh_.vertex[mesh_.corner[face->list->first_corner + i]]));
  }
  exact::FlatPolygon flat = exact::flattened(corners, exact_frame_);
  face->is_bent = flat.moved_px > kBentPx;
  if (face->is_bent) return;
  face->end = end;
  face->corner = std::move(flat.corner);
  face->moved =
      static_cast<int>(std::ceil(std::ldexp(flat.moved_px, exact::MeshFrame::kBandFractionBits)));
}

// The corners of a triangle of the face; in strips and fans the first one is the provoking vertex.
Corners MeshJudge::corners_of(const Face& face, uint32_t triangle) const {
  const bool is_listed = face.list != nullptr && face.list->kind != List::Kind::kPolygon;
  return is_listed ? listed(mesh_.corner, *face.list, triangle) : mesh_.triangle[triangle];
}

void MeshJudge::judge(const Face& face) {
  ++judgement_.faces;
  judgement_.bent += face.is_bent ? 1 : 0;
  judgement_.samples += hits_.size();
  std::sort(hits_.begin(), hits_.end(), [](const MeshHit& a, const MeshHit& b) {
    return std::tie(a.y, a.x, a.triangle) < std::tie(b.y, b.x, b.triangle);
  });
  size_t next = 0;
  const auto samples_at = [&](int y, int x, int expected) {
    const size_t begin = next;
    while (next < hits_.size() && hits_[next].y == y && hits_[next].x == x) ++next;
    if (begin != next || expected > 0) judge_samples(face, {x, y}, begin, next, expected);
  };
  // Judges the hits before (y, x) in reading order, where none is expected.
  const auto none_before = [&](int y, int x) {
    while (next < hits_.size() && std::tie(hits_[next].y, hits_[next].x) < std::tie(y, x)) {
      samples_at(hits_[next].y, hits_[next].x, 0);
    }
  };
  if (face.drawable) {
    exact::MeshFrame frame = exact_frame_;
    frame.band += face.moved;
    const exact::FaceJudge judge(face.corner, frame);
    for (int y = judge.rows().first; y <= judge.rows().last; ++y) {
      judge.row(y, &expected_);
      for (size_t i = 0; i < expected_.size(); ++i) {
        const int x = judge.columns().first + static_cast<int>(i);
        if (expected_[i] == 0) continue;
        none_before(y, x);
        samples_at(y, x, expected_[i]);
      }
    }
  }
  none_before(std::numeric_limits<int>::max(), 0);
  hits_.clear();
}

void MeshJudge::judge_samples(const Face& face, Sample at, size_t begin, size_t end, int expected) {
  const uint64_t count = end - begin;
  const bool is_right = count == static_cast<uint64_t>(std::max(expected, 0));
  const bool is_banded = expected == exact::FaceJudge::kEither ||
                         (!is_right && face.most_hits() > 1 && is_near_diagonal(face, at));
  judgement_.banded += is_banded ? count : 0;
  if (is_banded ? count > face.most_hits() : !is_right) {
    const auto triangle = count > 0 ? hits_[begin].triangle : face.first;
    const std::string wanted =
        is_banded ? fmt::format("at most {}", face.most_hits()) : fmt::format("{}", expected);
    return note(at, triangle, fmt::format("hits: {}, expected {}", count, wanted));
  }
  for (size_t i = begin; i < end; ++i) {
    const std::string wrong = wrong_value(face, hits_[i]);
    if (!wrong.empty()) return note(at, hits_[i].triangle, wrong);
  }
}

// Is the sample in the band of an edge of one of the triangles that the polygon was cut into?
bool MeshJudge::is_near_diagonal(const Face& face, Sample at) const {
  exact::MeshFrame frame = exact_frame_;
  frame.band += face.moved;
  std::vector<int8_t> row;
  for (uint32_t i = face.first; i < face.end; ++i) {
    const Corners corner = corners_of(face, i);
    const exact::FaceJudge judge(
        {clip_corner(mesh_.vertex[corner[0]]), clip_corner(mesh_.vertex[corner[1]]),
         clip_corner(mesh_.vertex[corner[2]])},
        frame);
    const bool is_in_box = at.y >= judge.rows().first && at.y <= judge.rows().last &&
                           at.x >= judge.columns().first && at.x <= judge.columns().last;
    if (!is_in_box) continue;
    judge.row(at.y, &row);
    if (row[static_cast<size_t>(at.x - judge.columns().first)] == exact::FaceJudge::kEither) {
      return true;
    }
  }
  return false;
}

void MeshJudge::note(Sample at, uint32_t triangle, const std::string& what) {
  if (judgement_.wrong++ == 0) judgement_.first = {at.x, at.y, triangle, what};
}

// What is wrong with a hit's depth or colour; empty if nothing is.
std::string MeshJudge::wrong_value(const Face& face, const MeshHit& hit) const {
  const spec::Design& d = contract_.design;
  const bool is_listed = face.list != nullptr && face.list->kind != List::Kind::kPolygon;
  const Corners corner =
      is_listed ? listed(mesh_.corner, *face.list, hit.triangle) : mesh_.triangle[hit.triangle];
  const exact::FaceValues values(
      {clip_corner(mesh_.vertex[corner[0]]), clip_corner(mesh_.vertex[corner[1]]),
       clip_corner(mesh_.vertex[corner[2]])},
      exact_frame_);
  if (d.depth_test && frame_.bias_slope == 0) {
    const double greatest = std::ldexp(1., d.depth_bits) - 1;
    const auto code = [&](double z) {
      const double biased =
          std::clamp(z, 0., 1.) * greatest + static_cast<double>(frame_.bias_constant);
      return std::clamp(biased, 0., greatest);
    };
    const exact::Range range = values.depth(hit.x, hit.y);
    // A corner's depth is a binary32 number: below 1 its rounding is at most 2^-25.
    const double bound = bounds_.depth_ulp + std::ldexp(greatest, -25);
    const double low = code(range.low) - bound, high = code(range.high) + bound;
    if (!(hit.z >= low && hit.z <= high)) {
      return fmt::format("depth: {}, expected {:.1f} to {:.1f}", hit.z, low, high);
    }
  }
  return wrong_color(corner, provoking(face, hit.triangle), values, hit);
}

// A polygon's flat colour is that of its first corner.
const scene::ClipVertex& MeshJudge::provoking(const Face& face, uint32_t triangle) const {
  if (face.list == nullptr) return mesh_.provoking_vertex(triangle);
  if (face.list->kind == List::Kind::kPolygon) {
    return mesh_.vertex[mesh_.corner[face.list->first_corner]];
  }
  return mesh_.vertex[corners_of(face, triangle)[0]];
}

std::string MeshJudge::wrong_color(const Corners& corner, const scene::ClipVertex& provoking,
                                   const exact::FaceValues& values, const MeshHit& hit) const {
  const spec::Design& d = contract_.design;
  const double scale = ((1 << d.attribute_bits) - 1) / 255.;
  const auto smooth =
      frame_.shade == spec::Shade::kFlat ? size_t{0} : static_cast<size_t>(d.attributes);
  const auto w = [&](size_t i) { return mesh_.vertex[corner[i]].position[3]; };
  const bool is_judged = d.perspective || (w(0) == w(1) && w(1) == w(2));
  const auto channels = std::min<size_t>(static_cast<size_t>(spec::channels(d)), 4);
  for (size_t k = 0; k < channels; ++k) {
    exact::Range range;
    double bound = 0;
    if (k >= smooth) {
      const auto flat = static_cast<double>(std::lround(std::round(provoking.rgba[k]) * scale));
      range = {flat, flat};
    } else if (is_judged) {
      range = values.attribute(hit.x, hit.y,
                               {mesh_.vertex[corner[0]].rgba[k], mesh_.vertex[corner[1]].rgba[k],
                                mesh_.vertex[corner[2]].rgba[k]});
      // The corners' colours are rounded to 8 bits, and then to the design's.
      bound = bounds_.attribute_lsb + .5 * scale + .5;
      range = {range.low * scale, range.high * scale};
    } else {
      continue;
    }
    if (!(hit.color[k] >= range.low - bound && hit.color[k] <= range.high + bound)) {
      return fmt::format("colour {}: {}, expected {:.1f} to {:.1f}", k, hit.color[k],
                         range.low - bound, range.high + bound);
    }
  }
  return {};
}

}  // namespace pineda::studies
