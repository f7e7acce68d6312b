// Every width of a design, derived once, with its reason. Nothing else in the project holds one.
#pragma once

#include "model/spec/design.h"
#include "model/spec/fixed.h"

namespace pineda::spec {

/// Depth enters with this many bits below one code: UQ<depth_bits>.8.
inline constexpr int kDepthInputFractionBits = 8;

/// Attribute planes and depth planes carry a sign and one bit of head room: at a covered sample the
/// exact value lies in [0, 2^n - 1] and the error is far below one code, so n + 2 bits cannot
/// alias.
inline constexpr int kPlaneHeadBits = 2;

/// Triangle number that travels with every token in simulation (1 bit in synthesis).
inline constexpr int kTriangleIdBits = 32;

/// Array bounds of the C++ structs; a design may use less.
inline constexpr int kMaxAttributes = 16;
inline constexpr int kMaxLanes = 16;

/// Bits of the quotient that restoring division finds in a cycle.
constexpr int reciprocal_radix_bits(const Design& d) {
  return d.reciprocal_scheme == ReciprocalScheme::kRestoring4 ? 2 : 1;
}

/// Cycles from the doubled area to its reciprocal: one to align, then one for the ROM and two a
/// Newton step; or three for coefficients, products and sum; or one for the quotient's first bit
/// and one for each digit of the k bits behind it.
constexpr int reciprocal_cycles(const Design& d) {
  switch (d.reciprocal_scheme) {
    case ReciprocalScheme::kNewton:
      return 2 + 2 * d.reciprocal_newton_steps;
    case ReciprocalScheme::kQuadratic:
      return 4;
    case ReciprocalScheme::kRestoring2:
    case ReciprocalScheme::kRestoring4:
      return 2 + (d.reciprocal_bits + reciprocal_radix_bits(d) - 1) / reciprocal_radix_bits(d);
    case ReciprocalScheme::kNone:
      break;
  }
  return 0;
}

/// Widths in bits, unless the name says otherwise.
struct Widths {
  int coord;         // x, y: sQ<guard>.<S> px
  int edge_coeff;    // a, b: differences of two coordinates, one bit more; |a| <= 2^(guard+1+S) - 1
  int area2;         // doubled area and E: see below
  int edge;          // E' = (E - bias) >> S at any sample of the guard band
  int tile_edge;     // E' of an edge that cuts the tile, anywhere inside that tile
  int area2_length;  // holds bit_length(area2), the exponent of the reciprocal
  int depth_in;      // UQ<depth_bits>.8
  int depth_numerator;   // gradient numerator of depth
  int attr_numerator;    // gradient numerator of an attribute
  int depth_plane;       // gradient, reference and accumulator of depth: s<depth_bits+2>.F, wraps
  int attr_plane;        // the same for an attribute: s<attribute_bits+2>.F, wraps
  int depth_tile_plane;  // the same inside a tile: F' fraction bits
  int attr_tile_plane;
  int frame_size;             // width, height: 1 .. 2^guard px
  int pixel;                  // pixel index inside a frame
  int tile_index;             // tile column or row
  int stamp_x;                // stamp column: the address of the depth and colour memories
  int stamp_y;                // stamp row
  int lanes;                  // samples of a stamp (a count, not a width)
  int inflight_stamps;        // stamps between read issued and write accepted (a count)
  int setup_planes_step;      // step of setup in which the first plane starts
  int setup_interval_cycles;  // a triangle every so many cycles
};

constexpr Widths widths(const Design& d) {
  Widths w{};
  const int span = d.guard_bits + 1 + d.subpixel_bits;  // the guard band's side is 2^span subpixels
  w.coord = span;
  w.edge_coeff = span + 1;
  // |E(p)| is the doubled area of a triangle inside the guard band's square, so at most side^2:
  // 2*span bits and a sign, one bit below the naive sum of two products. Every partial sum while
  // walking is itself an E, so nothing can overflow on the way.
  w.area2 = 2 * span + 1;
  // Samples are a whole pixel apart: the low S bits of E - bias never change and carry no sign.
  w.edge = w.area2 - d.subpixel_bits;
  // An edge that neither rejects nor accepts a tile of T has |E'| <= (T-1)(|a|+|b|) inside it.
  w.tile_edge = 1 + ceil_log2(2 * ((uint64_t{1} << d.tile_log2) - 1)) + span;
  w.area2_length = bit_length(2 * static_cast<uint64_t>(span));
  w.depth_in = d.depth_bits + kDepthInputFractionBits;
  // dz1*dy2 - dz2*dy1 is the doubled area of a triangle in a box of 2^depth_in by 2^span.
  w.depth_numerator = 1 + w.depth_in + span;
  w.attr_numerator = 1 + d.attribute_bits + span;
  w.depth_plane = d.depth_bits + kPlaneHeadBits + d.gradient_fraction_bits;
  w.attr_plane = d.attribute_bits + kPlaneHeadBits + d.gradient_fraction_bits;
  w.depth_tile_plane = d.depth_bits + kPlaneHeadBits + d.tile_fraction_bits;
  w.attr_tile_plane = d.attribute_bits + kPlaneHeadBits + d.tile_fraction_bits;
  // A frame lies in [0, 2^guard) px, inside the guard band.
  w.frame_size = d.guard_bits + 1;
  w.pixel = d.guard_bits;
  w.tile_index = d.guard_bits - d.tile_log2;
  w.stamp_x = d.guard_bits - d.stamp_width_log2;
  w.stamp_y = d.guard_bits - d.stamp_height_log2;
  w.lanes = 1 << (d.stamp_width_log2 + d.stamp_height_log2);
  // Full rate at the longest latency: request to response, and the cycles from the response to the
  // accepted write (compare, write) with room for the slot to be reused.
  w.inflight_stamps = d.max_depth_latency_cycles + 8;
  // The first plane takes the reciprocal 3 cycles after its start; the reciprocal starts in step 5.
  // No plane can start before the differences that step 5 writes.
  const int reciprocal_ready = 5 + reciprocal_cycles(d) - 3;
  w.setup_planes_step = reciprocal_ready > 6 ? reciprocal_ready : 6;
  // The last plane reads the triangle's differences 5 cycles after its start, and the next triangle
  // writes them in its step 5; the steps themselves take 10 cycles.
  const int planes_done = w.setup_planes_step + d.attributes;
  w.setup_interval_cycles = planes_done > 10 ? planes_done : 10;
  return w;
}

/// A design with its widths: what every unit takes.
struct Contract {
  Design design;
  Widths width;
};

constexpr Contract contract(const Design& design) { return {design, widths(design)}; }

// The table of the default design, as in the documentation; a change here is a changed contract.
inline constexpr Widths kHighTileWidths = widths(kHighTile);
static_assert(kHighTileWidths.coord == 23 && kHighTileWidths.edge_coeff == 24);
static_assert(kHighTileWidths.area2 == 47 && kHighTileWidths.edge == 39);
static_assert(kHighTileWidths.tile_edge == 28 && kHighTileWidths.area2_length == 6);
static_assert(kHighTileWidths.depth_numerator == 56 && kHighTileWidths.attr_numerator == 32);
static_assert(kHighTileWidths.depth_plane == 44 && kHighTileWidths.attr_plane == 28);
static_assert(kHighTileWidths.depth_tile_plane == 34 && kHighTileWidths.attr_tile_plane == 18);

}  // namespace pineda::spec
