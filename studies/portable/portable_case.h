// Test cases for any rasterizer: a scene, and what exact arithmetic says of each of its samples. Nothing
// in them comes from a design's stamps, tiles, units or errors.
#pragma once

#include <string>
#include <vector>

#include "studies/judge/frame_judge.h"
#include "vectors/grammar/cases.h"

namespace pineda::studies {

/// Frames of more samples have no portable cases: dumps are whole frames.
inline constexpr size_t kPortableSamples = size_t{1} << 16;

/// A scene of screen triangles; in the formats of its file they are snapped already.
struct PortableCase {
  std::string name;  // "sliver.3": class and number
  spec::FrameState frame;
  std::vector<scene::ScreenTriangle> triangles;

  size_t samples() const {
    return static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  }
};

/// The scene of a frame's vector; its outputs are not looked at.
///
/// Bits     positions stay as they are, depths are rounded to binary32, colours to 8 bits; 1/w becomes
///          the nearest binary32 w; a bias beyond all codes is that of all codes. Channels that the design
///          lacks are 0.
PortableCase portable_case(const spec::Contract& contract, const vectors::FrameCase& vector);

/// The contract whose scenes have these formats, with perspective; its widths are those of a design.
/// Throws scene::InputError where there is none: `file` and `line` are for the message.
spec::Contract portable_contract(const exact::Format& format, const std::string& file,
                                 uint64_t line);

/// The lines of a case, from `case` to `end`, as docs/formats.md has them.
std::string portable_text(const PortableCase& value, const FrameTolerance& tolerance);

}  // namespace pineda::studies
