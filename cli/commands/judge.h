// What pineda judge does with a scene and with a file of portable cases alike.
#pragma once

#include <optional>
#include <string>

#include "cli/output.h"
#include "cli/reserved_file.h"
#include "studies/judge/frame_verdict.h"

namespace pineda::cli {

struct JudgeOptions : Options {
  std::string portable;     // a file of portable cases, in place of the scene
  bool drawn_only = false;  // cases without a frame may be left out
  std::string dump;
  std::optional<int> subpixel_bits, depth_bits;
  std::optional<double> depth_ulp, color_lsb;
  std::string out;  // the smallest scene
};

Json diagnosis_json(const studies::Diagnosis& first);
/// "(3, 4), fill_rule, triangle 17".
std::string diagnosis_text(const studies::Diagnosis& first);
/// Writes the triangles that show it where -o wants them.
void write_smallest_scene(const JudgeOptions& options, const spec::FrameState& frame,
                          const studies::Diagnosis& first, ReservedFile* out, const Output& output);

/// The frames of all cases of a file.
int judge_portable(const JudgeOptions& options);

}  // namespace pineda::cli
