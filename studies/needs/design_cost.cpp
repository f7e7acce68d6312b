#include "studies/needs/design_cost.h"

#include "model/spec/fields.h"

namespace pineda::studies {
namespace {

using spec::Design;
using spec::Widths;

constexpr int64_t kRomShare = 8;  // bits of ROM or memory that count as one bit of logic

/// Products of a plane: two for each of two numerators, one for each gradient, and one for each
/// offset from the anchor.
int64_t plane_bits(const Design& d, const Widths& w, int64_t in, int64_t numerator, int64_t bits) {
  return 4 * (in + 1) * w.edge_coeff + 2 * numerator * d.reciprocal_bits +
         2 * (bits + d.subpixel_bits) * w.edge_coeff;
}

int64_t setup_bits(const Design& d, const Widths& w) {
  int64_t bits = int64_t{8} * w.edge_coeff * w.edge_coeff;
  if (!spec::has_reciprocal(d)) return bits;
  if (d.depth_test) bits += plane_bits(d, w, w.depth_in, w.depth_numerator, w.depth_plane);
  const int affine = d.perspective ? 0 : d.attributes;
  return bits + affine * plane_bits(d, w, d.attribute_bits, w.attr_numerator, w.attr_plane);
}

int64_t reciprocal_bits(const Design& d, const Widths& w) {
  if (!spec::has_reciprocal(d)) return 0;
  const int units = (spec::plane_count(d) > 0 ? 1 : 0) + (d.perspective ? w.lanes : 0);
  return units * (spec::scheme_of(d).logic_bits(d, w.area2) +
                  spec::reciprocal_rom_size_bits(d) / kRomShare);
}

int64_t interpolation_bits(const Design& d, const Widths& w) {
  int64_t lane = d.depth_test ? 2 * w.depth_tile_plane : 0;
  if (d.perspective) {
    // E/w of three vertices, two weights, two products for each attribute.
    lane += int64_t{3} * w.area2 * d.inverse_w_bits +
            int64_t{2} * spec::kWeightProductBits * d.reciprocal_bits +
            int64_t{2} * d.attributes * spec::kWeightFractionBits * (d.attribute_bits + 1);
  } else {
    lane += int64_t{2} * d.attributes * w.attr_tile_plane;
  }
  return lane * w.lanes;
}

template <class Token>
int64_t token_bits(const spec::Contract& c) {
  return spec::packed_bits(spec::fields<Token>(c));
}

int64_t buffer_bits(const spec::Contract& c) {
  const Design& d = c.design;
  const Widths& w = c.width;
  const int64_t place = w.stamp_x + w.stamp_y + w.lanes + 1;  // of a stamp that waits
  int64_t bits = d.prim_fifo_depth * token_bits<spec::SetupPrim>(c) +
                 d.tile_fifo_depth * token_bits<spec::Tile>(c) + d.stamp_fifo_depth * place +
                 d.plane_slots * token_bits<spec::Stamp>(c);
  constexpr int kResponses = 2;
  if (d.depth_test) {
    bits += w.inflight_stamps * place + kResponses * token_bits<spec::DepthData>(c);
  }
  return bits;
}

int64_t memory_bits(const Design& d) {
  if (!d.hierarchical_z) return 0;
  const int stamps_log2 = 2 * d.tile_log2 - d.stamp_width_log2 - d.stamp_height_log2;
  return (int64_t{d.hierarchical_z_tiles} * d.hierarchical_z_bits << stamps_log2) / kRomShare;
}

}  // namespace

DesignCost design_cost(const Design& design) {
  const spec::Contract c = spec::contract(design);
  return {setup_bits(design, c.width), reciprocal_bits(design, c.width),
          interpolation_bits(design, c.width), buffer_bits(c), memory_bits(design)};
}

}  // namespace pineda::studies
