// What the RTL's tests share: the plug-ins, random triangles, and cases run on the benches.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "model/spec/random.h"
#include "studies/vectors/benches.h"
#include "tb/frame_bench.h"
#include "tb/unit_bench.h"
#include "vectors/grammar/file.h"

namespace pineda::tb {

/// The plug-in of the default design; the mutant has one fault in each unit (mutate.sh).
const RtlLibrary& rtl();
const RtlLibrary& mutant();

/// Plug-ins of traversal and interpolation alone, for kinds of designs that no named one has; see
/// designs/.
inline constexpr const char* kRasterDesigns[] = {"many", "deep", "small", "bare", "sheer"};
const RtlLibrary& raster_rtl(std::string_view name);

/// The committed cases of a unit.
template <class Case>
std::vector<Case> committed_cases() {
  const std::string unit = spec::name_of(Case::kUnit);
  return vectors::read<Case>(std::string(PINEDA_VECTORS) + "/" + unit + "/level1_seed1.txt").cases;
}

/// Triangles about `size_px` wide anywhere around the frame; one in eight is a needle, one in
/// sixteen shares a vertex with the one before, so that edges meet.
std::vector<spec::Triangle> random_triangles(spec::Random* random, const spec::FrameState& frame,
                                             int size_px, size_t count,
                                             const spec::Contract& contract = rtl().contract());
spec::FrameState random_state(spec::Random* random, int width, int height);
/// The same with all of the raster state.
spec::FrameState random_raster_state(spec::Random* random, int width, int height,
                                     const spec::Contract& contract);

/// Random triangles in a random raster state, through setup and traversal of the model.
vectors::TraversalCase random_traversal(spec::Random* random, const spec::Contract& contract,
                                        int frame_px, int size_px, size_t triangles);

/// The first difference of a case on a bench, or "" .
template <class Bench, class Case>
std::string first_difference(Bench* bench, const Case& expected,
                             const spec::Contract& contract = rtl().contract()) {
  const auto text = vectors::difference(contract, expected, run(bench, expected));
  return text ? *text : std::string();
}

/// Pulls the triangles of a list, which must outlive the pulling.
NextTriangle from(const std::vector<spec::Triangle>& triangles);

/// A frame through the top under the scoreboard: "" or what went wrong, a mismatch at a boundary or
/// in the memories at the end.
std::string check_frame(FrameBench* bench, const spec::FrameState& frame,
                        const std::vector<spec::Triangle>& triangles,
                        const spec::Contract& contract = rtl().contract());

/// The stall modes as test parameters, by name.
class StallTest : public testing::TestWithParam<StallMode> {};
inline std::string stall_test_name(const testing::TestParamInfo<StallMode>& info) {
  return stall_mode_name(info.param);
}

}  // namespace pineda::tb
