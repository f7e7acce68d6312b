// A design point as data: all parameters that an architect chooses. Derived values are in widths.h.
#pragma once

#include <string>
#include <vector>

#include "model/spec/names.h"

namespace pineda::spec {

/// How setup divides by the doubled area. Each scheme is described in its file in reciprocal/.
enum class ReciprocalScheme {
  kNewton,      // ROM of 2^lut_bits entries, then 0 or more Newton steps
  kQuadratic,   // ROM of 2^lut_bits parabolas
  kRestoring2,  // restoring division, a bit a cycle
  kRestoring4,  // the same quotient, two bits a cycle
  kNone,        // no reciprocal: planes step by quotient and remainder and are never rounded
};

/// How setup shares its multipliers.
enum class SetupStyle {
  kStepped,    // nine multipliers, shared by edges and planes: six cycles or more
  kPipelined,  // every product has its own multiplier: a triangle a cycle
  kSerial,     // one multiplier for every product of a triangle
};

inline constexpr Name<SetupStyle> kSetupStyleNames[] = {
    {SetupStyle::kStepped, "stepped"},
    {SetupStyle::kPipelined, "pipelined"},
    {SetupStyle::kSerial, "serial"},
};
constexpr const auto& names(SetupStyle) { return kSetupStyleNames; }

/// The parameters of one rasterizer. Their keys, ranges and meanings are in parameters.h; widths()
/// in widths.h derives all widths from them.
/// A plain aggregate, so that named designs can be constexpr; others are read from files.
struct Design {
  const char* name = "high_tile";
  const char* summary = "default: error at the rounding limit, in-tile steps of 8 fraction bits";

  // Coordinates
  int subpixel_bits = 8;  // S: x, y are multiples of 2^-S px
  int guard_bits = 14;    // vertices lie in [-2^guard_bits, 2^guard_bits) px

  // Depth and attributes. Attributes are r, g, b, a, ...: first the interpolated ones, then the
  // flat ones, which all samples take from the triangle's first vertex.
  bool depth_test = true;  // off: no depth at all
  int depth_bits = 24;
  int attributes = 4;       // interpolated
  int flat_attributes = 0;  // constant over a triangle
  int attribute_bits = 8;
  bool perspective = false;  // interpolated attributes are corrected by 1/w
  int inverse_w_bits = 20;   // mantissa of 1/w at a vertex

  // Reciprocal of the doubled area
  ReciprocalScheme reciprocal_scheme = ReciprocalScheme::kNewton;
  int reciprocal_lut_bits = 7;      // newton, quadratic
  int reciprocal_newton_steps = 2;  // newton
  int reciprocal_bits = 30;         // k

  // Setup
  SetupStyle setup_style = SetupStyle::kStepped;
  int multiplier_stages = 1;  // cycles of a product, where one starts every cycle

  // Planes
  int gradient_fraction_bits = 18;  // F: gradients, references, steps from tile to tile
  int tile_fraction_bits = 8;       // F': steps inside a tile

  // Traversal
  int tile_log2 = 3;  // tiles of 2^tile_log2 px square
  int stamp_width_log2 = 1;
  int stamp_height_log2 = 1;
  int tested_stamps_log2 = 2;  // side by side, tested in one cycle; at most a row of the tile

  // Hierarchical z: a tile whose part of the triangle lies behind all stored depths is skipped
  bool hierarchical_z = false;
  int hierarchical_z_bits = 12;      // top bits of a depth that it stores and compares
  int hierarchical_z_tiles = 32768;  // it covers the first tiles of a frame, in raster order
  int hierarchical_z_delay_cycles =
      4;  // from an accepted depth write to the first tile test that sees it

  // Buffers
  int prim_fifo_depth = 0;            // setup -> traversal; 0: none, a wire
  int tile_fifo_depth = 1;            // inside traversal: tile test -> coverage; 0: none
  int stamp_fifo_depth = 4;           // traversal -> interpolation
  int depth_latency_cycles = 8;       // default of the depth memory, request accepted -> response
  int plane_slots = 6;                // tiles whose planes are kept for stamps in flight
  int max_depth_latency_cycles = 16;  // greatest latency with a full rate of one stamp a cycle
};

inline constexpr Design kHighTile{};

/// Array bounds of the C++ structs; a design may use less.
inline constexpr int kMaxAttributes = 16;
inline constexpr int kMaxLanes = 16;
/// The longest latency of a depth memory that any design draws with, at its full rate or slower.
inline constexpr int kMaxDepthLatencyCycles = 1024;

/// Values that setup makes planes of: depth and affine attributes.
constexpr int plane_count(const Design& d) {
  return (d.depth_test ? 1 : 0) + (d.perspective ? 0 : d.attributes);
}

/// Whether the design computes reciprocals: of the doubled area for planes, and of the sum of the
/// weight products for perspective.
constexpr bool has_reciprocal(const Design& d) {
  return d.reciprocal_scheme != ReciprocalScheme::kNone && (plane_count(d) > 0 || d.perspective);
}

/// Whether products start every cycle anywhere in the design.
constexpr bool has_pipelined_products(const Design& d) {
  return d.setup_style == SetupStyle::kPipelined || d.perspective;
}
/// Cycles of such a product.
constexpr int multiplier_stages(const Design& d) {
  return has_pipelined_products(d) ? d.multiplier_stages : 1;
}

/// Values written for a sample: interpolated attributes, then flat ones.
constexpr int channels(const Design& d) { return d.attributes + d.flat_attributes; }

/// The design points this build knows by name.
const std::vector<Design>& designs();

/// The named design, or nullptr.
const Design* find_design(const std::string& name);

/// Empty if the design can be built, else the reason why not, in one line.
std::string invalid_reason(const Design& design);

/// Empty if this version can time the design, else what it lacks, in one line.
std::string no_cycles_reason(const Design& design);

/// Empty if this version has RTL of the design, else what it lacks, in one line.
std::string no_rtl_reason(const Design& design);

}  // namespace pineda::spec
