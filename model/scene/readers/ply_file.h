// Reads the elements and values of a PLY file in any encoding; ply_reader interprets them.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/scene/readers/lines.h"

namespace pineda::scene {

enum class PlyType { kI8, kU8, kI16, kU16, kI32, kU32, kF32, kF64 };

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count;  // for a list, the type of its length
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;  // at least one
};

/// In       "ply", "format ascii|binary_little_endian|binary_big_endian 1.0", elements and their
///          properties with short (uchar) or long (uint8) names of types, "end_header"; then the
///          elements in order, in ASCII one in each line. Comments and unknown lines may be
///          anywhere in the header after its first line.
/// Errors   InputError with the line; in a binary body with the element, "face 7" (from 0).
/// Source   G. Turk, "The PLY Polygon File Format", 1994.
class PlyFile {
 public:
  explicit PlyFile(const std::string& file);

  const std::vector<PlyElement>& elements() const { return elements_; }
  /// Unknown lines of the header.
  uint64_t unknown_lines() const { return unknown_lines_; }
  const std::string& first_unknown_line() const { return first_unknown_line_; }

  /// Call begin(), read the element's values in the order of its properties, then call end().
  void begin(const PlyElement& element, uint64_t i);
  double number(PlyType type) { return encoding_ == Encoding::kAscii ? word(type) : bytes(type); }
  uint64_t list_size(PlyType type);
  void end() const;
  /// Is anything left in the file after the last element?
  bool has_more();

  [[noreturn]] void fail(const std::string& expected, const std::string& got) const;

 private:
  enum class Encoding { kAscii, kLittleEndian, kBigEndian };

  void read_header();
  void header_line();
  void close_element();
  void read_format();
  void read_element();
  void read_property();
  PlyType type_of(const char* word) const;
  double word(PlyType type);
  double bytes(PlyType type);

  std::string file_;
  LineReader lines_;
  Encoding encoding_ = Encoding::kAscii;
  bool has_format_ = false;
  std::vector<PlyElement> elements_;
  std::set<std::string> names_;  // of the elements read so far
  uint64_t unknown_lines_ = 0;
  std::string first_unknown_line_;
  const PlyElement* element_ = nullptr;  // the one being read, and its number
  uint64_t number_ = 0;
  size_t next_word_ = 0;
};

}  // namespace pineda::scene
