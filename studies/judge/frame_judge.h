// Judges a finished frame of any rasterizer by exact arithmetic: its hits, depths and colours, with
// other stamps, tiles, widths and errors than ours.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/exact/exact.h"
#include "model/scene/screen.h"
#include "model/spec/structs.h"
#include "studies/judge/frame_dump.h"

namespace pineda::studies {

/// How the rasterizer snaps, and how far its values may be from the exact ones.
struct FrameTolerance {
  exact::Format format;  // positions and depth codes; colours of 8 bits
  double depth_ulp = 1;  // codes, the rounding to a code included
  double color_lsb = 1;
};

/// The codes that a depth within the tolerance may have.
struct Codes {
  int64_t low = 0;
  int64_t high = 0;

  bool holds(int64_t code) const { return low <= code && code <= high; }
};

/// A triangle's values at a sample that it covers.
struct Fragment {
  exact::Value z;
  std::array<exact::Value, 4> color;
};
Fragment fragment_of(const exact::Sample& sample, bool affine);
Codes codes_of(const exact::Value& z, const FrameTolerance& tolerance);
bool is_color(const Fragment& fragment, const std::array<uint8_t, 4>& rgba, double lsb);

/// What two triangles have in common whose depths are equal by any arithmetic: the same z at all
/// corners, or the same corners in the same order.
struct SameDepth {
  explicit SameDepth(const exact::Triangle& snapped);

  bool operator==(const SameDepth& other) const {
    return constant_z >= 0 ? constant_z == other.constant_z : corners == other.corners;
  }

  int64_t constant_z = -1;  // -1: the corners differ
  uint64_t corners = 0;     // their hash
};

/// Judges the samples of a frame while the triangles of its scene pass by.
///
/// Bits     a sample's hits must be the number of triangles that cover it, exactly. Its depth and
///          colour must be within the tolerance of those of one triangle that may be seen there: what
///          the depth test decides between two depths that the tolerance lets be in either order is
///          left open, unless they are equal by any arithmetic: of the same corners in the same
///          order, or of one z at all corners. What nothing is drawn on must be as it was cleared.
/// In       memory: 34 bytes a sample, and 32 for each further triangle that may be seen there; 16 a
///          triangle.
class FrameJudge {
 public:
  /// `dump` must outlive the judge.
  FrameJudge(const spec::FrameState& frame, const FrameTolerance& tolerance, const FrameDump& dump);

  /// The triangles, in the order of drawing.
  void triangle(const scene::ScreenTriangle& triangle);
  /// The samples that are wrong, row by row: indices.
  std::vector<size_t> wrong() const;

  /// How many triangles cover a sample.
  uint16_t hits(size_t sample) const { return hits_[sample]; }
  /// The triangles that may be seen there, by their place in the order of drawing; nothing stands for
  /// what was cleared. The dump must have depths or colours.
  std::vector<std::optional<uint32_t>> seen(size_t sample) const;

 private:
  // What a sample may hold.
  struct State {
    Codes stored;
    uint32_t triangle;  // that is seen, in the order of drawing; kNone: none is
    bool is_color;      // the dump has its colour
    int32_t next;       // of the sample; -1: none
  };
  static constexpr uint32_t kNone = UINT32_MAX;

  void draw(size_t sample, const Fragment& fragment);
  int32_t new_state(const State& state);
  bool is_wrong(size_t sample) const;

  spec::FrameState frame_;
  exact::Frame exact_frame_;
  FrameTolerance tolerance_;
  const FrameDump& dump_;
  std::vector<uint16_t> hits_;
  std::vector<State> state_;  // the first ones are those of the samples
  int32_t free_ = -1;         // states that can be used again
  std::vector<SameDepth> drawn_;
  std::vector<exact::Sample> row_;
  std::vector<State> before_, after_;  // a sample's, while a fragment is drawn
};

}  // namespace pineda::studies
