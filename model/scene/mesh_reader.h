// A mesh as a stream of screen triangles: shade, transform, clip, divide, viewport.
#pragma once

#include <vector>

#include "model/scene/camera.h"
#include "model/scene/clip.h"
#include "model/scene/screen.h"

namespace pineda::scene {

/// Bits     in doubles, then one rounding to the binary32 of a ScreenVertex: the same triangles
///          saved as .ptrb give the same picture. Colours are cut with the triangle and rounded to
///          the nearest at the end.
/// Out      the pieces of a cut triangle as a fan, all with its number; w = clip-space w.
/// Drops    triangles with a NaN or an Inf, and those of which clipping leaves nothing: counted.
class MeshReader final : public ScreenReader {
 public:
  MeshReader(const Mesh& mesh, const View& view, int width, int height, int guard_bits);

  bool read(ScreenTriangle* triangle, Counters* counters) override;
  void rewind() override;
  std::optional<uint64_t> size() const override { return triangles_.size(); }
  uint64_t skip(uint64_t triangles) override;

 private:
  bool next_polygon(Counters* counters);
  ScreenVertex project(const ClipVertex& vertex) const;  // all but w
  static void set_w(const std::array<const ClipVertex*, 3>& corners,
                    std::array<ScreenVertex, 3>* vertices);

  int width_, height_;
  ClipVolume volume_;
  std::vector<ClipVertex> vertices_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<bool> drawable_;
  size_t next_ = 0;  // the triangle that next_polygon() takes
  Polygon polygon_;  // what is left of the one before
  size_t piece_ = 0;
};

}  // namespace pineda::scene
