#include "model/spec/package.h"

#include <fmt/format.h>

#include <cctype>

#include "model/spec/fields.h"

namespace pineda::spec {
namespace {

using Constants = std::vector<Constant>;

void append(const Constants& more, Constants* all) {
  all->insert(all->end(), more.begin(), more.end());
}

Constants depth_constants(const Contract& c) {
  const Design& d = c.design;
  const Widths& w = c.width;
  if (!d.depth_test) return {};
  return {
      {"DEPTH_BITS", d.depth_bits, "a depth code"},
      {"DEPTH_INPUT_FRACTION_BITS", kDepthInputFractionBits, "fraction of a vertex's z"},
      {"DEPTH_IN_BITS", w.depth_in, "a vertex's z"},
      {"DEPTH_NUMERATOR_BITS", w.depth_numerator, "gradient numerator of z"},
      {"DEPTH_PLANE_BITS", w.depth_plane, "gradient, reference, accumulator of z"},
      {"DEPTH_TILE_PLANE_BITS", w.depth_tile_plane, "the same inside a tile"},
      {"BIAS_FACTOR_FRACTION_BITS", kBiasFactorFractionBits, "gradient's magnitude, slope factor"},
      {"BIAS_MAGNITUDE_BITS", w.bias_magnitude, "the magnitude, saturated"},
      {"BIAS_SLOPE_BITS", kBiasSlopeBits, "the slope factor"},
      {"BIAS_CONSTANT_BITS", w.bias_constant, "the constant"},
      {"BIAS_FRACTION_BITS", kBiasFractionBits, "fraction of the bias"},
      {"DEPTH_BIAS_BITS", w.depth_bias, "the bias, saturated"},
      {"INFLIGHT_STAMPS", w.inflight_stamps, "stamps between read issued and write accepted"},
  };
}

Constants hierarchical_z_constants(const Design& d) {
  if (!d.hierarchical_z) return {};
  return {
      {"HIERARCHICAL_Z_BITS", d.hierarchical_z_bits, "of a depth, the top ones"},
      {"HIERARCHICAL_Z_TILES", d.hierarchical_z_tiles, "of a frame, row by row, the first ones"},
      {"HIERARCHICAL_Z_STEEP_LOG2", steep_log2(d), "a gradient that is too steep, 2^-8 codes/px"},
      {"HIERARCHICAL_Z_DELAY_CYCLES", d.hierarchical_z_delay_cycles, "from a write to its effect"},
  };
}

Constants attribute_constants(const Contract& c) {
  const Design& d = c.design;
  const Widths& w = c.width;
  Constants all;
  if (d.attributes > 0) all.push_back({"ATTRIBUTES", d.attributes, "interpolated attributes"});
  if (d.flat_attributes > 0) {
    all.push_back({"FLAT_ATTRIBUTES", d.flat_attributes, "attributes constant over a triangle"});
  }
  if (channels(d) > 0) all.push_back({"ATTR_BITS", d.attribute_bits, "one attribute"});
  if (d.attributes > 0) {
    all.push_back({"ATTRIBUTE_CYCLES", w.attribute_cycles, "from the depth test to the colours"});
  }
  if (d.perspective) {
    append({{"INVERSE_W_BITS", d.inverse_w_bits, "mantissa of 1/w"},
            {"INVERSE_W_SHIFT_BITS", kInverseWShiftBits, "its exponent, below the greatest one"},
            {"WEIGHT_FRACTION_BITS", kWeightFractionBits, "a vertex's weight at a sample"},
            {"WEIGHT_PRODUCT_BITS", kWeightProductBits, "E/w, in units that its sample's share"}},
           &all);
  } else if (d.attributes > 0) {
    append({{"ATTR_NUMERATOR_BITS", w.attr_numerator, "gradient numerator of an attribute"},
            {"ATTR_PLANE_BITS", w.attr_plane, "gradient, reference, accumulator of an attribute"},
            {"ATTR_TILE_PLANE_BITS", w.attr_tile_plane, "the same inside a tile"}},
           &all);
  }
  return all;
}

// Constants of parts that a design does not have are left out, so that no module can use them by
// mistake.
Constants constants(const Contract& c) {
  const Design& d = c.design;
  const Widths& w = c.width;
  Constants all{
      {"SUBPIXEL_BITS", d.subpixel_bits, "S: x, y are multiples of 2^-S px"},
      {"COORD_BITS", w.coord, "x, y"},
      {"EDGE_COEFF_BITS", w.edge_coeff, "a, b"},
      {"AREA2_BITS", w.area2, "doubled area, E"},
      {"EDGE_BITS", w.edge, "E' = (E - bias) >> S"},
      {"TILE_EDGE_BITS", w.tile_edge, "E' of an edge that cuts the tile"},
      {"AREA2_LENGTH_BITS", w.area2_length, "bit length of the doubled area"},
  };
  append(depth_constants(c), &all);
  append(hierarchical_z_constants(d), &all);
  append(attribute_constants(c), &all);
  if (plane_count(d) > 0) {
    append({{"GRADIENT_FRACTION_BITS", d.gradient_fraction_bits, "F"},
            {"TILE_FRACTION_BITS", d.tile_fraction_bits, "F': inside a tile"},
            {"PLANES", plane_count(d), "depth, then affine attributes"},
            {"VALUE_BITS", w.value, "what a plane is made of: the widest"},
            {"VALUE_FRACTION_BITS", w.value_fraction, "its fraction"},
            {"NUMERATOR_BITS", w.numerator, "its gradient numerator"},
            {"PLANE_BITS", w.plane, "gradient, reference: the widest"},
            {"SETUP_PLANES_STEP", w.setup_planes_step, "step of setup in which the first starts"}},
           &all);
  }
  if (d.setup_style == SetupStyle::kSerial) {
    append({{"SETUP_FACTOR_A_BITS", w.setup_factor_a, "of setup's one multiplier"},
            {"SETUP_FACTOR_B_BITS", w.setup_factor_b, ""}},
           &all);
  }
  append({{"TILE_LOG2", d.tile_log2, "tile side, log2 px"},
          {"STAMP_WIDTH_LOG2", d.stamp_width_log2, "log2 px"},
          {"STAMP_HEIGHT_LOG2", d.stamp_height_log2, "log2 px"},
          {"LANES", w.lanes, "samples of a stamp"},
          {"TESTED_STAMPS_LOG2", w.tested_stamps_log2, "stamps whose coverage is found in a cycle"},
          {"FRAME_SIZE_BITS", w.frame_size, "width, height of a frame"},
          {"PIXEL_BITS", w.pixel, "pixel column or row"},
          {"TILE_INDEX_BITS", w.tile_index, "tile column or row"},
          {"STAMP_X_BITS", w.stamp_x, "stamp column"},
          {"STAMP_Y_BITS", w.stamp_y, "stamp row"},
          {"STAMP_COLUMN_BITS", w.stamp_column, "the same inside a tile; 1 where it is always 0"},
          {"STAMP_ROW_BITS", w.stamp_row, ""},
          {"SETUP_INTERVAL_CYCLES", w.setup_interval_cycles, "a triangle every so many cycles"},
          {"SETUP_LATENCY_CYCLES", w.setup_latency_cycles, "from a triangle to its primitive"},
          {"MULTIPLIER_STAGES", multiplier_stages(d), "of a product where one starts every cycle"},
          {"PRIM_FIFO_DEPTH", d.prim_fifo_depth, "setup -> traversal"},
          {"TILE_FIFO_DEPTH", d.tile_fifo_depth, "tile test -> coverage"},
          {"STAMP_FIFO_DEPTH", d.stamp_fifo_depth, "traversal -> interpolation"},
          {"PLANE_SLOTS", d.plane_slots, "tiles whose planes are kept for stamps in flight"}},
         &all);
  return all;
}

// The constants of the design's reciprocal scheme.
Constants reciprocal_constants(const Design& d) {
  if (!has_reciprocal(d)) return {};
  Constants all{{"RECIPROCAL_BITS", d.reciprocal_bits, "k: mantissa of a reciprocal"},
                {"RECIPROCAL_CYCLES", reciprocal_cycles(d), "from the doubled area to it"}};
  if (scheme_of(d).every_cycle) {
    all.push_back({"PIPELINED_RECIPROCAL_CYCLES", pipelined_reciprocal_cycles(d),
                   "the same where one starts every cycle"});
  }
  append(scheme_of(d).constants(d), &all);
  return all;
}

std::string upper(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::toupper(letter));
  return text;
}

// One macro for each part that the design has: RTL for other parts, ports included, must be
// excluded by `ifdef, since the package lacks their constants.
std::string macros_text(const Design& d) {
  std::string text = fmt::format("`define PINEDA_SETUP_{}\n", upper(name_of(d.setup_style)));
  const auto define = [&](bool built, const std::string& name) {
    if (built) text += fmt::format("`define PINEDA_{}\n", name);
  };
  define(has_reciprocal(d), std::string("RECIPROCAL_") + scheme_of(d).macro);
  define(d.depth_test, "DEPTH");
  define(d.hierarchical_z, "HIERARCHICAL_Z");
  define(plane_count(d) > 0, "PLANES");
  define(d.attributes > 0, "ATTRIBUTES");
  define(d.attributes > 0 && !d.perspective, "AFFINE");
  define(d.perspective, "PERSPECTIVE");
  define(d.flat_attributes > 0, "FLAT_ATTRIBUTES");
  return text;
}

std::string rom_entry_text(const std::vector<RomPart>& entry) {
  std::vector<std::string> parts;
  for (const RomPart& part : entry) parts.push_back(fmt::format("{}'d{}", part.bits, part.value));
  return parts.size() == 1 ? parts[0] : "{" + joined(parts, ", ", ", ") + "}";
}

// The reciprocal ROM as a SystemVerilog function; empty for a scheme without a ROM.
std::string reciprocal_rom_text(const Design& d) {
  if (!has_reciprocal(d) || !has_rom(d)) return {};
  const ReciprocalRom& rom = scheme_of(d).rom;
  std::string text = fmt::format(
      "  // {}\n  function automatic logic [RECIPROCAL_ROM_BITS-1:0] reciprocal_rom(\n"
      "      input logic [RECIPROCAL_LUT_BITS-1:0] index);\n    case (index)\n",
      rom.meaning(d));
  const int entries = 1 << d.reciprocal_lut_bits;
  for (int i = 0; i < entries; ++i) {
    const std::string label =
        i + 1 == entries ? "default" : fmt::format("{}'d{}", d.reciprocal_lut_bits, i);
    text += fmt::format("      {}: reciprocal_rom = {};\n", label, rom_entry_text(rom.entry(d, i)));
  }
  return text + "    endcase\n  endfunction\n\n";
}

std::string constant_text(const Constant& k) {
  return fmt::format("  localparam int unsigned {:<26}= {};{}{}\n", k.name, k.value,
                     *k.meaning != '\0' ? " // " : "", k.meaning);
}

/// A constant for each value of an enumeration.
template <class Value>
std::string codes_text(const std::string& prefix, int bits) {
  std::string text;
  for (const auto& row : names(Value{})) {
    text += fmt::format("  localparam logic [{}:0] {:<15}= {}'d{};\n", bits - 1,
                        prefix + "_" + upper(row.word), bits, static_cast<int>(row.value));
  }
  return text;
}

template <class T>
std::string struct_text(const std::vector<Field<T>>& table, const char* name) {
  std::string text = "  typedef struct packed {\n";
  int bits = packed_bits(table);
  for (const auto& f : table) {
    // The triangle number is only 1 bit wide in synthesis, so its width is a named constant.
    const bool is_id = std::string(f.name) == "id";
    const std::string range = is_id ? "[ID_BITS-1:0]" : fmt::format("[{}:0]", f.bits * f.count - 1);
    if (is_id) bits -= kTriangleIdBits;
    const bool sign = f.is_signed && f.count == 1;
    std::string format = format_name(f.is_signed, f.bits, f.fraction_bits, f.unit);
    if (f.count > 1) format += fmt::format(", {} of them, the first lowest", f.count);
    text += fmt::format("    logic {:<7}{:<16}{}; // {}\n", sign ? "signed" : "", range, f.name,
                        is_id ? "number of the triangle" : format);
  }
  const bool has_id = bits != packed_bits(table);
  return text + fmt::format("  }} {}_t;\n  localparam int unsigned {}_BITS = {}{};\n\n", name,
                            upper(name), has_id ? "ID_BITS + " : "", bits);
}

}  // namespace

