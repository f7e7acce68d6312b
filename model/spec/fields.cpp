#include "model/spec/fields.h"

#include <fmt/format.h>

#include "model/spec/clear_depth.h"

namespace pineda::spec {
namespace {

// A row's accessors. `contract` is the contract, `s` the struct, `i` the element, `x` the value.
#define PINEDA_GET(T, expression)                              \
  [](const Contract& contract, const T& s, int i) -> int64_t { \
    (void)contract, (void)i;                                   \
    return static_cast<int64_t>(expression);                   \
  }
#define PINEDA_SET(T, lvalue)                                           \
  [](const Contract& contract, T& s, int i, int64_t x) {                \
    (void)contract, (void)i;                                            \
    lvalue = static_cast<std::remove_reference_t<decltype(lvalue)>>(x); \
  }
#define PINEDA_ACCESS(T, lvalue) PINEDA_GET(T, lvalue), PINEDA_SET(T, lvalue)

template <class T>
using Table = std::vector<Field<T>>;

// Fields of which a design has none are left out.
template <class T>
Table<T> present(Table<T> table) {
  Table<T> kept;
  for (const auto& field : table) {
    if (field.count > 0) kept.push_back(field);
  }
  return kept;
}

// The address that stamps, reads and writes share.
template <class T>
Table<T> stamp_address(const Contract& c) {
  const Widths& w = c.width;
  return {
      {"id", "", false, kTriangleIdBits, 0, 1, PINEDA_ACCESS(T, s.id)},
      {"x", "stamp", false, w.stamp_x, 0, 1, PINEDA_ACCESS(T, s.x)},
      {"y", "stamp", false, w.stamp_y, 0, 1, PINEDA_ACCESS(T, s.y)},
      {"mask", "lane", false, w.lanes, 0, 1, PINEDA_ACCESS(T, s.mask)},
  };
}

template <class T>
Table<T> append(Table<T> table, const Table<T>& more) {
  table.insert(table.end(), more.begin(), more.end());
  return present(table);
}

size_t at(int i) { return static_cast<size_t>(i); }
// Attributes of several vertices or lanes: all attributes of the first, then of the second, ...
size_t owner(const Contract& c, int i) { return at(i / c.design.attributes); }
size_t channel(const Contract& c, int i) { return at(i % c.design.attributes); }

/// "none/back/front".
template <class Value>
const char* choices() {
  static const std::string text = joined(word_list<Value>(), "/", "/");
  return text.c_str();
}

// What the samples of a triangle get their values from; planes have `f` fraction bits.
template <class T>
Table<T> plane_fields(const Contract& c, int depth_bits, int attr_bits, int f) {
  const Design& d = c.design;
  const bool has_planes = d.reciprocal_scheme != ReciprocalScheme::kNone;
  const int depth = has_planes && d.depth_test ? 1 : 0;
  const int n = has_planes && !d.perspective ? d.attributes : 0;
  const int vertices = d.perspective ? 3 : 0;
  return {
      {"z_dx", "code/px", true, depth_bits, f, depth, PINEDA_ACCESS(T, s.planes.z.dx)},
      {"z_dy", "code/px", true, depth_bits, f, depth, PINEDA_ACCESS(T, s.planes.z.dy)},
      {"z_ref", "code", true, depth_bits, f, depth, PINEDA_ACCESS(T, s.planes.z.ref)},
      {"z_bias", "code", true, c.width.depth_bias, kBiasFractionBits, depth,
       PINEDA_ACCESS(T, s.planes.z_bias)},
      {"attr_dx", "LSB/px", true, attr_bits, f, n,
       PINEDA_ACCESS(T, s.planes.attr[static_cast<size_t>(i)].dx)},
      {"attr_dy", "LSB/px", true, attr_bits, f, n,
       PINEDA_ACCESS(T, s.planes.attr[static_cast<size_t>(i)].dy)},
      {"attr_ref", "LSB", true, attr_bits, f, n,
       PINEDA_ACCESS(T, s.planes.attr[static_cast<size_t>(i)].ref)},
      {"e_low", "px^2", false, d.subpixel_bits, 2 * d.subpixel_bits, vertices,
       PINEDA_ACCESS(T, s.planes.perspective.e_low[at(i)])},
      {"inverse_w", "", false, d.inverse_w_bits, 0, vertices,
       PINEDA_ACCESS(T, s.planes.perspective.inverse_w[at(i)])},
      {"inverse_w_shift", "", false, kInverseWShiftBits, 0, vertices,
       PINEDA_ACCESS(T, s.planes.perspective.inverse_w_shift[at(i)])},
      {"vertex_attr", "LSB", false, d.attribute_bits, 0, vertices * d.attributes,
       PINEDA_ACCESS(T, s.planes.perspective.attr[owner(contract, i)][channel(contract, i)])},
      {"flat", "LSB", false, d.attribute_bits, 0, d.flat_attributes,
       PINEDA_ACCESS(T, s.planes.flat[at(i)])},
  };
}

}  // namespace

template <>
Table<FrameState> fields(const Contract& c) {
  const Widths& w = c.width;
  const int depth = c.design.depth_test ? 1 : 0;
  const int smooth = c.design.attributes > 0 ? 1 : 0;
  return present<FrameState>({
      {"width", "px", false, w.frame_size, 0, 1, PINEDA_ACCESS(FrameState, s.width)},
      {"height", "px", false, w.frame_size, 0, 1, PINEDA_ACCESS(FrameState, s.height)},
      {"cull", choices<Cull>(), false, 2, 0, 1, PINEDA_ACCESS(FrameState, s.cull)},
      {"depth", "function", false, 4, 0, depth, PINEDA_ACCESS(FrameState, s.depth)},
      {"depth_write", choices<bool>(), false, 1, 0, depth,
       PINEDA_ACCESS(FrameState, s.depth_write)},
      {"shade", choices<Shade>(), false, 1, 0, smooth, PINEDA_ACCESS(FrameState, s.shade)},
      // The scissor as the units take it: clipped to the frame. One of no size, which cannot be
      // drawn, keeps what was set.
      {"clip_x0", "px", false, w.frame_size, 0, 1,
       PINEDA_GET(FrameState, s.width == 0 ? s.scissor_x0 : s.clip_x0()),
       PINEDA_SET(FrameState, s.scissor_x0)},
      {"clip_y0", "px", false, w.frame_size, 0, 1,
       PINEDA_GET(FrameState, s.height == 0 ? s.scissor_y0 : s.clip_y0()),
       PINEDA_SET(FrameState, s.scissor_y0)},
      {"clip_x1", "px", false, w.frame_size, 0, 1,
       PINEDA_GET(FrameState, s.width == 0 ? s.scissor_x1 : s.clip_x1()),
       PINEDA_SET(FrameState, s.scissor_x1)},
      {"clip_y1", "px", false, w.frame_size, 0, 1,
       PINEDA_GET(FrameState, s.height == 0 ? s.scissor_y1 : s.clip_y1()),
       PINEDA_SET(FrameState, s.scissor_y1)},
      {"bias_constant", "code", true, w.bias_constant, 0, depth,
       PINEDA_ACCESS(FrameState, s.bias_constant)},
      {"bias_slope", "px", true, kBiasSlopeBits, kBiasFactorFractionBits, depth,
       PINEDA_ACCESS(FrameState, s.bias_slope)},
      {"clear_depth", "code", false, c.design.depth_bits, 0, depth,
       PINEDA_GET(FrameState, depth_code(s.clear_depth, contract.design.depth_bits)),
       [](const Contract& contract, FrameState& s, int, int64_t x) {
         s.clear_depth = depth_of_code(static_cast<uint32_t>(x), contract.design.depth_bits);
       }},
  });
}

template <>
Table<Triangle> fields(const Contract& c) {
  const Widths& w = c.width;
  const int s_bits = c.design.subpixel_bits;
  const int depth = c.design.depth_test ? 3 : 0;
  const int inverse_w = c.design.perspective ? 3 : 0;
  return present<Triangle>({
      {"id", "", false, kTriangleIdBits, 0, 1, PINEDA_ACCESS(Triangle, s.id)},
      {"x", "px", true, w.coord, s_bits, 3, PINEDA_ACCESS(Triangle, s.v[at(i)].x)},
      {"y", "px", true, w.coord, s_bits, 3, PINEDA_ACCESS(Triangle, s.v[at(i)].y)},
      {"z", "code", false, w.depth_in, kDepthInputFractionBits, depth,
       PINEDA_ACCESS(Triangle, s.v[at(i)].z)},
      {"inverse_w", "", false, c.design.inverse_w_bits, 0, inverse_w,
       PINEDA_ACCESS(Triangle, s.v[at(i)].inverse_w)},
      {"inverse_w_shift", "", false, kInverseWShiftBits, 0, inverse_w,
       PINEDA_ACCESS(Triangle, s.v[at(i)].inverse_w_shift)},
      {"attr", "LSB", false, c.design.attribute_bits, 0, 3 * c.design.attributes,
       PINEDA_ACCESS(Triangle, s.v[owner(contract, i)].attr[channel(contract, i)])},
      {"flat", "LSB", false, c.design.attribute_bits, 0, c.design.flat_attributes,
       PINEDA_ACCESS(Triangle, s.v[0].attr[at(contract.design.attributes + i)])},
  });
}

template <>
Table<SetupPrim> fields(const Contract& c) {
  const Widths& w = c.width;
  const int s_bits = c.design.subpixel_bits;
  return append<SetupPrim>(
      {
          {"id", "", false, kTriangleIdBits, 0, 1, PINEDA_ACCESS(SetupPrim, s.id)},
          {"x0", "px", false, w.pixel, 0, 1, PINEDA_ACCESS(SetupPrim, s.x0)},
          {"y0", "px", false, w.pixel, 0, 1, PINEDA_ACCESS(SetupPrim, s.y0)},
          {"x1", "px", false, w.pixel, 0, 1, PINEDA_ACCESS(SetupPrim, s.x1)},
          {"y1", "px", false, w.pixel, 0, 1, PINEDA_ACCESS(SetupPrim, s.y1)},
          {"a", "px", true, w.edge_coeff, s_bits, 3, PINEDA_ACCESS(SetupPrim, s.edge[at(i)].a)},
          {"b", "px", true, w.edge_coeff, s_bits, 3, PINEDA_ACCESS(SetupPrim, s.edge[at(i)].b)},
          {"e", "px^2", true, w.edge, s_bits, 3, PINEDA_ACCESS(SetupPrim, s.edge[at(i)].e)},
          {"z_steep", "", false, 1, 0, c.design.hierarchical_z ? 1 : 0,
           PINEDA_ACCESS(SetupPrim, s.planes.z_steep)},
      },
      plane_fields<SetupPrim>(c, w.depth_plane, w.attr_plane, c.design.gradient_fraction_bits));
}

template <>
Table<Tile> fields(const Contract& c) {
  const Widths& w = c.width;
  const int s_bits = c.design.subpixel_bits;
  const int tile = c.design.tile_log2;
  return append<Tile>(
      {
          {"id", "", false, kTriangleIdBits, 0, 1, PINEDA_ACCESS(Tile, s.id)},
          {"x", "tile", false, w.tile_index, 0, 1, PINEDA_ACCESS(Tile, s.x)},
          {"y", "tile", false, w.tile_index, 0, 1, PINEDA_ACCESS(Tile, s.y)},
          {"x0", "px", false, tile, 0, 1, PINEDA_ACCESS(Tile, s.x0)},
          {"y0", "px", false, tile, 0, 1, PINEDA_ACCESS(Tile, s.y0)},
          {"x1", "px", false, tile, 0, 1, PINEDA_ACCESS(Tile, s.x1)},
          {"y1", "px", false, tile, 0, 1, PINEDA_ACCESS(Tile, s.y1)},
          {"a", "px", true, w.edge_coeff, s_bits, 3, PINEDA_ACCESS(Tile, s.edge[at(i)].a)},
          {"b", "px", true, w.edge_coeff, s_bits, 3, PINEDA_ACCESS(Tile, s.edge[at(i)].b)},
          {"e", "px^2", true, w.tile_edge, s_bits, 3, PINEDA_ACCESS(Tile, s.edge[at(i)].e)},
          {"accepted", "edge", false, 3, 0, 1, PINEDA_ACCESS(Tile, s.accepted)},
      },
      plane_fields<Tile>(c, w.depth_tile_plane, w.attr_tile_plane, c.design.tile_fraction_bits));
}

template <>
Table<Stamp> fields(const Contract& c) {
  const Widths& w = c.width;
  const int s_bits = c.design.subpixel_bits;
  const int edges = c.design.perspective ? 3 : 0;
  const Table<Stamp> planes =
      plane_fields<Stamp>(c, w.depth_tile_plane, w.attr_tile_plane, c.design.tile_fraction_bits);
  return append<Stamp>(
      append<Stamp>(
          stamp_address<Stamp>(c),
          {
              {"first", "", false, 1, 0, 1, PINEDA_ACCESS(Stamp, s.first)},
              {"a", "px", true, w.edge_coeff, s_bits, edges, PINEDA_ACCESS(Stamp, s.edge[at(i)].a)},
              {"b", "px", true, w.edge_coeff, s_bits, edges, PINEDA_ACCESS(Stamp, s.edge[at(i)].b)},
              {"e", "px^2", true, w.edge, s_bits, edges, PINEDA_ACCESS(Stamp, s.edge[at(i)].e)},
          }),
      planes);
}

template <>
Table<DepthRead> fields(const Contract& c) {
  return stamp_address<DepthRead>(c);
}

template <>
Table<DepthData> fields(const Contract& c) {
  return {{"z", "code", false, c.design.depth_bits, 0, c.width.lanes,
           PINEDA_ACCESS(DepthData, s.z[at(i)])}};
}

template <>
Table<DepthMax> fields(const Contract& c) {
  const Widths& w = c.width;
  return {
      {"x", "stamp", false, w.stamp_x, 0, 1, PINEDA_ACCESS(DepthMax, s.x)},
      {"y", "stamp", false, w.stamp_y, 0, 1, PINEDA_ACCESS(DepthMax, s.y)},
      {"z", "code", false, c.design.hierarchical_z_bits, 0, 1, PINEDA_ACCESS(DepthMax, s.z)},
  };
}

template <>
Table<DepthWrite> fields(const Contract& c) {
  return append<DepthWrite>(stamp_address<DepthWrite>(c),
                            {{"z", "code", false, c.design.depth_bits, 0, c.width.lanes,
                              PINEDA_ACCESS(DepthWrite, s.z[at(i)])}});
}

template <>
Table<ColorWrite> fields(const Contract& c) {
  return append<ColorWrite>(
      stamp_address<ColorWrite>(c),
      {{"attr", "LSB", false, c.design.attribute_bits, 0, c.width.lanes * c.design.attributes,
        PINEDA_ACCESS(ColorWrite, s.attr[owner(contract, i)][channel(contract, i)])},
       {"flat", "LSB", false, c.design.attribute_bits, 0, c.design.flat_attributes,
        PINEDA_ACCESS(ColorWrite, s.flat[at(i)])}});
}

std::string format_name(bool is_signed, int bits, int fraction_bits, const char* unit) {
  const int integer_bits = bits - fraction_bits - (is_signed ? 1 : 0);
  std::string text = fraction_bits == 0 ? fmt::format("{}{}", is_signed ? 's' : 'u', bits)
                                        : fmt::format("{}Q{}.{}", is_signed ? 's' : 'u',
                                                      integer_bits, fraction_bits);
  if (*unit != '\0') text += fmt::format(" {}", unit);
  return text;
}

}  // namespace pineda::spec
