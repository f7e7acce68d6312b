// A whole frame through the three units: the functional model.
#pragma once

#include <optional>
#include <vector>

#include "model/core/exact_planes.h"
#include "model/core/interp.h"
#include "model/core/setup.h"
#include "model/core/traversal.h"

namespace pineda::core {

/// The frame's memories, row-major, top row first. Only samples inside the frame exist.
struct FrameBuffer {
  int width = 0;
  int height = 0;
  int attributes = 0;
  std::vector<uint32_t> depth;  // codes, cleared to the greatest
  std::vector<uint16_t> color;  // `attributes` values a sample, cleared to 0
  std::vector<uint16_t> hits;   // triangles that cover the sample, saturating at 65535

  FrameBuffer() = default;
  FrameBuffer(const spec::Contract& contract, const spec::FrameState& frame);
  void clear(const spec::Contract& contract);

  /// Calls visit(lane, sample) for each lane of `mask` of the stamp in column x, row y; `sample`
  /// indexes the memories.
  template <class Visitor>
  void for_each_lane(const spec::Contract& contract, int x, int y, uint32_t mask,
                     Visitor&& visit) const {
    const int w_log2 = contract.design.stamp_width_log2;
    for (; mask != 0; mask &= mask - 1) {
      const int lane = __builtin_ctz(mask);
      const int px = (x << w_log2) + (lane & ((1 << w_log2) - 1));
      const int py = (y << contract.design.stamp_height_log2) + (lane >> w_log2);
      visit(static_cast<size_t>(lane),
            static_cast<size_t>(py) * static_cast<size_t>(width) + static_cast<size_t>(px));
    }
  }

  /// Depth codes of a stamp at the lanes of `mask`; 0 in the others.
  spec::DepthData read(const spec::Contract& contract, int x, int y, uint32_t mask) const;
  void write(const spec::Contract& contract, const spec::DepthWrite& write);
  void write(const spec::Contract& contract, const spec::ColorWrite& write);
  void count_hits(const spec::Contract& contract, const spec::Stamp& stamp);
};

/// What happened to the triangles and samples of a frame.
struct FrameCounters {
  uint64_t triangles = 0;
  std::array<uint64_t, kDropCauses> dropped{};  // by Drop
  uint64_t tiles_tested = 0;
  uint64_t tiles_rejected = 0;
  uint64_t tiles_accepted = 0;  // all three edges accept
  uint64_t stamps = 0;          // sent, so not empty
  uint64_t fragments = 0;       // covered samples sent
  uint64_t passed = 0;          // samples written
};

/// Rows of tiles, first to last.
struct TileRows {
  int first = 0;
  int last = 1 << 16;  // more than any frame has
};

/// One triangle through setup, traversal and interpolation, or the part of it in some rows of
/// tiles: no memories, no depth test. Counts all but `passed`, and hands over each token in order:
/// sink.prim(SetupPrim), then for each stamp sink.stamp(Stamp), sink.fragment(Stamp, Fragment).
template <class Sink>
Drop draw_triangle(const spec::Contract& contract, const spec::FrameState& frame, TileRows rows,
                   const spec::Triangle& triangle, FrameCounters* counters, Sink&& sink) {
  spec::SetupPrim prim;
  const Drop drop = setup(contract, frame, triangle, &prim);
  ++counters->triangles;
  ++counters->dropped[static_cast<size_t>(drop)];
  if (drop != Drop::kNone) return drop;
  if (!clip_rows(contract, rows.first, rows.last, &prim)) return drop;
  sink.prim(prim);
  std::optional<ExactPlanes> exact;
  if (contract.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    exact.emplace(contract, triangle);
  }

  TileWalk tiles(contract, prim);
  Tile tile;
  spec::Stamp stamp;
  spec::Fragment fragment;
  for (TileWalk::Test test; (test = tiles.next(&tile)) != TileWalk::Test::kEnd;) {
    ++counters->tiles_tested;
    if (test == TileWalk::Test::kRejected) {
      ++counters->tiles_rejected;
      continue;
    }
    counters->tiles_accepted += tile.accepted == 7 ? 1 : 0;
    stamp.id = tile.id;
    stamp.planes = tile.planes;
    StampWalk stamps(contract, tile);
    while (stamps.next(&stamp.mask, &stamp.x, &stamp.y)) {
      if (stamp.mask == 0) continue;
      ++counters->stamps;
      counters->fragments += static_cast<uint64_t>(__builtin_popcount(stamp.mask));
      sink.stamp(stamp);
      if (exact) {
        exact->interpolate(contract, stamp, &fragment);
      } else {
        interpolate(contract, stamp, &fragment);
      }
      sink.fragment(stamp, fragment);
    }
  }
  return drop;
}

/// Draws triangles one by one, or the part of them that lies in some rows of tiles. With a Sink,
/// hands over each token at each unit boundary in order: sink.prim(SetupPrim), sink.stamp(Stamp),
/// sink.depth(DepthWrite), sink.color(ColorWrite); and inside the last unit, before the depth test,
/// sink.fragment(Stamp, Fragment).
class Renderer {
 public:
  Renderer(const spec::Contract& contract, const spec::FrameState& frame, TileRows rows = {})
      : contract_(contract), frame_(frame), rows_(rows), buffer_(contract, frame) {}

  const spec::Contract& contract() const { return contract_; }
  const spec::FrameState& frame() const { return frame_; }
  const FrameBuffer& buffer() const { return buffer_; }
  const FrameCounters& counters() const { return counters_; }

  void clear() {
    buffer_.clear(contract_);
    counters_ = {};
  }

  template <class Sink>
  Drop draw(const spec::Triangle& triangle, Sink&& sink);
  Drop draw(const spec::Triangle& triangle);

 private:
  template <class Sink>
  void test_and_write(const spec::Stamp& stamp, const spec::Fragment& fragment, Sink&& sink);

  spec::Contract contract_;
  spec::FrameState frame_;
  TileRows rows_;
  FrameBuffer buffer_;
  FrameCounters counters_;
};

template <class Sink>
Drop Renderer::draw(const spec::Triangle& triangle, Sink&& sink) {
  struct Writer {
    Renderer& to;
    Sink& sink;
    void prim(const spec::SetupPrim& prim) { sink.prim(prim); }
    void stamp(const spec::Stamp& stamp) {
      sink.stamp(stamp);
      to.buffer_.count_hits(to.contract_, stamp);
    }
    void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
      sink.fragment(stamp, fragment);
      to.test_and_write(stamp, fragment, sink);
    }
  };
  return draw_triangle(contract_, frame_, rows_, triangle, &counters_, Writer{*this, sink});
}

template <class Sink>
void Renderer::test_and_write(const spec::Stamp& stamp, const spec::Fragment& fragment,
                              Sink&& sink) {
  uint32_t passed = stamp.mask;
  const bool test = frame_.depth != spec::DepthFunc::kOff;
  if (test) {
    const auto stored = buffer_.read(contract_, stamp.x, stamp.y, stamp.mask);
    passed = depth_test(contract_, frame_.depth, stamp.mask, fragment.z, stored.z);
  }
  if (passed == 0) return;
  counters_.passed += static_cast<uint64_t>(__builtin_popcount(passed));
  if (test) {
    const auto write = depth_write(contract_, stamp, fragment, passed);
    sink.depth(write);
    buffer_.write(contract_, write);
  }
  const auto write = color_write(contract_, stamp, fragment, passed);
  sink.color(write);
  buffer_.write(contract_, write);
}

}  // namespace pineda::core
