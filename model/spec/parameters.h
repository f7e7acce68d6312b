// The table of a design's parameters, used by design files, range checks, `pineda designs`,
// comparisons of designs, and docs/designs.md. A new parameter needs a member of Design and a row
// here.
#pragma once

#include <algorithm>
#include <string>
#include <variant>

#include "model/spec/reciprocal/schemes.h"

namespace pineda::spec {

/// One end of a range: a number, or a function of the design's other parameters.
struct Limit {
  int number;
  const char* text = "";  // formula in other parameters' keys; empty: `number` is the limit
  int (*of_design)(const Design&) = nullptr;

  constexpr bool is_number() const { return *text == '\0'; }
  constexpr int operator()(const Design& d) const { return is_number() ? number : of_design(d); }
};

/// A whole number from `low` to `high`, both in the member's unit.
struct Number {
  int Design::*member;
  Limit low;
  Limit high;
  bool is_log2 = false;  // the key's value is 2^member
};

/// A parameter's member in Design, and its type.
using Member =
    std::variant<Number, bool Design::*, ReciprocalScheme Design::*, SetupStyle Design::*>;

struct Parameter {
  const char* key;  // in a design file
  Member member;
  /// Whether a design uses it. An unused number may have any value.
  bool (*used)(const Design&);
  const char* unit;  // of the key's value
  const char* meaning;
  /// Ranges are checked in rounds 0, 1, ..., and within a round in the order of the rows. A
  /// parameter is checked before those whose range depends on it.
  int round = 0;
  /// Whether `pineda designs` prints it for a design; null: if the design uses it.
  bool (*listed)(const Design&) = nullptr;
};

/// Predicates for Parameter::used and Parameter::listed.
namespace having {
constexpr bool anything(const Design&) { return true; }
constexpr bool depth(const Design& d) { return d.depth_test; }
constexpr bool perspective(const Design& d) { return d.perspective; }
constexpr bool reciprocal(const Design& d) { return has_reciprocal(d); }
constexpr bool reciprocal_or_remainders(const Design& d) {
  return has_reciprocal(d) || d.reciprocal_scheme == ReciprocalScheme::kNone;
}
constexpr bool rom(const Design& d) { return has_rom(d); }
constexpr bool newton_steps(const Design& d) { return scheme_of(d).has_newton_steps; }
constexpr bool hierarchical_z(const Design& d) { return d.hierarchical_z; }
constexpr bool pipelined_products(const Design& d) { return has_pipelined_products(d); }
}  // namespace having

/// Upper limits that depend on other parameters.
namespace most {
constexpr int flat_attributes(const Design& d) { return kMaxAttributes - d.attributes; }
constexpr int tile_fraction_bits(const Design& d) { return d.gradient_fraction_bits; }
constexpr int tile_log2(const Design& d) { return std::min(6, d.guard_bits - 1); }
constexpr int depth_latency_cycles(const Design& d) { return d.max_depth_latency_cycles; }
}  // namespace most

/// The table, in the order of a design file.
inline constexpr Parameter kParameters[] = {
    {"reciprocal_scheme", &Design::reciprocal_scheme, having::anything, "",
     "how the reciprocal of the doubled area is found; `none` is the exact functional model", 0,
     having::reciprocal_or_remainders},
    {"setup_style", &Design::setup_style, having::anything, "",
     "six cycles a triangle or more, by shared multipliers; a triangle a cycle; one multiplier"},
    {"multiplier_stages", Number{&Design::multiplier_stages, {1}, {2}}, having::pipelined_products,
     "cycles", "of a product where one starts every cycle: `pipelined`, `perspective`"},
    {"depth_test", &Design::depth_test, having::anything, "",
     "false: no depth port, no table of stamps in flight, no queue"},
    {"perspective", &Design::perspective, having::anything, "", "attributes are corrected by 1/w"},
    {"hierarchical_z", &Design::hierarchical_z, having::anything, "",
     "a tile behind everything stored there is not walked: see below", 0, having::depth},
    {"subpixel_bits", Number{&Design::subpixel_bits, {4}, {12}}, having::anything, "bits",
     "S: positions are multiples of 2^-S px"},
    {"guard_bits", Number{&Design::guard_bits, {4}, {14}}, having::anything, "bits",
     "vertices and frames lie within 2^n px; beyond it vertices saturate and are counted"},
    {"depth_bits", Number{&Design::depth_bits, {16}, {32}}, having::depth, "bits", "a depth code"},
    {"attributes", Number{&Design::attributes, {0}, {kMaxAttributes}}, having::anything, "",
     "interpolated; they come first"},
    {"flat_attributes",
     Number{&Design::flat_attributes, {0}, {0, "16 - `attributes`", most::flat_attributes}},
     having::anything, "", "those of a triangle's first vertex"},
    {"attribute_bits", Number{&Design::attribute_bits, {1}, {16}}, having::anything, "bits",
     "each attribute"},
    {"inverse_w_bits", Number{&Design::inverse_w_bits, {8}, {24}}, having::perspective, "bits",
     "mantissa of a vertex's 1/w"},
    {"reciprocal_lut_bits", Number{&Design::reciprocal_lut_bits, {4}, {12}}, having::rom, "bits",
     "index of the ROM: `newton`, `quadratic`", 0, having::reciprocal},
    {"reciprocal_newton_steps", Number{&Design::reciprocal_newton_steps, {0}, {2}},
     having::newton_steps, "", "steps behind the ROM: `newton`", 0, having::reciprocal},
    {"reciprocal_bits", Number{&Design::reciprocal_bits, {12}, {32}}, having::reciprocal, "bits",
     "k: mantissa of the reciprocal"},
    {"gradient_fraction_bits", Number{&Design::gradient_fraction_bits, {8}, {20}},
     having::reciprocal, "bits", "F: gradients and references"},
    {"tile_fraction_bits",
     Number{&Design::tile_fraction_bits,
            {1},
            {0, "`gradient_fraction_bits`", most::tile_fraction_bits}},
     having::reciprocal, "bits", "F': the same inside a tile"},
    {"tile_px",
     Number{&Design::tile_log2, {2}, {0, "64, and below 2^`guard_bits`", most::tile_log2}, true},
     having::anything, "px", "side of a tile, tested in one cycle"},
    {"stamp_width_px", Number{&Design::stamp_width_log2, {0}, {2}, true}, having::anything, "px",
     "columns of samples in one cycle", 1},
    {"stamp_height_px", Number{&Design::stamp_height_log2, {0}, {2}, true}, having::anything, "px",
     "rows of samples in one cycle", 1},
    {"tested_stamps", Number{&Design::tested_stamps_log2, {0}, {6}, true}, having::anything, "",
     "stamps side by side whose coverage is found in one cycle, at most a row of the tile"},
    {"hierarchical_z_bits", Number{&Design::hierarchical_z_bits, {4}, {16}}, having::hierarchical_z,
     "bits", "of a depth, the top ones"},
    {"hierarchical_z_tiles", Number{&Design::hierarchical_z_tiles, {1}, {1 << 20}},
     having::hierarchical_z, "tiles", "of a frame, row by row, the first ones"},
    {"hierarchical_z_delay_cycles", Number{&Design::hierarchical_z_delay_cycles, {1}, {64}},
     having::hierarchical_z, "cycles", "from a depth write to the first test that sees it"},
    {"prim_fifo_depth", Number{&Design::prim_fifo_depth, {0}, {1024}}, having::anything, "",
     "triangles between setup and tile test"},
    {"tile_fifo_depth", Number{&Design::tile_fifo_depth, {0}, {1024}}, having::anything, "",
     "tiles between tile test and coverage"},
    {"stamp_fifo_depth", Number{&Design::stamp_fifo_depth, {1}, {1024}}, having::anything, "",
     "stamps between traversal and interpolation"},
    {"plane_slots", Number{&Design::plane_slots, {2}, {1024}}, having::anything, "",
     "tiles whose planes are kept for their stamps in flight"},
    {"depth_latency_cycles",
     Number{&Design::depth_latency_cycles,
            {1},
            {0, "`max_depth_latency_cycles`", most::depth_latency_cycles}},
     having::anything, "cycles", "the depth memory's, by default", 2, having::depth},
    {"max_depth_latency_cycles",
     Number{&Design::max_depth_latency_cycles, {1}, {kMaxDepthLatencyCycles}}, having::anything,
     "cycles", "sizes the table of stamps in flight, for a stamp a cycle at that latency", 1,
     having::depth},
};

/// The row of a key, or of a member that holds a number.
/// Errors   std::out_of_range: there is none.
const Parameter& parameter(const std::string& key);
const Parameter& parameter(int Design::*member);

/// Whether `pineda designs` prints the parameter for this design.
bool is_listed(const Parameter& parameter, const Design& design);

/// The parameter's value in the key's unit; for an enumeration its word.
std::variant<bool, int, std::string> value_of(const Parameter& parameter, const Design& design);

/// The same as a design file writes it.
std::string file_value(const Parameter& parameter, const Design& design);

/// The range for a person: "4 to 64", "true, false", or the words of an enumeration.
std::string range_text(const Parameter& parameter);

/// Why a used number is out of range, for the first one that is: "tile_px is 128, must be 4 to 64".
/// Empty if there is none.
std::string range_reason(const Design& design);

/// The same design with its unused numbers clamped to 0 .. their upper limit, so that computing
/// widths cannot overflow. A Contract always holds such a design.
constexpr Design tamed(Design d) {
  for (const Parameter& p : kParameters) {
    if (!std::holds_alternative<Number>(p.member) || p.used(d)) continue;
    const auto& number = std::get<Number>(p.member);
    int& value = d.*number.member;
    value = std::clamp(value, 0, std::max(number.high(d), 0));
  }
  return d;
}

}  // namespace pineda::spec
