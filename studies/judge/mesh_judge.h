// Judges the picture of a mesh: hits, depths and colours must follow from the file's corners in
// clip space, whatever triangles readers, clipping and snapping made of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/exact/mesh.h"
#include "model/judge/comparison.h"
#include "model/scene/mesh_reader.h"

namespace pineda::studies {

struct MeshJudgement {
  uint64_t faces = 0;    // judged
  uint64_t bent = 0;     // polygons so far from a plane that they were judged by their triangles
  uint64_t samples = 0;  // hits judged
  uint64_t banded = 0;   // of these, in the band of an edge, where a hit is allowed, not required
  uint64_t wrong = 0;    // samples of faces: too many hits, too few, a wrong value

  std::optional<judge::Difference> first;  // by face, then by row: "hits: 1, expected 0"

  bool holds() const { return wrong == 0; }
};

/// A fragment: one triangle drawn at one sample, visible or not.
struct MeshHit {
  int x = 0, y = 0;       // px
  uint32_t triangle = 0;  // its number
  uint32_t z = 0;         // depth code
  std::array<int32_t, 4> color{};
};

/// Judges the samples of a mesh face by face. A face is what the file states: a polygon that lies
/// in a plane is judged as a whole by its corners, any other one triangle by triangle. Triangles of
/// strips and fans are formed from the file's corners.
///
/// Bits     a corner may move by half a subpixel plus a binary32 rounding at the guard band; a
///          corner of a polygon that is not quite planar also by its distance to the plane, up to
///          kBentPx. This gives each edge a band (and each diagonal along which a polygon was cut,
///          where snapping may turn a triangle over). Outside of the bands the number of hits must
///          be right; inside, each triangle may hit once at most. A depth must lie within the
///          design's bound, plus the rounding of a corner's binary32, of those that the triangle
///          has within the band around the sample; a colour within the design's bound plus the
///          rounding of the corners' colours; a flat colour must be the provoking vertex's.
/// In       memory: 32 bytes a hit of the largest face.
/// Drops    depths under a depth bias with a slope; colours of a triangle in perspective where the
///          design interpolates affinely: not judged here.
class MeshJudge {
 public:
  static constexpr double kBentPx = .25;

  MeshJudge(const scene::ClipMesh& mesh, const spec::Contract& contract,
            const spec::FrameState& frame);

  /// Takes the hits in the order of triangle numbers.
  void hit(const MeshHit& hit);
  /// Judges the remaining faces, those without a hit, too.
  MeshJudgement finish();

 private:
  struct Face;
  struct Sample {
    int x, y;
  };

  Face face_at(uint32_t triangle);
  void take_polygon(Face* face);
  std::array<uint32_t, 3> corners_of(const Face& face, uint32_t triangle) const;
  const scene::ClipVertex& provoking(const Face& face, uint32_t triangle) const;
  void judge_until(uint32_t triangle);
  void judge(const Face& face);
  bool is_near_diagonal(const Face& face, Sample at) const;
  void judge_samples(const Face& face, Sample at, size_t begin, size_t end, int expected);
  std::string wrong_value(const Face& face, const MeshHit& hit) const;
  std::string wrong_color(const std::array<uint32_t, 3>& corner, const scene::ClipVertex& provoking,
                          const exact::FaceValues& values, const MeshHit& hit) const;
  void note(Sample at, uint32_t triangle, const std::string& what);

  const scene::ClipMesh& mesh_;
  spec::Contract contract_;
  spec::FrameState frame_;
  exact::MeshFrame exact_frame_;
  spec::ErrorBounds bounds_;
  uint32_t next_ = 0;          // the first triangle that is not judged yet
  size_t list_ = 0;            // the polygon, strip or fan of next_, or the one after it
  std::vector<MeshHit> hits_;  // of the face that is being drawn
  std::vector<int8_t> expected_;
  MeshJudgement judgement_;
};

}  // namespace pineda::studies
