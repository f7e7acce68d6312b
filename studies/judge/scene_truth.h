// Visits a scene's triangles one by one, each with its exact judge, in bounded memory.
#pragma once

#include <memory>

#include "model/judge/truth.h"
#include "model/scene/resnap.h"
#include "model/scene/scene.h"
#include "studies/judge/stated.h"

namespace pineda::studies {

/// Reads the scene from its start and calls visit(spec::Triangle, exact::ScreenJudge) for each
/// triangle, snapped for `contract`, until it returns false. The judge takes the triangle in
/// `format`, which may be wider.
template <class Visitor>
void for_each_judged(const scene::Scene& scene, const spec::Contract& contract,
                     const exact::Format& format, Visitor&& visit) {
  scene::SnappedSource source(contract, std::make_unique<scene::Unsnapped>(scene.source.get()));
  source.rewind();
  const exact::Frame frame = judge::exact_frame(scene.frame);
  spec::Triangle triangle;
  while (source.next(&triangle)) {
    const exact::ScreenJudge judge(stated(source.screen()), format, frame);
    if (!visit(triangle, judge)) return;
  }
}

/// Keeps the exact samples of triangles that are judged repeatedly, as far as memory allows.
class TruthCache {
 public:
  /// Keeps this many samples at most, 224 bytes each.
  explicit TruthCache(size_t most_samples = size_t{1} << 20) : most_samples_(most_samples) {}

  /// Call before each pass over the scene. Forgets samples of another depth format.
  void start(const exact::Format& format);
  /// The exact samples of triangle `number` in these rows; valid until the next call.
  const judge::ScreenTruth& truth(size_t number, const exact::ScreenJudge& judge, exact::Span rows);

 private:
  size_t most_samples_;
  size_t samples_ = 0;
  int depth_bits_ = -1;
  std::vector<judge::ScreenTruth> kept_;  // of the first triangles
  judge::ScreenTruth other_;
};

/// Calls visit(first, last, rows) for bands of a triangle: tile rows `first` to `last`, and the
/// triangle's rows of samples in them. A band has a bounded number of samples. The first and the
/// last band extend to the frame's border.
template <class Visitor>
void for_each_band(const exact::ScreenJudge& judge, int width_px, int tile_log2, Visitor&& visit) {
  constexpr int kSamples = 1 << 18;
  const exact::Span rows = judge.rows();
  const int tiles = std::max(1, kSamples / (width_px << tile_log2));
  const int last_tile = std::max(0, rows.last >> tile_log2);
  int first = 0;
  do {
    const int begin = std::max(first, (rows.first > 0 ? rows.first : 0) >> tile_log2);
    const int last = begin + tiles > last_tile ? (1 << 16) : begin + tiles - 1;
    const exact::Span part{std::max(rows.first, first << tile_log2),
                           std::min(rows.last, ((last + 1) << tile_log2) - 1)};
    visit(first, last, part);
    first = last + 1;
  } while (first <= last_tile);
}

}  // namespace pineda::studies
