// Depth test and values by whole tiles, quickly.
#pragma once

#include "model/fast/tile_values.h"

namespace pineda::fast {

/// Interpolates, tests and writes the covered samples of a tile.
///
/// Bits     those of core::interpolate_depth(), core::depth_test() and
///          core::interpolate_attributes(), stamp by stamp: the stamps of a tile share no sample.
/// In       begin(): a SetupPrim with the planes that `values` wants, which must outlive its tiles.
///          draw(): its tiles.
/// Out      the buffer; passed(): of the tile drawn last, while its cover is there, the samples
///          that passed the test.
/// Errors   not for a design without a reciprocal: it has no planes.
class TileShader {
 public:
  /// What is computed for a sample: its depth, and if it passes its attributes.
  enum class Values { kDepth, kAll };

  TileShader(const spec::Contract& contract, const spec::FrameState& frame, Values values);

  void begin(const spec::SetupPrim& prim);
  void draw(const TileCover& cover, TiledBuffer* buffer);
  void count_hits(const TileCover& cover, TiledBuffer* buffer) const;
  const TileSamples& passed() const { return all_ != nullptr ? *all_ : tested_; }
  const StampCounts& counts() const { return counts_; }  // of what passed, so far
  /// As core::depth_floor() of that tile of the triangle.
  uint32_t depth_floor(int tile_x, int tile_y) const;

 private:
  TileOffset offset(int x, int y) const;
  void test_depth(const TileCover& cover, TiledBuffer* buffer);
  void draw_perspective(const TileCover& cover, TiledBuffer* buffer);

  spec::Contract contract_;
  const spec::SetupPrim* prim_ = nullptr;
  bool tests_depth_;
  bool has_colors_;
  // Of the triangle, and of the tile drawn last.
  DepthTest depth_;
  TileColors colors_;
  const TileSamples* all_ = nullptr;  // the cover's samples if all passed, else null
  TileSamples tested_;                // what passed if not all did
  StampCounts counts_;
  // Perspective
  spec::Stamp stamp_;
  spec::ColorWrite color_;
};

}  // namespace pineda::fast
