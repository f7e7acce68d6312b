// Derives all widths of a design, with reasons. No width is defined anywhere else in the project.
#pragma once

#include "model/spec/fixed.h"
#include "model/spec/parameters.h"

namespace pineda::spec {

/// Fraction bits of a vertex's depth: UQ<depth_bits>.8 codes.
inline constexpr int kDepthInputFractionBits = 8;

/// Attribute planes and depth planes carry a sign and one bit of head room: at a covered sample the
/// exact value lies in [0, 2^n - 1] and the error is far below one code, so n + 2 bits cannot
/// alias.
inline constexpr int kPlaneHeadBits = 2;

/// Depth bias: fraction bits of the gradient's magnitude and of the slope factor. The bias, their
/// product, has twice as many.
inline constexpr int kBiasFactorFractionBits = 8;
inline constexpr int kBiasFractionBits = 2 * kBiasFactorFractionBits;
inline constexpr int kBiasSlopeBits = 16;  // sQ7.8

/// Hierarchical z: a gradient of 2^n or more, in units of 2^-8 codes/px, is steep. With smaller
/// ones a plane that is in range at one sample of a tile leaves the range by less than half of it
/// at all others, so it cannot have wrapped:
/// 2(T - 1) * 2^(depth_bits - log2 T - 2) < 2^(depth_bits - 1).
constexpr int steep_log2(const Design& d) {
  return d.depth_bits - d.tile_log2 - 2 + kBiasFactorFractionBits;
}

/// Perspective: a vertex's weight at a sample is U1.24, computed from products E/w of 26 bits. The
/// two extra bits keep the truncation error of the products below the rounding error of the weight.
inline constexpr int kWeightFractionBits = 24;
inline constexpr int kWeightProductBits = kWeightFractionBits + 2;
/// Width of a vertex's inverse_w_shift: the exponent of 1/w below the greatest one of the triangle.
/// w is a normal float, so 8 bits hold it.
inline constexpr int kInverseWShiftBits = 8;

/// Triangle number that travels with every token in simulation (1 bit in synthesis).
inline constexpr int kTriangleIdBits = 32;

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
  int value;           // input of the widest plane: z if there is depth, else an attribute
  int value_fraction;  // its fraction bits
  int numerator;       // its gradient numerator
  int plane;           // its gradients and reference
  int setup_factor_a;  // first factor of serial setup's multiplier
  int setup_factor_b;  // second factor
  int bias_constant;   // depth codes: sign and depth_bits
  int bias_magnitude;  // max(|dz/dx|, |dz/dy|): UQ<depth_bits+3>.8, saturated
  int depth_bias;      // sQ<depth_bits+1>.16, saturated: beyond it every code is clamped anyway
  int frame_size;      // width, height: 1 .. 2^guard px
  int pixel;           // pixel index inside a frame
  int tile_index;      // tile column or row
  int stamp_x;         // stamp column: the address of the depth and colour memories
  int stamp_y;         // stamp row
  int stamp_column;    // the same inside a tile; 1 where it is always 0
  int stamp_row;
  int lanes;                      // samples of a stamp (a count, not a width)
  int tested_stamps_log2;         // stamps whose coverage is found in one cycle
  int inflight_stamps;            // stamps between read issued and write accepted (a count)
  int setup_planes_step;          // step of setup in which the first plane starts
  int setup_interval_cycles;      // from an accepted triangle to the next one
  int setup_drop_cycles;          // the same after a dropped triangle
  int setup_drop_latency_cycles;  // from accepting a triangle to having dropped it
  int setup_latency_cycles;       // from accepting a triangle to offering its output
  int attribute_cycles;  // from a stamp that passed the depth test to its colour write offered
};

