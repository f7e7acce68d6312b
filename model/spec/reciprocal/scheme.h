// What the project must know of a scheme for the reciprocal of the doubled area. A scheme is a file
// beside this one with the functions of its row, and the row in schemes.h; its bits are defined in
// core/reciprocal.cpp, its RTL stands in rtl/reciprocal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/spec/design.h"

namespace pineda::spec {

/// Fraction bits while a reciprocal is computed: two more than it has in the end.
constexpr int reciprocal_working_bits(const Design& d) { return d.reciprocal_bits + 2; }

/// A constant of the package.
struct Constant {
  const char* name;
  int value;
  const char* meaning;
};

/// A part of a ROM's entry.
struct RomPart {
  int bits;
  int64_t value;
};

/// A ROM of 2^reciprocal_lut_bits entries.
struct ReciprocalRom {
  int (*entry_bits)(const Design&) = nullptr;
  /// The parts of an entry, the first one on top.
  std::vector<RomPart> (*entry)(const Design&, int index) = nullptr;
  /// What an entry stands for, in a line of the package.
  std::string (*meaning)(const Design&) = nullptr;
};

struct Scheme {
  ReciprocalScheme value;
  const char* word;
  const char* macro;  // PINEDA_RECIPROCAL_<macro> has the RTL build it
  bool has_rom;
  bool has_newton_steps;
  bool every_cycle;  // its unit takes a number a cycle, as perspective and pipelined setup need
  /// Cycles from the doubled area to its reciprocal, the one that aligns it included.
  int (*cycles)(const Design&);
  /// Steps of serial setup between the edges' last product and the first plane's. The
  /// reciprocal's last product is taken up while the planes' first one is made.
  int (*serial_setup_steps)(const Design&);
  /// Greatest relative error, proven for every parameter. With t = 2^-(k+2): cutting m off makes
  /// the result up to 2t greater, the last rounding moves it by up to 4t.
  double (*error_bound)(const Design&);
  /// Why a design cannot have it, or an empty text.
  std::string (*invalid_reason)(const Design&);
  /// What of it the package names beside k and the cycles.
  std::vector<Constant> (*constants)(const Design&);
  /// Bits of partial products and of adders that it is built from, without its ROM.
  int64_t (*logic_bits)(const Design&, int area2_bits);
  ReciprocalRom rom = {};  // if it has one
};

}  // namespace pineda::spec
