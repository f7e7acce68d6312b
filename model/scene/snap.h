// Snapping: screen triangles in binary32 become the fixed-point triangles that setup takes.
#pragma once

#include <array>
#include <memory>

#include "model/scene/screen.h"

namespace pineda::scene {

/// A coordinate in units of 2^-S px.
///
/// Bits     nearest multiple of 2^-S, halves to even, then saturated to
///          [-2^guard_bits, 2^guard_bits - 2^-S]; denormals become 0. For all floats except NaN.
/// Errors   none: saturation and denormals are counted.
int32_t snap_coordinate(const spec::Contract& contract, float value_px, Counters* counters);

/// A depth in units of 2^-8 codes.
///
/// Bits     z*(2^depth_bits - 1) in integers, rounded once, half up. (In binary32 z*16777215+.5f
///          would be wrong for half of all floats in [.5, 1].) For all floats except NaN.
/// Errors   none: z outside [0, 1] is clamped and counted; denormals become 0 and are counted.
int64_t snap_depth(const spec::Contract& contract, float z, Counters* counters);

/// Sets Vertex::inverse_w and inverse_w_shift of a triangle's three vertices.
///
/// Bits     mantissas of inverse_w_bits, rounded half up from the exact quotient of the float; the
///          greatest exponent of the three has shift 0.
/// In       w positive, finite and normal.
void set_inverse_w(const spec::Contract& contract, const std::array<float, 3>& w,
                   std::array<spec::Vertex, 3>* vertices);

/// Snaps the triangles of a reader.
///
/// Bits     a colour c becomes c*(2^n - 1)/255 for n attribute bits, rounded to the nearest; exact
///          for n = 8. A design with fewer than four attributes takes the first ones; with more,
///          the rest are 0.
/// Drops    triangles with a NaN in x, y, z or w: counted.
class SnappedSource final : public TriangleSource {
 public:
  /// Counters begin at `start`, which has what was found in the scene's state.
  SnappedSource(const spec::Contract& contract, std::unique_ptr<ScreenReader> reader,
                const Counters& start = {});

  const spec::Contract& contract() const { return contract_; }
  bool next(spec::Triangle* triangle) override;
  size_t next_many(spec::Triangle* triangles, size_t count) override;
  void rewind() override;

  /// Triangles of the scene as read, if that is known without reading it.
  std::optional<uint64_t> size() const { return reader_->size(); }
  /// See ScreenReader::stream_bytes().
  std::optional<uint64_t> stream_bytes() const { return reader_->stream_bytes(); }
  /// Skips triangles of the reader without counting them: see ScreenReader::skip().
  uint64_t skip(uint64_t triangles) { return reader_->skip(triangles); }

  /// The floats that the last triangle of next() was snapped from.
  const ScreenTriangle& screen() const { return screen_; }

 private:
  bool snap(const ScreenTriangle& screen, spec::Triangle* triangle);

  spec::Contract contract_;
  std::unique_ptr<ScreenReader> reader_;
  Counters start_;
  ScreenTriangle screen_;
  size_t colors_;  // of the four that a vertex has, those that the design takes
  std::array<int32_t, 256> color_codes_;  // of a byte
};

}  // namespace pineda::scene
