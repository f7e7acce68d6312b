// The table of coverage: what is worth seeing at each unit, in bins.
#pragma once

#include <array>

#include "vectors/coverage/point.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// A triangle at setup, and what became of it.
struct SeenTriangle {
  SeenTriangle(const spec::Contract& contract, const spec::FrameState& frame,
               const spec::Triangle& triangle);

  bool kept() const { return drop == core::Drop::kNone; }
  /// Vertex i in canonical order.
  const spec::Vertex& vertex(size_t i) const { return triangle.v[order[i % 3]]; }
  /// E of edge i, without its bias, at a point in subpixels.
  int64_t edge(size_t i, int64_t x, int64_t y) const;

  const spec::Contract& contract;
  const spec::FrameState& frame;
  const spec::Triangle& triangle;
  spec::SetupPrim prim;  // if kept
  core::Drop drop;
  int64_t area2;                // positive when clockwise
  std::array<size_t, 3> order;  // canonical
  int x_low, x_high, y_low, y_high;
};

/// A triangle set up, once its tiles are walked.
struct SeenPrim {
  const spec::Contract& contract;
  const spec::SetupPrim& prim;
  int tiles_tested;
  int tiles_kept;
  int stamps;
};

/// A tile that was tested.
struct SeenTile {
  const spec::Contract& contract;
  const spec::SetupPrim& prim;
  const spec::Tile* tile;  // nullptr: rejected
};

/// A stamp that was sent.
struct SeenStamp {
  const spec::Contract& contract;
  const spec::Stamp& stamp;
};

/// A stamp at interpolation and depth test.
struct SeenFragment {
  const spec::Contract& contract;
  const spec::FrameState& frame;
  const spec::Stamp& stamp;
  const spec::Fragment& fragment;
  const spec::DepthData& stored;
  uint32_t passed;
  size_t since;  // stamps since the last one of the same address, itself counted; 0: there was none
};

/// The same where the stamps are given, and planes may be none of a triangle.
struct SeenGivenStamp : SeenFragment {};

/// What a case says beside its tokens.
struct SeenCase {
  const spec::Contract& contract;
  const PortStalls& ports;
};

/// A frame drawn.
struct SeenFrame {
  const spec::Contract& contract;
  const FrameCase& frame_case;
};

/// The rows for one kind of thing seen.
template <class Seen>
const std::vector<Point<Seen>>& points();
template <>
const std::vector<Point<SeenTriangle>>& points<SeenTriangle>();
template <>
const std::vector<Point<SeenPrim>>& points<SeenPrim>();
template <>
const std::vector<Point<SeenTile>>& points<SeenTile>();
template <>
const std::vector<Point<SeenStamp>>& points<SeenStamp>();
template <>
const std::vector<Point<SeenFragment>>& points<SeenFragment>();
template <>
const std::vector<Point<SeenGivenStamp>>& points<SeenGivenStamp>();
template <>
const std::vector<Point<SeenCase>>& points<SeenCase>();
template <>
const std::vector<Point<SeenFrame>>& points<SeenFrame>();

}  // namespace pineda::vectors
