// A mesh as a stream of screen triangles: shade, transform, clip, divide, viewport.
#pragma once

#include <memory>
#include <vector>

#include "model/scene/camera.h"
#include "model/scene/clip.h"
#include "model/scene/partition.h"
#include "model/scene/screen.h"

namespace pineda::scene {

/// A mesh in the clip space of a view, shaded, before clipping.
struct ClipMesh {
  std::vector<ClipVertex> vertex;
  std::vector<std::array<uint32_t, 3>> triangle;
  std::vector<bool> drawable;       // for each triangle: its coordinates are finite, below 1e300
  std::vector<uint32_t> provoking;  // this and the next two as in Mesh
  std::vector<MeshPolygon> polygon;
  std::vector<uint32_t> corner;
  DepthPlanes depth;

  const ClipVertex& provoking_vertex(size_t i) const {
    return vertex[provoking.empty() ? triangle[i][0] : provoking[i]];
  }
};

ClipMesh clip_mesh(Mesh mesh, const View& view);

/// Bits     in doubles, then rounded once to the binary32 of a ScreenVertex, so that the triangles
///          saved as .ptrb give the same picture. Colours are interpolated at cuts and rounded to
///          the nearest at the end. Flat channels (all with flat shading, else those that the
///          design does not interpolate) have the provoking vertex's value at all vertices.
/// Out      a clipped triangle comes in pieces that share its number and, snapped for the design,
///          its orientation: see partition(). w = clip-space w.
/// Drops    triangles with a NaN or an Inf, and those that clipping removes entirely: counted.
class MeshReader final : public ScreenReader {
 public:
  MeshReader(std::shared_ptr<const ClipMesh> mesh, const spec::FrameState& frame,
             const spec::Contract& contract);

  bool read(ScreenTriangle* triangle, Counters* counters) override;
  void rewind() override;
  std::optional<uint64_t> size() const override { return mesh_->triangle.size(); }
  uint64_t skip(uint64_t triangles) override;

 private:
  bool next_polygon(Counters* counters);
  void snap_and_partition(bool counter_clockwise);
  void note_affine_error(double lsb, Counters* counters);
  ScreenVertex project(const ClipVertex& vertex) const;  // all but w
  static void set_w(const std::array<const ClipVertex*, 3>& corners,
                    std::array<ScreenVertex, 3>* vertices);

  std::shared_ptr<const ClipMesh> mesh_;
  int width_, height_;
  spec::Contract contract_;
  size_t smooth_;     // number of interpolated channels; those after them are flat
  float low_, high_;  // px, the least and greatest position in the guard band
  ClipVolume volume_;
  size_t next_ = 0;   // the next triangle that next_polygon() reads
  size_t noted_ = 0;  // next_ when a triangle was last counted in affine_colors
  Polygon polygon_;   // triangle next_ - 1 after clipping, and its pieces
  std::vector<Piece> pieces_;
  size_t piece_ = 0;
};

}  // namespace pineda::scene
