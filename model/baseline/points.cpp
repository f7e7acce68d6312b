#include "model/baseline/common.h"
#include "model/baseline/makers.h"

namespace pineda::baseline {

namespace {

// As printed  primitives smaller than a pixel are not drawn as triangles: each vertex is a point.
// Mended      nothing. Without setup there is no culling and no coverage test: the pixel that
//             contains a vertex gets its values, even if the triangle does not cover the sample.
class Points final : public Common {
 public:
  using Common::Common;

  void draw(const spec::Triangle& t, Sink* sink) override {
    for (const spec::Vertex& v : t.v) {
      const int x = v.x >> subpixel_bits_;
      const int y = v.y >> subpixel_bits_;
      if (x < 0 || y < 0 || x >= frame_.width || y >= frame_.height) continue;
      ++visited_;
      emit(x, y, parameters(v), sink);
    }
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_points(const spec::Contract& c, const spec::FrameState& frame) {
  return std::make_unique<Points>(c, frame);
}

}  // namespace pineda::baseline
