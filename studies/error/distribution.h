// How errors are distributed: largest, quantiles, root mean square, share misrounded.
#pragma once

#include <cstdint>
#include <vector>

namespace pineda::studies {

/// |error| of many values, in units of the last place. Memory does not grow with their number.
///
/// Errors   max, rms and misrounded are exact up to rounding of doubles; quantiles lie up to 1.6 %
///          too high: the upper edge of a bin, 64 bins an octave from 2^-40 to 2^40.
class Distribution {
 public:
  /// `misrounded`: the value is not the nearest one to the exact value.
  void add(double error, bool misrounded);

  uint64_t count() const { return count_; }
  double max() const { return max_; }
  double rms() const;
  /// The least bin edge that the share `q` of all values does not exceed, at most max(); 0 < q
  /// <= 1.
  double quantile(double q) const;
  /// Share of the values, 0 to 1.
  double misrounded() const;

  /// Values with 2^octave <= |error| < 2^(octave+1); -40 also holds all that are smaller.
  struct Octave {
    int octave;
    uint64_t count;
  };
  /// From the least to the greatest that holds anything; exact values (error 0) are left out.
  std::vector<Octave> octaves() const;
  uint64_t zeros() const { return zeros_; }

 private:
  std::vector<uint64_t> bins_;
  uint64_t count_ = 0;
  uint64_t zeros_ = 0;
  uint64_t misrounded_ = 0;
  double max_ = 0;
  double squares_ = 0;
};

}  // namespace pineda::studies
