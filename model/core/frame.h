// The functional model: draws a frame through setup, traversal and interpolation with depth test.
#pragma once

#include <optional>
#include <type_traits>

#include "model/core/exact_planes.h"
#include "model/core/frame_buffer.h"
#include "model/core/frame_counters.h"
#include "model/core/interp.h"
#include "model/core/traversal.h"

namespace pineda::core {

/// Receives each token of a frame, in order. A sink may derive from this and redefine only the
/// calls that it needs.
struct Sink {
  void prim(const spec::SetupPrim&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp&, const spec::Fragment&) {}  // before the depth test
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
};

/// Interpolates a triangle's stamps: with the stamp's planes, or with exact ones if the design has
/// no reciprocal.
class Interpolator {
 public:
  Interpolator(const spec::Contract& contract, const spec::FrameState& frame,
               const spec::Triangle& triangle);
  void operator()(const spec::Stamp& stamp, spec::Fragment* fragment) const;

 private:
  const spec::Contract& contract_;
  std::optional<ExactPlanes> exact_;
};

/// Draws the part of one triangle within some rows of tiles through setup, traversal and
/// interpolation, without memories and depth test. Calls sink.prim() once, then sink.stamp() and
/// sink.fragment() for each stamp. Counts all but `interpolated` and `passed`.
template <class AnySink>
Drop draw_triangle(const spec::Contract& contract, const spec::FrameState& frame, TileRows rows,
                   const spec::Triangle& triangle, FrameCounters* counters, AnySink&& sink) {
  spec::SetupPrim prim;
  const Drop drop = setup(contract, frame, triangle, &prim);
  ++counters->triangles;
  ++counters->dropped[static_cast<size_t>(drop)];
  if (drop != Drop::kNone) return drop;
  sink.prim(prim);
  const Interpolator interpolate(contract, frame, triangle);
  spec::Fragment fragment;
  for_each_stamp(contract, prim, rows, counters, [&](const spec::Stamp& stamp) {
    sink.stamp(stamp);
    interpolate(stamp, &fragment);
    sink.fragment(stamp, fragment);
  });
  return drop;
}

/// A sink for draw_triangle() that does the depth test, writes to a frame's memories, and passes
/// all tokens on to another sink.
template <class Memories, class AnySink>
struct FrameWriter {
  const spec::Contract& contract;
  const spec::FrameState& frame;
  Memories* memories;
  FrameCounters* counters;
  AnySink& sink;

  void prim(const spec::SetupPrim& prim) { sink.prim(prim); }
  void stamp(const spec::Stamp& stamp) { sink.stamp(stamp); }
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
    sink.fragment(stamp, fragment);
    memories->count_hits(contract, stamp);
    uint32_t passed = stamp.mask;
    if (tests_depth(contract, frame)) {
      const auto stored = memories->read(contract, stamp.x, stamp.y, stamp.mask);
      passed = depth_test(contract, frame.depth, stamp.mask, fragment.z, stored.z);
    }
    if (passed == 0) return;
    ++counters->interpolated;
    counters->passed += static_cast<uint64_t>(count_lanes(passed));
    if (tests_depth(contract, frame) && frame.depth_write) {
      const auto write = depth_write(contract, stamp, fragment, passed);
      sink.depth(write);
      memories->write(contract, write);
    }
    const auto write = color_write(contract, stamp, fragment, passed);
    sink.color(write);
    memories->write(contract, write);
  }
};

/// Draws triangles one by one.
class Renderer {
 public:
  Renderer(const spec::Contract& contract, const spec::FrameState& frame)
      : contract_(contract), frame_(frame), buffer_(contract, frame) {}

  const spec::Contract& contract() const { return contract_; }
  const spec::FrameState& frame() const { return frame_; }
  /// The memories after the triangles so far.
  const FrameBuffer& buffer() const { return buffer_; }
  const FrameCounters& counters() const { return counters_; }
  void clear() {
    buffer_.clear();
    counters_ = {};
  }

  Drop draw(const spec::Triangle& triangle) { return draw(triangle, Sink{}); }
  /// The same, and passes each token at each unit boundary to `sink`, in order.
  template <class AnySink>
  Drop draw(const spec::Triangle& triangle, AnySink&& sink) {
    return draw_triangle(contract_, frame_, {}, triangle, &counters_,
                         FrameWriter<FrameBuffer, std::remove_reference_t<AnySink>>{
                             contract_, frame_, &buffer_, &counters_, sink});
  }

 private:
  spec::Contract contract_;
  spec::FrameState frame_;
  FrameBuffer buffer_;
  FrameCounters counters_;
};

}  // namespace pineda::core
