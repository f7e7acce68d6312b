// Random designs and random scenes for them: what a test over "any design" draws from.
#pragma once

#include <cstdint>
#include <string>

#include "model/memory/kinds.h"
#include "model/spec/widths.h"
#include "tb/frame_bench.h"

namespace pineda::test {

/// A valid design with RTL, named rSEED: every parameter anywhere in its range, FIFO depths and
/// latencies as often short as long. One limit is not the design's: channels times samples of a
/// stamp stay below 64 (32 with perspective), so that its RTL compiles within a minute or two.
spec::Design random_design(uint64_t seed);

/// "newton l7 n2 k30, stepped, S8 g14, z24 hz, 4+0x8, F18/8, tile 8, stamp 2x2, ...": in one line.
std::string summary_of(const spec::Design& design);

/// A scene in the format .tri, in any raster state: needles, triangles of one stamp, of the frame,
/// of the whole guard band, alone or mixed.
std::string random_tri(const spec::Design& design, uint64_t seed);

/// A frame that a check draws: the scene and the time it is drawn in.
struct Trial {
  std::string scene;       // as scene::open_scene() takes it
  std::string size;        // WxH of a built-in one; else empty
  tb::BenchOptions bench;  // but for its memory
  memory::Kind memory = memory::Kind::kIdeal;

  /// Arguments of `pineda check`, but for the design.
  std::string arguments() const;
};

/// A random scene written to FOLDER/scene_SEED.tri or, one in four, a built-in one.
Trial random_trial(const spec::Design& design, uint64_t seed, const std::string& folder);

}  // namespace pineda::test