/// A triangle every so many cycles that each shared multiplier has made its products, two for the
/// area and four for the edges, or has taken its slots of planes: depth takes two, an attribute one;
/// and that the reciprocal is free again.
constexpr void stepped_setup_cycles(const Design& d, Widths* w) {
  const int planes = plane_count(d);
  const int slots = planes + (d.depth_test ? 1 : 0);
  int interval = 6;
  if (planes > 0 && slots > interval) interval = slots;
  if (planes > 0 && reciprocal_cycles(d) > interval) interval = reciprocal_cycles(d);
  w->setup_interval_cycles = interval;
  w->setup_drop_cycles = w->setup_drop_latency_cycles = 6;  // known in step 5
  // Planes start from the second register of the triangle, written in step interval + 5.
  w->setup_planes_step = interval + 6;
  // Edges are written in step 2 * interval + 9 or later, a plane 9 steps after its last slot starts.
  const int edges = 2 * interval + 10;
  const int last_plane = planes > 0 ? w->setup_planes_step + slots + 9 : 0;
  w->setup_latency_cycles = last_plane > edges ? last_plane : edges;
  // No triangle is taken in the step in which one is offered: that shall not be its turn.
  if (w->setup_latency_cycles % interval == 0) ++w->setup_latency_cycles;
}

/// One triangle a cycle. All planes start together. A product takes `extra` cycles more than one: those
/// of the area come before the drop is known, those of the edges before these are complete, and a
/// plane needs three, one after the other.
constexpr void pipelined_setup_cycles(const Design& d, Widths* w) {
  const int extra = multiplier_stages(d) - 1;
  w->setup_interval_cycles = w->setup_drop_cycles = 1;
  w->setup_drop_latency_cycles = 5 + extra;
  // The reciprocal starts in step 5 + extra. A plane takes it 3 + extra cycles after its own start, in
  // step 6 + extra at the earliest, when differences are there.
  const int reciprocal_ready = 3 + reciprocal_cycles(d);
  w->setup_planes_step = reciprocal_ready > 6 + extra ? reciprocal_ready : 6 + extra;
  const int edges = 9 + 2 * extra;
  const int planes = plane_count(d) > 0 ? w->setup_planes_step + 8 + 3 * extra : 0;
  w->setup_latency_cycles = planes > edges ? planes : edges;
}

/// One product a cycle: two for the area, four for the edges in steps 5 to 8, those of the
/// reciprocal, eight for each plane, and one for the depth bias.
constexpr void serial_setup_cycles(const Design& d, Widths* w) {
  w->setup_planes_step = 9 + scheme_of(d).serial_setup_steps(d);
  const int products = 8 * plane_count(d) + (d.depth_test ? 1 : 0);
  // The last product is used one step later; edges are written in step 10.
  const int last = plane_count(d) > 0 ? w->setup_planes_step + products : 10;
  w->setup_latency_cycles = last + 1;
  w->setup_interval_cycles = last + 2;  // a triangle is taken when the output has been
  w->setup_drop_cycles = w->setup_drop_latency_cycles = 5;  // known in step 4
  // Factors, all signed: edges multiply coordinate differences; planes multiply numerators by the
  // mantissa, and gradients by offsets (coordinate differences); the reciprocal has UQ0.(k+2).
  w->setup_factor_a = w->setup_factor_b = w->edge_coeff;
  if (plane_count(d) == 0) return;
  const int wide_plane = w->plane + d.subpixel_bits;
  const int reciprocal = d.reciprocal_bits + 3;
  for (const int bits : {w->numerator, wide_plane, reciprocal}) {
    if (bits > w->setup_factor_a) w->setup_factor_a = bits;
  }
  for (const int bits : {reciprocal, d.depth_test ? kBiasSlopeBits : 0}) {
    if (bits > w->setup_factor_b) w->setup_factor_b = bits;
  }
}

constexpr void setup_cycles(const Design& d, Widths* w) {
  switch (d.setup_style) {
    case SetupStyle::kStepped:
      return stepped_setup_cycles(d, w);
    case SetupStyle::kPipelined:
      return pipelined_setup_cycles(d, w);
    case SetupStyle::kSerial:
      return serial_setup_cycles(d, w);
  }
}

