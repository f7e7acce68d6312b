// One Verilated unit on its own: tokens in, tokens out, in order, with the cycles of both.
#pragma once

#include <limits>

#include "tb/frame_bench.h"

namespace pineda::tb {

/// What went through a stream, and when.
template <class T>
struct Trace {
  std::vector<T> tokens;
  std::vector<Cycle> cycles;  // of the handshakes

  void add(Cycle cycle, const T& token) {
    tokens.push_back(token);
    cycles.push_back(cycle);
  }
};

inline constexpr Cycle kNoCycleLimit = std::numeric_limits<Cycle>::max();

/// Throws RtlError once a run that began in cycle `start` takes more than `limit` cycles.
inline void require_in_time(const RtlUnit& unit, Cycle start, Cycle limit) {
  if (unit.cycle() - start <= limit) return;
  throw RtlError(fmt::format("{}: not idle after {} cycles", unit.name(), limit));
}

/// A unit with one stream in and one out: setup (Triangle -> SetupPrim), traversal
/// (SetupPrim -> Stamp).
template <class In, class Out>
class UnitBench {
 public:
  UnitBench(const RtlLibrary& library, const std::string& unit, const std::string& in,
            const std::string& out, const BenchOptions& options)
      : unit_(library, unit),
        stalls_(options.stall_mode, options.seed),
        in_(unit_, in),
        out_(unit_, out),
        idle_(unit_.port("idle_o")) {
    unit_.reset();
  }

  RtlUnit& unit() { return unit_; }
  bool write_coverage(const std::string& file) const { return unit_.write_coverage(file); }
  /// Whatever is at work is gone.
  void reset() {
    in_.withdraw();
    out_.forget();
    unit_.reset();
  }
  /// Of the runs that follow, in cycles of each.
  void set_stalls(const Stalls& stalls) { stalls_ = stalls; }
  /// A run that takes more cycles throws RtlError.
  void set_cycle_limit(Cycle cycles) { cycle_limit_ = cycles; }

  /// A run in which so many cycles pass without a handshake throws RtlError.
  void set_deadlock_cycles(Cycle cycles) { deadlock_cycles_ = cycles; }

  /// Feeds all tokens, then waits until the unit is idle. *accepted, if given, gets the cycles in
  /// which it took them.
  Trace<Out> run(const std::vector<In>& tokens, std::vector<Cycle>* accepted = nullptr) {
    Trace<Out> trace;
    size_t next = 0;
    const Cycle start = unit_.cycle();
    Cycle last_event = start;
    for (bool done = false; !done;) {
      const Cycle cycle = unit_.cycle();
      if (!in_.offered() && next < tokens.size() && !stalls_(Port::kInput, cycle - start)) {
        in_.offer(tokens[next++]);
      }
      out_.set_ready(!stalls_(Port::kOutput, cycle - start));
      unit_.settle();
      const bool took = in_.taken();
      const bool gave = out_.taken();
      if (gave) trace.add(cycle, out_.value());
      if (took && accepted != nullptr) accepted->push_back(cycle);
      if (took || gave) last_event = cycle;
      if (cycle - last_event > deadlock_cycles_) {
        throw RtlError(fmt::format("{}: nothing moves since cycle {}", unit_.name(), last_event));
      }
      require_in_time(unit_, start, cycle_limit_);
      done = next == tokens.size() && !in_.offered() && idle_.bit();
      unit_.clock();
      if (took) in_.withdraw();
    }
    return trace;
  }

 private:
  RtlUnit unit_;
  Stalls stalls_;
  Cycle cycle_limit_ = kNoCycleLimit;
  Cycle deadlock_cycles_ = kDeadlockCycles;
  SourceEnd<In> in_;
  SinkEnd<Out> out_;
  PortData idle_;
};

class SetupBench : public UnitBench<spec::Triangle, spec::SetupPrim> {
 public:
  SetupBench(const RtlLibrary& library, const BenchOptions& options)
      : UnitBench(library, "setup", "tri", "prim", options), frame_(unit(), "frame_i") {}
  /// Raster state of the triangles that follow.
  void set_frame(const spec::FrameState& frame) { frame_.set(frame); }

 private:
  PayloadPort<spec::FrameState> frame_;
};

/// Nothing is stored yet, so hierarchical z hides nothing.
class TraversalBench : public UnitBench<spec::SetupPrim, spec::Stamp> {
 public:
  TraversalBench(const RtlLibrary& library, const BenchOptions& options)
      : UnitBench(library, "traversal", "prim", "stamp", options) {
    if (unit().contract().design.hierarchical_z) unit().port("hides_i").set_bit(false);
  }
};

/// Interpolation and depth test with its memories.
class InterpZtestBench {
 public:
  InterpZtestBench(const RtlLibrary& library, const BenchOptions& options);

  RtlUnit& unit() { return unit_; }
  /// Whatever is at work is gone.
  void reset() {
    stamps_.withdraw();
    memory_.forget();
    unit_.reset();
  }
  struct Writes {
    Trace<spec::DepthWrite> depth;
    Trace<spec::ColorWrite> color;
  };
  /// Clears the memories, feeds all stamps, waits until the unit is idle.
  Writes run(const spec::FrameState& frame, const std::vector<spec::Stamp>& stamps,
             std::vector<Cycle>* accepted = nullptr) {
    return run_on(PagedBuffer(unit_.contract(), frame), frame, stamps, accepted);
  }
  /// The same on memories that hold something.
  Writes run_on(PagedBuffer memory, const spec::FrameState& frame,
                const std::vector<spec::Stamp>& stamps, std::vector<Cycle>* accepted = nullptr);
  core::FrameBuffer buffer() const { return memory_.memories().whole(); }
  void set_stalls(const Stalls& stalls) { stalls_ = stalls; }
  void set_cycle_limit(Cycle cycles) { cycle_limit_ = cycles; }
  bool write_coverage(const std::string& file) const { return unit_.write_coverage(file); }

 private:
  RtlUnit unit_;
  Stalls stalls_;
  Cycle cycle_limit_ = kNoCycleLimit;
  SourceEnd<spec::Stamp> stamps_;
  std::optional<PortData> depth_func_, depth_write_;
  PortData idle_;
  MemoryEnd memory_;
};

}  // namespace pineda::tb
