// What is wrong with a frame, and why its first sample is.
#pragma once

#include <optional>
#include <vector>

#include "studies/judge/frame_diagnosis.h"

namespace pineda::studies {

struct FrameVerdict {
  std::vector<size_t> wrong;       // samples, row by row
  std::optional<Diagnosis> first;  // of the first of them

  bool holds() const { return wrong.empty(); }
};

/// Judges a frame. `for_each_triangle(phase, visit)` calls visit(ScreenTriangle) in the order of drawing,
/// and is called again where a sample is wrong.
template <class ForEachTriangle>
FrameVerdict judge_frame(const spec::FrameState& frame, const FrameTolerance& tolerance,
                         const FrameDump& dump, const scene::ClipMesh* mesh,
                         ForEachTriangle&& for_each_triangle) {
  FrameJudge judge(frame, tolerance, dump);
  for_each_triangle("judging", [&](const scene::ScreenTriangle& t) { judge.triangle(t); });
  FrameVerdict verdict{judge.wrong(), std::nullopt};
  if (verdict.holds()) return verdict;
  FrameDiagnosis diagnosis(frame, tolerance, dump, verdict.wrong.front(), mesh);
  for_each_triangle("explaining", [&](const scene::ScreenTriangle& t) { diagnosis.triangle(t); });
  verdict.first = diagnosis.result();
  return verdict;
}

}  // namespace pineda::studies