std::string package_text(const Contract& c) {
  std::string text = fmt::format(
      "// Generated from model/spec for the design {}. Do not edit: change model/spec and run\n"
      "// `cmake --build build --target package`.\n"
      "{}package pineda_pkg;\n\n",
      c.design.name, macros_text(c.design));
  for (const auto& k : constants(c)) text += constant_text(k);
  for (const auto& k : reciprocal_constants(c.design)) text += constant_text(k);
  text += fmt::format(
      "\n  // The triangle number only travels in simulation.\n"
      "`ifdef SYNTHESIS\n  localparam int unsigned ID_BITS = 1;\n"
      "`else\n  localparam int unsigned ID_BITS = {};\n`endif\n\n",
      kTriangleIdBits);
  text += codes_text<Cull>("CULL", 2);
  if (c.design.attributes > 0) text += codes_text<Shade>("SHADE", 1);
  if (c.design.depth_test) text += codes_text<DepthFunc>("DEPTH", 4);
  text += "\n";
  for_each_struct(c,
                  [&](const auto& table, const char* name) { text += struct_text(table, name); });
  return text + reciprocal_rom_text(c.design) + "endpackage\n";
}

std::string loopback_text(const Contract& c) {
  std::string ports;
  std::string body;
  for_each_struct(c, [&](const auto& table, const std::string& name) {
    ports +=
        fmt::format("  input  pineda_pkg::{0}_t {0}_i,\n  output pineda_pkg::{0}_t {0}_o,\n", name);
    for (const auto& f : table) {
      const int bits = f.bits * f.count;
      ports += fmt::format("  input  logic [{0}:0] {1}_{2}_i,\n  output logic [{0}:0] {1}_{2}_o,\n",
                           bits - 1, name, f.name);
      body += fmt::format("  assign {0}_{1}_o = {0}_i.{1};\n  assign {0}_o.{1} = {0}_{1}_i;\n",
                          name, f.name);
    }
  });
  return fmt::format(
      "// Generated from model/spec for the design {}: every struct, field by field.\n"
      "module loopback (\n{}  input  logic clk_i\n);\n{}endmodule\n",
      c.design.name, ports, body);
}

