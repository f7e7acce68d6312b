// The interface of a scheme for the reciprocal of the doubled area. A scheme needs a file beside
// this one with its functions, and a row in schemes.h; its bits are defined in core/reciprocal.cpp,
// its RTL is in rtl/reciprocal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/spec/design.h"

namespace pineda::spec {

/// Fraction bits of intermediate values: two more than the result has.
constexpr int reciprocal_working_bits(const Design& d) { return d.reciprocal_bits + 2; }

/// A constant of the SystemVerilog package.
struct Constant {
  const char* name;
  int value;
  const char* meaning;
};

/// One field of a ROM entry.
struct RomPart {
  int bits;
  int64_t value;
};

/// A ROM of 2^reciprocal_lut_bits entries.
struct ReciprocalRom {
  int (*entry_bits)(const Design&) = nullptr;
  /// The fields of an entry, the first one in the top bits.
  std::vector<RomPart> (*entry)(const Design&, int index) = nullptr;
  /// What an entry means, for a comment in the package.
  std::string (*meaning)(const Design&) = nullptr;
};

struct Scheme {
  ReciprocalScheme value;
  const char* word;
  const char* macro;  // the macro PINEDA_RECIPROCAL_<macro> selects it in the RTL
  bool has_rom;
  bool has_newton_steps;
  bool every_cycle;  // takes a new argument every cycle, as perspective and pipelined setup need
  /// Cycles from the argument to its reciprocal, its alignment included, if a product takes so many.
  int (*cycles)(const Design&, int multiplier_stages);
  /// Steps of serial setup between the last product of the edges and the first one of the planes.
  /// The reciprocal's last product is used while the multiplier makes the first one of the planes.
  int (*serial_setup_steps)(const Design&);
  /// Upper bound of the relative error, proven for all parameters. With t = 2^-(k+2): truncating
  /// the argument makes the result up to 2t greater, the last rounding changes it by up to 4t.
  double (*error_bound)(const Design&);
  /// Why a design cannot use it; empty if it can.
  std::string (*invalid_reason)(const Design&);
  /// Its constants for the package, beside k and the cycles.
  std::vector<Constant> (*constants)(const Design&);
  /// Its size in bits of partial products and of adders, without the ROM.
  int64_t (*logic_bits)(const Design&, int area2_bits);
  ReciprocalRom rom = {};  // if it has one
};

}  // namespace pineda::spec
