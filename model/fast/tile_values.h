// Depths and colours of a tile's blocks: the loops behind TileShader.
#pragma once

#include "model/core/interp.h"
#include "model/fast/tiled_buffer.h"

namespace pineda::fast {

/// A plane in a tile. Its bits are the top ones of 64, so that sums wrap by themselves.
struct TilePlane {
  uint64_t ref = 0, dx = 0, dy = 0;
};

/// The bits of a plane in a tile and of its codes, and how many fraction bits a tile drops.
struct Format {
  int plane_bits;
  int fraction_bits;
  int code_bits;
  int dropped_bits;
};

/// Px from the first tile of a triangle, modulo 2^64.
struct TileOffset {
  uint64_t right = 0, down = 0;
};

/// A plane at the first sample of a tile.
TilePlane plane_in_tile(const spec::Plane& plane, const Format& format, const TileOffset& tile);

struct DepthTest {
  Format format;
  core::PassesWhen when;
  bool writes;
  TilePlane plane = {};
  int64_t bias = 0;  // units of 2^-16 codes
};

/// Which samples of a block passed or failed, all blocks of a tile together.
struct Outcome {
  uint64_t passed = 0;
  uint64_t failed = 0;
};

/// Tests the covered samples of a tile and writes those that pass; returns them in *samples.
Outcome test_tile(const DepthTest& test, const TileCover& cover, TiledBuffer* buffer,
                  TileSamples* samples);

/// The values of a triangle in a tile.
struct TileColors {
  Format format;
  TileOffset tile = {};
  const spec::Plane* planes = nullptr;
  const int32_t* flat = nullptr;
};

/// Writes the affine and flat values of the samples that passed.
void write_tile(const spec::Design& design, const TileColors& colors, const TileCover& cover,
                const TileSamples& passed, TiledBuffer* buffer);

/// Counts the covered samples.
void count_tile(const TileCover& cover, TiledBuffer* buffer);

}  // namespace pineda::fast
