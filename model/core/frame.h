// A whole frame through the three units: the functional model.
#pragma once

#include <optional>
#include <type_traits>

#include "model/core/exact_planes.h"
#include "model/core/frame_buffer.h"
#include "model/core/frame_counters.h"
#include "model/core/interp.h"
#include "model/core/setup.h"
#include "model/core/tile_shader.h"
#include "model/core/traversal.h"

namespace pineda::core {

/// Rows of tiles, first to last.
struct TileRows {
  int first = 0;
  int last = 1 << 16;  // more than any frame has
};

/// The values of a triangle's stamps, by the planes of the stamp or, without a reciprocal in the
/// design, by exact ones.
class Interpolator {
 public:
  Interpolator(const spec::Contract& contract, const spec::FrameState& frame,
               const spec::Triangle& triangle)
      : contract_(contract) {
    if (contract.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
      exact_.emplace(contract, frame, triangle);
    }
  }

  void depth(const spec::Stamp& stamp, spec::Fragment* fragment) const {
    exact_ ? exact_->depth(contract_, stamp, fragment)
           : interpolate_depth(contract_, stamp, fragment);
  }
  void attributes(const spec::Stamp& stamp, uint32_t lanes, spec::Fragment* fragment) const {
    exact_ ? exact_->attributes(contract_, stamp, lanes, fragment)
           : interpolate_attributes(contract_, stamp, lanes, fragment);
  }

 private:
  const spec::Contract& contract_;
  std::optional<ExactPlanes> exact_;
};

/// One triangle through setup and traversal, or the part of it in some rows of tiles: no memories,
/// no depth test. Counts all but `interpolated` and `passed`, and hands over each token in order:
/// sink.prim(SetupPrim), then for each stamp sink.stamp(Stamp, Interpolator).
template <class Sink>
Drop walk_triangle(const spec::Contract& contract, const spec::FrameState& frame, TileRows rows,
                   const spec::Triangle& triangle, FrameCounters* counters, Sink&& sink) {
  spec::SetupPrim prim;
  const Drop drop = setup(contract, frame, triangle, &prim);
  ++counters->triangles;
  ++counters->dropped[static_cast<size_t>(drop)];
  if (drop != Drop::kNone) return drop;
  if (!clip_rows(contract, rows.first, rows.last, &prim)) return drop;
  sink.prim(prim);
  const Interpolator interpolator(contract, frame, triangle);

  TileWalk tiles(contract, prim);
  Tile tile;
  spec::Stamp stamp;
  for (TileWalk::Test test; (test = tiles.next(&tile)) != TileWalk::Test::kEnd;) {
    ++counters->tiles_tested;
    if (test == TileWalk::Test::kRejected) {
      ++counters->tiles_rejected;
      continue;
    }
    counters->tiles_accepted += tile.accepted == 7 ? 1 : 0;
    StampWalk stamps(contract, tile);
    stamps.begin(&stamp);
    while (stamps.next(&stamp.mask, &stamp.x, &stamp.y)) {
      if (stamp.mask == 0) continue;
      ++counters->stamps;
      counters->fragments += static_cast<uint64_t>(__builtin_popcount(stamp.mask));
      sink.stamp(stamp, interpolator);
    }
  }
  return drop;
}

/// As walk_triangle(), with the values of every covered sample, seen or not:
/// sink.prim(SetupPrim), then for each stamp sink.stamp(Stamp), sink.fragment(Stamp, Fragment).
template <class Sink>
Drop draw_triangle(const spec::Contract& contract, const spec::FrameState& frame, TileRows rows,
                   const spec::Triangle& triangle, FrameCounters* counters, Sink&& sink) {
  struct Values {
    Sink& sink;
    spec::Fragment fragment;
    void prim(const spec::SetupPrim& prim) { sink.prim(prim); }
    void stamp(const spec::Stamp& stamp, const Interpolator& interpolator) {
      sink.stamp(stamp);
      interpolator.depth(stamp, &fragment);
      interpolator.attributes(stamp, stamp.mask, &fragment);
      sink.fragment(stamp, fragment);
    }
  };
  return walk_triangle(contract, frame, rows, triangle, counters, Values{sink, {}});
}

/// Draws triangles one by one, or the part of them that lies in some rows of tiles. With a Sink,
/// hands over each token at each unit boundary in order: sink.prim(SetupPrim), sink.stamp(Stamp),
/// sink.depth(DepthWrite), sink.color(ColorWrite). Attributes are interpolated where a sample
/// passes the depth test.
class Renderer {
 public:
  Renderer(const spec::Contract& contract, const spec::FrameState& frame, TileRows rows = {});

