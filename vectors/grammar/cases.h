// Test vectors: what each unit is given and the bits that must come out, in order.
// The model's tests and the RTL's tests read the same files; README.md holds the grammar.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/core/frame.h"
#include "model/memory/stalls.h"

namespace pineda::vectors {

enum class Unit { kSetup, kTraversal, kInterpZtest, kFrame };

inline constexpr spec::Name<Unit> kUnitNames[] = {
    {Unit::kSetup, "setup"},
    {Unit::kTraversal, "traversal"},
    {Unit::kInterpZtest, "interp_ztest"},
    {Unit::kFrame, "frame"},
};
constexpr const auto& names(Unit) { return kUnitNames; }

/// When the ports of a case's unit stall.
struct PortStalls {
  memory::StallMode mode = memory::StallMode::kNone;
  uint64_t seed = 0;

  memory::Stalls stalls() const { return {mode, seed}; }
};

/// Triangles in; a SetupPrim or the cause of the drop out, in order.
struct SetupCase {
  static constexpr Unit kUnit = Unit::kSetup;
  std::string name;
  spec::FrameState frame;
  std::vector<spec::Triangle> in;
  std::vector<core::Drop> drops;     // one for each triangle; kNone: it is in `out`
  std::vector<spec::SetupPrim> out;  // of the triangles that are not dropped
  PortStalls ports = {};
};

/// SetupPrims in, the stamps of all of them out. No empty stamps.
struct TraversalCase {
  static constexpr Unit kUnit = Unit::kTraversal;
  std::string name;
  spec::FrameState frame;
  std::vector<spec::SetupPrim> in;
  std::vector<spec::Stamp> out;
  PortStalls ports = {};
};

/// Stamps in, the writes of each stream out. The depth memory starts cleared as the frame says and
/// sees every write of an earlier stamp. Every lane of a stamp lies inside the frame.
struct InterpZtestCase {
  static constexpr Unit kUnit = Unit::kInterpZtest;
  std::string name;
  spec::FrameState frame;
  std::vector<spec::Stamp> in;
  std::vector<spec::DepthWrite> depth;
  std::vector<spec::ColorWrite> color;
  PortStalls ports = {};
};

/// Bits of what a vector file says of samples and counters, where no format of the design has them.
inline constexpr int kPlaceBits = 16;  // column and row of a sample, px
inline constexpr int kHitBits = 16;
inline constexpr int kCounterBits = 32;

/// A sample of the memories of a frame.
struct Sample {
  int x = 0;
  int y = 0;
  uint32_t depth = 0;  // code
  std::array<uint16_t, spec::kMaxAttributes>
      color{};        // interpolated attributes first, then flat ones
  uint16_t hits = 0;  // as in core::FrameBuffer
};

/// Triangles in; what the memories hold at the end of the frame and its counters out.
struct FrameCase {
  static constexpr Unit kUnit = Unit::kFrame;
  std::string name;
  spec::FrameState frame;
  std::vector<spec::Triangle> in;
  std::vector<Sample> samples;  // that are not as cleared, row by row
  core::FrameCounters counters;
  PortStalls ports = {};
  std::optional<uint64_t> reset_cycle =
      {};  // a frame of begun_triangles() is begun before and reset in this cycle
};

/// Those of the frame, with each depth and attribute from the other end of its range: what a reset leaves
/// behind is not what the frame draws.
std::vector<spec::Triangle> begun_triangles(const spec::Contract& contract, const FrameCase& value);

/// A counter of a frame, as files and mismatch lines name it. What depends on time is not in files.
struct Counter {
  std::string name;
  const core::FrameCounter* row;
};
const std::vector<Counter>& counters();

/// What the functional model makes of the case's inputs: the same case with fresh outputs.
SetupCase run_model(const spec::Contract& contract, const SetupCase& inputs);
TraversalCase run_model(const spec::Contract& contract, const TraversalCase& inputs);
InterpZtestCase run_model(const spec::Contract& contract, const InterpZtestCase& inputs);
FrameCase run_model(const spec::Contract& contract, const FrameCase& inputs);

/// The first output in which `got` differs, in the order of the streams, or nothing:
/// "setup case sliver.3: setup_prim 2: e[1]: expected 0x7fffffffff (-0.00390625 px^2), got ...".
/// The inputs are not compared.
std::optional<std::string> difference(const spec::Contract& contract, const SetupCase& expected,
                                      const SetupCase& got);
std::optional<std::string> difference(const spec::Contract& contract, const TraversalCase& expected,
                                      const TraversalCase& got);
std::optional<std::string> difference(const spec::Contract& contract,
                                      const InterpZtestCase& expected, const InterpZtestCase& got);
std::optional<std::string> difference(const spec::Contract& contract, const FrameCase& expected,
                                      const FrameCase& got);

}  // namespace pineda::vectors
