// pineda_judge() of pineda/golden.h.
#include <algorithm>

#include "golden/ranges.h"
#include "studies/judge/frame_verdict.h"

namespace pineda::golden {
namespace {

studies::FrameTolerance tolerance_of(const pineda_tolerance& stated) {
  // The formats are those that a design may have.
  spec::Design design = *spec::find_design("persp");
  design.subpixel_bits = stated.subpixel_bits;
  design.guard_bits = stated.guard_bits;
  design.depth_bits = stated.depth_bits;
  const std::string why = spec::invalid_reason(design);
  if (!why.empty()) refuse(PINEDA_OUT_OF_RANGE, "tolerance: {}", why);
  const double most = 4294967296.;
  if (!(stated.depth_ulp >= 0 && stated.depth_ulp <= most)) {
    refuse(PINEDA_OUT_OF_RANGE, "tolerance.depth_ulp: expected 0 to {}, got {}", most,
           stated.depth_ulp);
  }
  if (!(stated.color_lsb >= 0 && stated.color_lsb <= 255)) {
    refuse(PINEDA_OUT_OF_RANGE, "tolerance.color_lsb: expected 0 to 255, got {}", stated.color_lsb);
  }
  return {{stated.subpixel_bits, stated.guard_bits, stated.depth_bits, 4, 8},
          stated.depth_ulp,
          stated.color_lsb};
}

studies::FrameDump dump_of(const pineda_dump& stated, const spec::FrameState& frame) {
  const size_t samples = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  if (stated.samples != samples) {
    refuse(PINEDA_WRONG_SIZE, "dump.samples: expected {}, got {}", samples, stated.samples);
  }
  if (stated.hits == nullptr && stated.depth == nullptr && stated.rgba == nullptr) {
    refuse(PINEDA_NULL_POINTER, "dump: expected hits, depth or rgba, got none");
  }
  studies::FrameDump dump;
  if (stated.hits != nullptr) dump.hits.emplace(stated.hits, stated.hits + samples);
  if (stated.depth != nullptr) dump.depth.emplace(stated.depth, stated.depth + samples);
  if (stated.rgba == nullptr) return dump;
  dump.color.emplace(samples);
  for (size_t i = 0; i < samples; ++i) {
    std::copy_n(stated.rgba + 4 * i, 4, (*dump.color)[i].begin());
  }
  return dump;
}

pineda_verdict verdict_of(const studies::FrameVerdict& found) {
  pineda_verdict verdict{};
  verdict.samples_wrong = found.wrong.size();
  verdict.triangle = -1;
  if (!found.first) return verdict;
  verdict.x = found.first->x;
  verdict.y = found.first->y;
  verdict.rule = static_cast<int32_t>(found.first->rule);
  if (found.first->triangle) verdict.triangle = *found.first->triangle;
  const std::string& what = found.first->what;
  std::copy_n(what.begin(), std::min(what.size(), sizeof verdict.what - 1), verdict.what);
  return verdict;
}

}  // namespace
}  // namespace pineda::golden

using namespace pineda;  // NOLINT: a file of C functions
using golden::require_pointer;

pineda_tolerance pineda_default_tolerance(void) { return {8, 14, 24, 1, 1}; }

pineda_status pineda_judge(const pineda_frame* frame, const pineda_tolerance* tolerance,
                           const pineda_screen_triangle* triangles, size_t count,
                           const pineda_dump* dump, pineda_verdict* verdict, uint8_t* wrong) {
  return golden::call([&] {
    require_pointer(tolerance, "tolerance");
    require_pointer(dump, "dump");
    require_pointer(verdict, "verdict");
    if (count > 0) require_pointer(triangles, "triangles");
    const studies::FrameTolerance bounds = golden::tolerance_of(*tolerance);
    const spec::FrameState state =
        golden::frame_of(frame, bounds.format.guard_bits, bounds.format.depth_bits);
    const studies::FrameDump drawn = golden::dump_of(*dump, state);
    const auto found =
        studies::judge_frame(state, bounds, drawn, nullptr, [&](const char*, const auto& visit) {
          for (size_t i = 0; i < count; ++i) {
            auto screen = golden::checked(
                "triangles", i, [&] { return golden::screen_of(bounds.format, triangles[i]); });
            screen.id = static_cast<uint32_t>(i);
            visit(screen);
          }
        });
    *verdict = golden::verdict_of(found);
    if (wrong == nullptr) return;
    std::fill_n(wrong, dump->samples, uint8_t{0});
    for (const size_t sample : found.wrong) wrong[sample] = 1;
  });
}