  const spec::Contract& contract() const { return contract_; }
  const spec::FrameState& frame() const { return frame_; }
  /// The memories after the triangles so far; a copy is made when it is asked for.
  const FrameBuffer& buffer() const;
  /// Copies its rows of tiles to a buffer of this frame.
  void copy_rows(FrameBuffer* to) const;
  const FrameCounters& counters() const { return counters_; }

  void clear();

  template <class Sink>
  Drop draw(const spec::Triangle& triangle, Sink&& sink);
  /// The same by whole tiles, as fast as it goes.
  Drop draw(const spec::Triangle& triangle);

  /// The same, with the values of every covered sample: sink.fragment(Stamp, Fragment), after
  /// sink.stamp() and before the depth test.
  template <class Sink>
  Drop draw_showing_all(const spec::Triangle& triangle, Sink&& sink);

 private:
  template <class Sink>
  struct Writer;
  template <class Sink>
  struct ShowingWriter;
  uint32_t test(const spec::Stamp& stamp, const spec::Fragment& fragment);
  template <class Sink>
  void write(const spec::Stamp& stamp, const spec::Fragment& fragment, uint32_t passed,
             Sink&& sink);

  spec::Contract contract_;
  spec::FrameState frame_;
  TileRows rows_;
  TiledBuffer buffer_;
  mutable std::optional<FrameBuffer> by_rows_;  // once somebody asked, until the next draw
  FrameCounters counters_;
  spec::SetupPrim prim_;
  TileCoverWalk tiles_;
  TileCover cover_;
  StampCounts covered_;  // of one triangle
  TileShader shader_;
  StampCounts passed_;  // of the triangles before
};

template <class Sink>
struct Renderer::Writer {
  Renderer& to;
  Sink& sink;
  spec::Fragment fragment;
  void prim(const spec::SetupPrim& prim) { sink.prim(prim); }
  void stamp(const spec::Stamp& stamp, const Interpolator& interpolator) {
    sink.stamp(stamp);
    to.buffer_.count_hits(to.contract_, stamp);
    interpolator.depth(stamp, &fragment);
    const uint32_t passed = to.test(stamp, fragment);
    if (passed == 0) return;
    interpolator.attributes(stamp, passed, &fragment);
    to.write(stamp, fragment, passed, sink);
  }
};

template <class Sink>
struct Renderer::ShowingWriter {
  Renderer& to;
  Sink& sink;
  void prim(const spec::SetupPrim& prim) { sink.prim(prim); }
  void stamp(const spec::Stamp& stamp) {
    sink.stamp(stamp);
    to.buffer_.count_hits(to.contract_, stamp);
  }
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
    sink.fragment(stamp, fragment);
    const uint32_t passed = to.test(stamp, fragment);
    if (passed != 0) to.write(stamp, fragment, passed, sink);
  }
};

template <class Sink>
Drop Renderer::draw(const spec::Triangle& triangle, Sink&& sink) {
  by_rows_.reset();
  return walk_triangle(contract_, frame_, rows_, triangle, &counters_,
                       Writer<std::remove_reference_t<Sink>>{*this, sink, {}});
}

template <class Sink>
Drop Renderer::draw_showing_all(const spec::Triangle& triangle, Sink&& sink) {
  by_rows_.reset();
  return draw_triangle(contract_, frame_, rows_, triangle, &counters_,
                       ShowingWriter<std::remove_reference_t<Sink>>{*this, sink});
}

template <class Sink>
void Renderer::write(const spec::Stamp& stamp, const spec::Fragment& fragment, uint32_t passed,
                     Sink&& sink) {
  ++counters_.interpolated;
  counters_.passed += static_cast<uint64_t>(__builtin_popcount(passed));
  if (tests_depth(contract_, frame_) && frame_.depth_write) {
    const auto write = depth_write(contract_, stamp, fragment, passed);
    sink.depth(write);
    buffer_.write(contract_, write);
  }
  const auto write = color_write(contract_, stamp, fragment, passed);
  sink.color(write);
  buffer_.write(contract_, write);
}

}  // namespace pineda::core
