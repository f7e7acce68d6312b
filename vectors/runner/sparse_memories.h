// The memories of a frame of any size, of which few samples are written.
#pragma once

#include <map>
#include <utility>

#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// Behaves as core::FrameBuffer, for core::FrameWriter; holds the samples that were touched.
class SparseMemories {
 public:
  SparseMemories(const spec::Contract& contract, const spec::FrameState& frame)
      : clear_depth_(spec::cleared_depth(contract.design, frame)) {}

  spec::DepthData read(const spec::Contract& contract, int x, int y, uint32_t mask) const;
  void write(const spec::Contract& contract, const spec::DepthWrite& write);
  void write(const spec::Contract& contract, const spec::ColorWrite& write);
  void count_hits(const spec::Contract& contract, const spec::Stamp& stamp);

  /// Row by row.
  std::vector<Sample> samples() const;

 private:
  template <class Visitor>
  void touch(const spec::Contract& contract, int x, int y, uint32_t mask, Visitor&& visit);

  uint32_t clear_depth_;
  std::map<std::pair<int, int>, Sample> samples_;  // by row and column
};

}  // namespace pineda::vectors
