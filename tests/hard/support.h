// What the tests of the hard cases share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/core/frame.h"
#include "model/judge/exact_terms.h"
#include "model/scene/hard/cases.h"

namespace pineda::hard {

/// A case as a design takes it.
struct Snapped {
  spec::FrameState frame;
  std::vector<spec::Triangle> triangles;
  scene::Counters counters;
};

/// The case of that name; it must exist.
const scene::HardCase& hard_case(const std::string& name);
Snapped snapped(const scene::HardCase& hard_case, const spec::Contract& contract);
/// The same at the default design.
Snapped snapped(const std::string& name);

inline exact::Judge judge(const spec::Contract& contract, const spec::FrameState& frame,
                          const spec::Triangle& triangle) {
  return judge::exact_judge(contract.design, frame, triangle);
}
/// Triangles that cover each sample, by the judge alone.
std::vector<uint16_t> judged_hits(const spec::Contract& contract, const Snapped& scene);

/// All triangles, or triangles first .. first+count-1 alone, drawn by core at the default design.
core::Renderer drawn(const Snapped& scene);
core::Renderer drawn(const Snapped& scene, size_t first, size_t count);

/// Each case as a test parameter, by name.
class HardCaseTest : public testing::TestWithParam<scene::HardCase> {};
inline std::string case_name(const testing::TestParamInfo<scene::HardCase>& info) {
  return info.param.name;
}

}  // namespace pineda::hard
