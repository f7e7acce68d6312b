// Depth test and values by whole tiles: the fast path behind Renderer and the cycle model.
#pragma once

#include "model/core/frame_buffer.h"
#include "model/core/interp.h"
#include "model/core/tile_cover.h"

namespace pineda::core {

/// Interpolates, tests and writes the covered samples of a tile.
///
/// Bits     those of interpolate_depth(), depth_test() and interpolate_attributes(), stamp by
/// stamp:
///          the stamps of a tile share no sample.
/// In       begin(): a SetupPrim with the planes that `values` wants, which must outlive its tiles.
///          draw(): its tiles.
/// Out      the buffer; passed(): of the tile drawn last, the samples that passed the test, with
///          masks if asked for.
/// Errors   not for a design without a reciprocal: it has no planes.
class TileShader {
 public:
  /// What is computed for a sample: its depth, and if it passes its attributes.
  enum class Values { kDepth, kAll };

  TileShader(const spec::Contract& contract, const spec::FrameState& frame, Values values,
             bool with_masks = false);

  void begin(const spec::SetupPrim& prim);
  void draw(const TileCover& cover, FrameBuffer* buffer);
  void count_hits(const TileCover& cover, FrameBuffer* buffer) const;
  const TileSamples& passed() const { return passed_; }
  const StampCounts& counts() const { return counts_; }  // of what passed, so far
  /// As core::depth_floor() of that tile of the triangle.
  uint32_t depth_floor(int tile_x, int tile_y) const;

 private:
  // Steps of a plane inside a tile, F' fraction bits, modulo its width there.
  void narrow(const spec::Plane& plane, int tile_bits, spec::Plane* in_tile) const;
  // Its reference, at the first sample of a tile.
  int64_t reference(const spec::Plane& plane, int x, int y, int plane_bits, int tile_bits) const;
  void test_depth(const TileCover& cover, FrameBuffer* buffer);
  void pass_all(const TileCover& cover);
  void draw_affine(const TileCover& cover, FrameBuffer* buffer);
  void draw_perspective(const TileCover& cover, FrameBuffer* buffer);

  spec::Contract contract_;
  spec::FrameState frame_;
  Values values_;
  const spec::SetupPrim* prim_ = nullptr;
  bool with_masks_;
  spec::Plane z_;  // in a tile
  std::array<spec::Plane, spec::kMaxAttributes> attr_;
  PassesWhen when_;
  TileSamples passed_;
  StampCounts counts_;
  // Perspective
  spec::Stamp stamp_;
  spec::Fragment fragment_;
  spec::ColorWrite color_;
};

}  // namespace pineda::core
