#include "tb/frame_bench.h"

#include "model/memory/ideal_timing.h"

namespace pineda::tb {

struct FrameBench::Progress {
  Cycle start = 0;       // cycle in which the frame was first offered
  Cycle last_event = 0;  // cycle of the last handshake
  Cycle last_write = 0;  // cycle after the last accepted write (the clear counts)
  bool more = true;      // triangles to come after `triangle`
  bool held = false;     // `triangle` is not taken yet
  spec::Triangle triangle;
  bool drained = false;  // no triangle is left, and the pipeline is empty
  FrameResult result;
  Cycle deadlock_cycles = 0;
};

std::shared_ptr<MemoryTiming> memory_of(const BenchOptions& options) {
  if (options.memory) return options.memory;
  try {
    return std::make_shared<memory::IdealTiming>(options.depth_latency_cycles);
  } catch (const std::invalid_argument& error) {
    throw RtlError(error.what());
  }
}

FrameBench::FrameBench(const RtlLibrary& library, const BenchOptions& options)
    : unit_(library, "top"),
      stalls_(options.stall_mode, options.seed),
      frames_(unit_, "frame"),
      triangles_(unit_, "tri"),
      end_valid_(unit_.port("end_valid_i")),
      end_ready_(unit_.port("end_ready_o")),
      clear_valid_(unit_.port("clear_valid_o")),
      clear_ready_(unit_.port("clear_ready_i")),
      idle_(unit_.port("idle_o")),
      prims_(unit_, "prim"),
      stamps_(unit_, "stamp"),
      counters_(unit_),
      memory_(unit_, memory_of(options)) {
  if (unit_.contract().design.depth_test) clear_depth_ = unit_.port("clear_depth_o");
  reset();
}

void FrameBench::reset() {
  frames_.withdraw();
  triangles_.withdraw();
  end_valid_.set_bit(false);
  clear_ready_.set_bit(false);
  memory_.forget();
  unit_.reset();
}

// Memories and the port of a frame, before its first step.
FrameBench::Progress FrameBench::offered(const spec::FrameState& frame) {
  memory_.start(frame, PagedBuffer(unit_.contract(), frame), unit_.cycle());
  frames_.offer(frame);
  Progress progress;
  progress.start = progress.last_event = unit_.cycle();
  progress.deadlock_cycles = deadlock_cycles(frame);
  return progress;
}

FrameResult FrameBench::run(const spec::FrameState& frame, const NextTriangle& next,
                            Listener* listener) {
  Progress progress = offered(frame);
  counters_.start();
  while (!step(&progress, next, listener)) {
  }
  progress.result.cycles = progress.last_write - progress.start;
  return progress.result;
}

void FrameBench::wait(Cycle cycles) {
  for (Cycle i = 0; i < cycles; ++i) {
    const Cycle cycle = unit_.cycle();
    memory_.drive(stalls_, cycle);
    unit_.settle();
    if (memory_.sample(cycle, nullptr)) {
      throw RtlError(fmt::format("top: something is written in cycle {}, without a frame", cycle));
    }
    unit_.clock();
  }
}

void FrameBench::run_into_reset(const spec::FrameState& frame, const NextTriangle& next,
                                Cycle cycles) {
  Progress progress = offered(frame);
  while (unit_.cycle() < progress.start + cycles && !step(&progress, next, nullptr)) {
  }
  const Cycle cycle = unit_.cycle();
  reset();
  unit_.settle();
  if (!idle_.bit()) {
    last_moved_ = cycle;
    throw RtlError(fmt::format("top: not idle after a reset in cycle {}", cycle));
  }
}

std::array<timing::Cause, timing::kUnits> FrameBench::run_close_up(const spec::FrameState& frame,
                                                                   const NextTriangle& next,
                                                                   Listener* listener,
                                                                   const CloseUp& close_up) {
  Progress progress = offered(frame);
  progress.drained = true;  // the counters are read here
  FrameResult counted;
  bool ended = false;
  for (Cycle cycle = 0; !ended && cycle < close_up.until; ++cycle) {
    if (cycle == close_up.from && !close_up.trace.empty() && !trace(close_up.trace)) {
      throw RtlError(fmt::format("{}: cannot be written", close_up.trace));
    }
    if (cycle == close_up.at) counters_.start();
    ended = step(&progress, next, listener);
    if (cycle == close_up.at) counted = counters_.read(1);
  }
  std::array<timing::Cause, timing::kUnits> causes;
  causes.fill(timing::Cause::kStarved);  // if the frame ended before
  for (size_t u = 0; u < timing::kUnits; ++u) {
    for (size_t c = 0; c < timing::kCauses; ++c) {
      if (counted.spent.units[u].spent[c] > 0) causes[u] = static_cast<timing::Cause>(c);
    }
  }
  return causes;
}

// One cycle; true once the end of the frame is taken.
bool FrameBench::step(Progress* p, const NextTriangle& next, Listener* listener) {
  const Cycle cycle = unit_.cycle();
  // The frame was offered before the first step. A triangle is offered when its port does not
  // stall.
  if (!p->held && p->more) p->held = p->more = next(&p->triangle);
  if (p->held && !triangles_.offered() && !stalls_(Port::kTriangle, cycle - p->start)) {
    triangles_.offer(p->triangle);
  }
  const bool at_end = !p->held;
  if (at_end && !stalls_(Port::kEnd, cycle - p->start)) end_valid_.set_bit(true);
  clear_ready_.set_bit(!stalls_(Port::kClear, cycle - p->start));
  memory_.drive(stalls_, cycle);
  unit_.settle();

  const bool frame_taken = frames_.taken();
  const bool triangle_taken = triangles_.taken();
  const bool cleared = clear_valid_.bit() && clear_ready_.bit();
  if (cleared && clear_depth_) memory_.clear_depth(clear_depth_->word());
  const bool ended = end_valid_.bit() && end_ready_.bit();
  const bool written = memory_.sample(cycle, listener);
  bool moved = frame_taken || triangle_taken || cleared || ended || written;
  if (listener != nullptr) {
    if (prims_.taken()) listener->prim(cycle, prims_.value());
    if (stamps_.taken()) {
      const spec::Stamp stamp = stamps_.value();
      memory_.count_hits(stamp);
      listener->stamp(cycle, stamp);
    }
  }
  if (cleared || written) p->last_write = cycle + 1;
  if (at_end && end_ready_.bit() && !p->drained) {
    p->drained = true;
    p->result = counters_.read(cycle - p->start);
  }
  if (moved) p->last_event = last_moved_ = cycle;
  if (cycle - p->last_event > p->deadlock_cycles) {
    throw RtlError(fmt::format("top: nothing moves since cycle {}", p->last_event));
  }
  unit_.clock();
  if (frame_taken) frames_.withdraw();
  if (triangle_taken) {
    triangles_.withdraw();
    p->held = false;
  }
  if (ended) end_valid_.set_bit(false);
  return ended;
}

}  // namespace pineda::tb
