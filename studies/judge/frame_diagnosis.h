// Which rule a wrong sample of a frame breaks, and by which triangle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene/mesh_reader.h"
#include "model/spec/names.h"
#include "studies/judge/frame_judge.h"

namespace pineda::studies {

enum class Rule {
  kCoverage,
  kFillRule,
  kCull,
  kScissor,
  kNearPlane,
  kDepthFunc,
  kDepthTie,
  kDepthValue,
  kColorValue,
  kClear,
};

inline constexpr spec::Name<Rule> kRuleNames[] = {{Rule::kCoverage, "coverage"},
                                                  {Rule::kFillRule, "fill_rule"},
                                                  {Rule::kCull, "cull"},
                                                  {Rule::kScissor, "scissor"},
                                                  {Rule::kNearPlane, "near_plane"},
                                                  {Rule::kDepthFunc, "depth_func"},
                                                  {Rule::kDepthTie, "depth_tie"},
                                                  {Rule::kDepthValue, "depth_value"},
                                                  {Rule::kColorValue, "color_value"},
                                                  {Rule::kClear, "clear"}};
constexpr const auto& names(Rule) { return kRuleNames; }

/// What is wrong with a sample.
struct Diagnosis {
  int x = 0, y = 0;  // px
  Rule rule = Rule::kCoverage;
  std::optional<uint32_t> triangle;  // by its number; none where no triangle has to do with it
  std::string what;                  // "hits are 2, expected 1: ..."
  std::vector<scene::ScreenTriangle> scene;  // the triangles that show it, in the order of drawing
};

/// Explains one sample that FrameJudge calls wrong, while the triangles of its scene pass by again.
///
/// Out      the rule, and the triangle that was treated against it: of coverage, fill rule, culling and
///          scissor the one that was drawn or left out, of a depth test the later of the two that met
///          there, of a value the one that should be seen. Where hits are missing, coverage is told
///          from depth and colour.
class FrameDiagnosis {
 public:
  /// `mesh`: what the scene was clipped from, or nullptr.
  FrameDiagnosis(const spec::FrameState& frame, const FrameTolerance& tolerance,
                 const FrameDump& dump, size_t sample, const scene::ClipMesh* mesh);

  void triangle(const scene::ScreenTriangle& triangle);
  Diagnosis result() const;

 private:
  // A triangle that covers the sample, or may have been taken to.
  struct Near {
    scene::ScreenTriangle stated;
    SameDepth same_depth;
    bool is_culled = false;
    bool is_covering = false;  // by the fill rule, culling and scissor left aside
    bool is_on_edge = false;   // the sample lies on its border
    double distance_px = 0;    // of the sample from its border
    // At the sample; where the triangle does not cover it, of its planes, in doubles and without bias.
    Fragment fragment{};
    Codes codes{};
  };

  void keep(const Near& near);
  Diagnosis of_hits(int64_t expected) const;
  Diagnosis of_missing(const std::string& what) const;
  Diagnosis of_extra(const std::string& what) const;
  Diagnosis of_values() const;
  Diagnosis of_other_winner(const Near& winner, const Near& shown) const;
  Diagnosis told(Rule rule, const Near* blamed, const std::string& what) const;

  bool is_drawn(const Near& near) const;  // is it to be drawn at the sample?
  bool is_shown(const Near& near) const;  // has the sample its depth and its colour?
  bool is_cleared() const;
  const Near* winner() const;
  std::optional<uint32_t> behind_near_plane() const;
  bool reaches_behind_near_plane(uint32_t triangle) const;

  spec::FrameState frame_;
  exact::Frame exact_frame_;
  FrameTolerance tolerance_;
  const scene::ClipMesh* mesh_;
  int x_, y_;
  bool is_in_scissor_;
  std::optional<uint16_t> hits_;
  std::optional<uint32_t> depth_;
  std::optional<std::array<uint8_t, 4>> color_;
  std::vector<Near> near_;     // in the order of drawing
  bool only_nearest_ = false;  // near_ has one triangle, more than kNearPx away
};

}  // namespace pineda::studies
