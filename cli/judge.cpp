#include "cli/judge.h"

#include <algorithm>
#include <cmath>

#include "studies/truth.h"

namespace pineda::cli {
namespace {

/// Sees the stamps of one triangle.
struct JudgeSink {
  const spec::Contract& contract;
  const exact::Judge& judge;
  Judgement* to;
  uint64_t right = 0;                       // samples that both cover
  std::array<int, 4> last{-1, -1, -1, -1};  // tile row, tile column, row, column of a stamp

  void prim(const spec::SetupPrim&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
    const spec::Design& d = contract.design;
    const std::array<int, 4> now{stamp.y >> (d.tile_log2 - d.stamp_height_log2),
                                 stamp.x >> (d.tile_log2 - d.stamp_width_log2), stamp.y, stamp.x};
    if (now <= last) {  // sent before: it must not make up for one that is missing
      const auto samples = static_cast<uint64_t>(__builtin_popcount(stamp.mask));
      to->samples += samples;
      to->extra += samples;
      return;
    }
    last = now;
    for (int lane = 0; lane < contract.width.lanes; ++lane) {
      if ((stamp.mask >> lane & 1) == 0) continue;
      const int x = (stamp.x << d.stamp_width_log2) + (lane & ((1 << d.stamp_width_log2) - 1));
      const int y = (stamp.y << d.stamp_height_log2) + (lane >> d.stamp_width_log2);
      sample(x, y, static_cast<size_t>(lane), fragment);
    }
  }

  void sample(int x, int y, size_t lane, const spec::Fragment& fragment) {
    ++to->samples;
    if (!judge.covers(x, y)) {
      ++to->extra;
      return;
    }
    ++right;
    to->max_depth_ulp =
        std::max(to->max_depth_ulp, std::abs(judge.depth_error(x, y, fragment.z[lane])));
    for (int a = 0; a < contract.design.attributes; ++a) {
      const double error =
          judge.attribute_error(x, y, a, fragment.attr[lane][static_cast<size_t>(a)]);
      to->max_color_lsb = std::max(to->max_color_lsb, std::abs(error));
    }
  }
};

}  // namespace

exact::ScreenTriangle stated(const scene::ScreenTriangle& triangle) {
  exact::ScreenTriangle result;
  for (size_t i = 0; i < 3; ++i) {
    const scene::ScreenVertex& v = triangle.v[i];
    result[i] = {v.x, v.y, v.z, v.w, {v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]}};
  }
  return result;
}

Judgement judge(scene::SnappedSource* source, core::Renderer* renderer, Progress* progress) {
  const spec::Contract& contract = renderer->contract();
  const auto format = studies::format_of(contract.design);
  const auto frame = studies::exact_frame(renderer->frame());
  Judgement judgement;
  spec::Triangle triangle;
  while (source->next(&triangle)) {
    progress->update("exact judge", triangle.id);
    const exact::ScreenJudge screen(stated(source->screen()), format, frame);
    const exact::Judge& exact = screen.snapped();
    JudgeSink sink{contract, exact, &judgement};
    renderer->draw(triangle, sink);
    judgement.missing += static_cast<uint64_t>(exact.samples()) - sink.right;
  }
  return judgement;
}

}  // namespace pineda::cli