constexpr Widths widths(const Design& design) {
  const Design d = tamed(design);
  Widths w{};
  const int span = d.guard_bits + 1 + d.subpixel_bits;  // the guard band's side is 2^span subpixels
  w.coord = span;
  w.edge_coeff = span + 1;
  // |E(p)| is the doubled area of a triangle inside the guard band's square, so at most side^2:
  // 2*span bits and a sign, one bit below the naive sum of two products. Every partial sum while
  // walking is itself an E, so nothing can overflow on the way.
  w.area2 = 2 * span + 1;
  // Samples are whole pixels apart, so the low S bits of E - bias are the same at all of them and
  // do not affect the sign.
  w.edge = w.area2 - d.subpixel_bits;
  // An edge that neither rejects nor accepts a tile of T has |E'| <= (T-1)(|a|+|b|) inside it.
  // With perspective E itself is needed at each sample, so edges are not narrowed.
  w.tile_edge =
      d.perspective ? w.edge : 1 + ceil_log2(2 * ((uint64_t{1} << d.tile_log2) - 1)) + span;
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
  w.stamp_column = d.tile_log2 > d.stamp_width_log2 ? d.tile_log2 - d.stamp_width_log2 : 1;
  w.stamp_row = d.tile_log2 > d.stamp_height_log2 ? d.tile_log2 - d.stamp_height_log2 : 1;
  w.lanes = 1 << (d.stamp_width_log2 + d.stamp_height_log2);
  const int row_log2 = d.tile_log2 - d.stamp_width_log2;
  w.tested_stamps_log2 = d.tested_stamps_log2 < row_log2 ? d.tested_stamps_log2 : row_log2;
  // For one stamp a cycle at the greatest latency: a stamp retires the greater of 5 and latency + 2
  // cycles after its read, and its slot is free a cycle later. One more, so that a write can wait.
  w.inflight_stamps = (d.max_depth_latency_cycles > 3 ? d.max_depth_latency_cycles : 3) + 4;
  w.bias_constant = d.depth_bits + 1;
  w.bias_magnitude = d.depth_bits + 3 + kBiasFactorFractionBits;
  w.depth_bias = d.depth_bits + 2 + kBiasFractionBits;
  // An attribute gets one fraction bit, always 0: the RTL truncates gradients one bit before the
  // rounding position, so their shift must be at least 1.
  const int attr_fraction = 1;
  w.value = d.depth_test ? w.depth_in : d.attribute_bits + attr_fraction;
  w.value_fraction = d.depth_test ? kDepthInputFractionBits : attr_fraction;
  w.numerator = d.depth_test ? w.depth_numerator : w.attr_numerator + attr_fraction;
  w.plane = d.depth_test ? w.depth_plane : w.attr_plane;
  setup_cycles(d, &w);
  // Affine: one stage. Perspective: one for E, two for alignment, one each for the sum of the
  // products, for weights and for attributes; a product before alignment, before weights and before
  // attributes; and the reciprocal of the sum.
  w.attribute_cycles = d.attributes == 0 ? 0 : 1;
  if (d.perspective) {
    w.attribute_cycles = 6 + 3 * multiplier_stages(d) + pipelined_reciprocal_cycles(d);
  }
  return w;
}

/// A design with its widths, as every unit takes it. The design is tamed(): unused parameters are
/// clamped.
struct Contract {
  Design design;
  Widths width;
};

constexpr Contract contract(const Design& design) { return {tamed(design), widths(design)}; }

// The widths of the default design, as documented: changing one changes the bits of the contract.
inline constexpr Widths kHighTileWidths = widths(kHighTile);
static_assert(kHighTileWidths.coord == 23 && kHighTileWidths.edge_coeff == 24);
static_assert(kHighTileWidths.area2 == 47 && kHighTileWidths.edge == 39);
static_assert(kHighTileWidths.tile_edge == 28 && kHighTileWidths.area2_length == 6);
static_assert(kHighTileWidths.depth_numerator == 56 && kHighTileWidths.attr_numerator == 32);
static_assert(kHighTileWidths.depth_plane == 44 && kHighTileWidths.attr_plane == 28);
static_assert(kHighTileWidths.depth_tile_plane == 34 && kHighTileWidths.attr_tile_plane == 18);

}  // namespace pineda::spec