std::string loopback_ports(const Contract& c) {
  std::string text;
  for_each_struct(c, [&](const auto& table, const std::string& name) {
    text += fmt::format("PORT({0}_i)\nPORT({0}_o)\n", name);
    for (const auto& f : table) {
      text += fmt::format("PORT({0}_{1}_i)\nPORT({0}_{1}_o)\n", name, f.name);
    }
  });
  return text;
}

uint64_t text_hash(const std::string& text, uint64_t before) {
  for (const unsigned char byte : text) before = (before ^ byte) * 0x100000001b3u;
  return before;
}

uint64_t package_hash(const Contract& c) { return text_hash(package_text(c)); }

uint64_t formats_hash(const Contract& c) {
  const Design& d = c.design;
  std::string text = fmt::format(
      "S{} k{} lut{} newton{} F{} f{} tile{} stamp{}x{}\n", d.subpixel_bits, d.reciprocal_bits,
      d.reciprocal_lut_bits, d.reciprocal_newton_steps, d.gradient_fraction_bits,
      d.tile_fraction_bits, d.tile_log2, d.stamp_width_log2, d.stamp_height_log2);
  if (d.reciprocal_scheme != ReciprocalScheme::kNewton) {
    text += fmt::format("{}\n", name_of(d.reciprocal_scheme));
  }
  for_each_struct(c, [&](const auto& table, const char* name) {
    text += fmt::format("{}\n", name);
    for (const auto& f : table) {
      text += fmt::format("{} {} {} {} {} {}\n", f.name, f.unit, f.is_signed, f.bits,
                          f.fraction_bits, f.count);
    }
  });
  return text_hash(text);
}

}  // namespace pineda::spec
