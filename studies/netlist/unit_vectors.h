// The committed vectors of a unit as its netlist's bench takes them, and the judge of what comes out.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "model/spec/widths.h"

namespace pineda::studies {

/// What a netlist did with its vectors.
struct Replay {
  std::string unit;
  size_t cases = 0;
  size_t words = 0;  // that came out, all compared
  int64_t cycles = 0;
  std::string difference;    // the first; empty: none
  bool is_complete = false;  // it went to the end of the last case, or to the first difference
};

/// Cases of one unit. In a netlist the number of a triangle has one bit: its lowest.
class UnitVectors {
 public:
  virtual ~UnitVectors() = default;

  virtual std::string unit() const = 0;
  virtual size_t cases() const = 0;
  /// Parameters of the bench, NAME=VALUE, and its unit.svh.
  virtual std::vector<std::string> parameters() const = 0;
  virtual std::string instance() const = 0;
  /// What the bench reads.
  virtual std::string text() const = 0;
  /// Compares what the bench wrote, word by word, in order.
  virtual Replay compare(std::istream& written) const = 0;
};

/// The committed vectors of a unit, setup, traversal or interp_ztest, of a design; at most `cases`
/// of them, evenly spread over the file, 0: all.
///
/// Errors   AreaError: there are none of the design. vectors::Refused: they are not as they should be.
std::unique_ptr<UnitVectors> committed_vectors(const spec::Contract& contract,
                                               const std::string& unit, size_t cases);

}  // namespace pineda::studies
