// One table for each struct: name, sign, width, fraction bits and unit of each field, in order. The
// SystemVerilog package, packing, the columns of vectors and mismatch messages are made from it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/spec/structs.h"

namespace pineda::spec {

/// A field of struct T: `count` elements of `bits` bits each; element 0 is in the lowest bits.
template <class T>
struct Field {
  const char* name;
  const char* unit;
  bool is_signed;
  int bits;
  int fraction_bits;
  int count;
  int64_t (*get)(const Contract&, const T&, int element);
  void (*set)(const Contract&, T&, int element, int64_t value);
};

/// The fields of T in declaration order; the first one is in the top bits of the packed struct.
template <class T>
std::vector<Field<T>> fields(const Contract& contract);

/// Name of the packed SystemVerilog struct, without the _t.
template <class T>
const char* struct_name();

template <>
std::vector<Field<FrameState>> fields(const Contract&);
template <>
std::vector<Field<Triangle>> fields(const Contract&);
template <>
std::vector<Field<SetupPrim>> fields(const Contract&);
template <>
std::vector<Field<Tile>> fields(const Contract&);
template <>
std::vector<Field<Stamp>> fields(const Contract&);
template <>
std::vector<Field<DepthRead>> fields(const Contract&);
template <>
std::vector<Field<DepthData>> fields(const Contract&);
template <>
std::vector<Field<DepthMax>> fields(const Contract&);
template <>
std::vector<Field<DepthWrite>> fields(const Contract&);
template <>
std::vector<Field<ColorWrite>> fields(const Contract&);

template <>
inline const char* struct_name<FrameState>() {
  return "frame";
}
template <>
inline const char* struct_name<Triangle>() {
  return "triangle";
}
template <>
inline const char* struct_name<SetupPrim>() {
  return "setup_prim";
}
template <>
inline const char* struct_name<Tile>() {
  return "tile";
}
template <>
inline const char* struct_name<Stamp>() {
  return "stamp";
}
template <>
inline const char* struct_name<DepthRead>() {
  return "depth_read";
}
template <>
inline const char* struct_name<DepthData>() {
  return "depth_data";
}
template <>
inline const char* struct_name<DepthMax>() {
  return "depth_max";
}
template <>
inline const char* struct_name<DepthWrite>() {
  return "depth_write";
}
template <>
inline const char* struct_name<ColorWrite>() {
  return "color_write";
}

/// Bits of the packed struct.
template <class T>
int packed_bits(const std::vector<Field<T>>& table) {
  int bits = 0;
  for (const auto& field : table) bits += field.bits * field.count;
  return bits;
}

/// "sQ30.8 px^2" or "u4": the format of a field as documentation and mismatch lines print it.
std::string format_name(bool is_signed, int bits, int fraction_bits, const char* unit);

/// Calls visit(table, name) for each struct that crosses a boundary, in the package's order.
template <class Visitor>
void for_each_struct(const Contract& c, Visitor&& visit) {
  visit(fields<FrameState>(c), struct_name<FrameState>());
  visit(fields<Triangle>(c), struct_name<Triangle>());
  visit(fields<SetupPrim>(c), struct_name<SetupPrim>());
  visit(fields<Tile>(c), struct_name<Tile>());
  visit(fields<Stamp>(c), struct_name<Stamp>());
  if (c.design.depth_test) {
    visit(fields<DepthRead>(c), struct_name<DepthRead>());
    visit(fields<DepthData>(c), struct_name<DepthData>());
    visit(fields<DepthWrite>(c), struct_name<DepthWrite>());
  }
  if (c.design.hierarchical_z) visit(fields<DepthMax>(c), struct_name<DepthMax>());
  visit(fields<ColorWrite>(c), struct_name<ColorWrite>());
}

}  // namespace pineda::spec
