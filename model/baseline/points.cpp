#include "model/baseline/common.h"
#include "model/baseline/makers.h"

namespace pineda::baseline {

namespace {

// As printed  primitives of less than a pixel need no triangle: each vertex is a point.
// Mended      nothing. No setup, so no facing (cull is not looked at) and no inside: the pixel that
//             a vertex lies in takes its values, whether the triangle covers its sample or not.
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
