#include <algorithm>

#include "model/baseline/common.h"
#include "model/baseline/makers.h"

namespace pineda::baseline {

using spec::Triangle;

namespace {

// Warnock's recursive subdivision of the frame. visited() counts each square tested, and each pixel
// of an accepted square.
//
// As printed  only the idea: a square is rejected, accepted, or split into quarters.
// Mended      nothing, since no algorithm was given. Here a square is a set of samples, so the
//             recursion ends at one sample; edges and box together reject every square that the
//             triangle does not touch; the top-left bias decides ties.
class Subdivision final : public Common {
 public:
  using Common::Common;

  void draw(const Triangle& t, Sink* sink) override {
    Scene scene{edges(t), {}, box(t), parameters(t), sink};
    if (dropped(scene.exact)) return;
    scene.biased = scene.exact.edge;
    for (Edge& e : scene.biased) e.c -= e.top_left ? 0 : 1;
    int size = 1;
    while (size < std::max(frame_.width, frame_.height)) size *= 2;
    visit(scene, 0, 0, size);
  }

 private:
  struct Scene {
    Edges exact;
    std::array<Edge, 3> biased;  // inside means at() >= 0
    Box pixels;
    std::array<Parameters, 3> value;
    Sink* sink;
  };

  void visit(const Scene& scene, int x, int y, int size) {
    if (x >= frame_.width || y >= frame_.height) return;
    ++visited_;
    // The edges alone do not reject squares beyond the tips of a narrow triangle.
    const Box& pixels = scene.pixels;
    if (x > pixels.x1 || y > pixels.y1 || x + size <= pixels.x0 || y + size <= pixels.y0) return;
    bool accepted = true;
    for (const Edge& e : scene.biased) {
      const int64_t first = e.at(x, y);
      const int64_t across = e.a * (size - 1);
      const int64_t down = e.b * (size - 1);
      if (first + std::max<int64_t>(across, 0) + std::max<int64_t>(down, 0) < 0) return;
      accepted &= first + std::min<int64_t>(across, 0) + std::min<int64_t>(down, 0) >= 0;
    }
    if (accepted) {
      accept(scene, x, y, size);
      return;
    }
    const int half = size / 2;  // size > 1: a single sample was rejected or accepted above
    visit(scene, x, y, half);
    visit(scene, x + half, y, half);
    visit(scene, x, y + half, half);
    visit(scene, x + half, y + half, half);
  }

  void accept(const Scene& scene, int x0, int y0, int size) {
    const int x1 = std::min(x0 + size, frame_.width);
    const int y1 = std::min(y0 + size, frame_.height);
    if (size > 1) visited_ += static_cast<uint64_t>(x1 - x0) * static_cast<uint64_t>(y1 - y0);
    const double scale = 1 / static_cast<double>(scene.exact.area2);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const auto [w0, w1, w2] = weights(scene.exact, x, y);
        const std::array<double, 3> share{static_cast<double>(w0) * scale,
                                          static_cast<double>(w1) * scale,
                                          static_cast<double>(w2) * scale};
        emit(x, y, mean(scene.value, share), scene.sink);
      }
    }
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_subdivision(const spec::Contract& c,
                                             const spec::FrameState& frame) {
  return std::make_unique<Subdivision>(c, frame);
}

}  // namespace pineda::baseline
