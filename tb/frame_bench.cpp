#include "tb/frame_bench.h"

namespace pineda::tb {

struct FrameBench::Progress {
  uint64_t start = 0;       // cycle in which the frame was first offered
  uint64_t last_event = 0;  // cycle of the last handshake
  uint64_t last_write = 0;  // cycle after the last accepted write (the clear counts)
  uint64_t triangles = 0;
  bool more = true;  // triangles to come
};

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
      memory_(unit_, options.depth_latency_cycles) {
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

FrameResult FrameBench::run(const spec::FrameState& frame, const NextTriangle& next,
                            Listener* listener) {
  memory_.start(core::FrameBuffer(unit_.contract(), frame));
  frames_.offer(frame);
  Progress progress;
  progress.start = progress.last_event = unit_.cycle();
  while (!step(&progress, next, listener)) {
  }
  return {progress.last_write - progress.start, progress.triangles};
}

void FrameBench::run_into_reset(const spec::FrameState& frame, const NextTriangle& next,
                                uint64_t cycles) {
  memory_.start(core::FrameBuffer(unit_.contract(), frame));
  frames_.offer(frame);
  Progress progress;
  progress.start = progress.last_event = unit_.cycle();
  while (unit_.cycle() < progress.start + cycles && !step(&progress, next, nullptr)) {
  }
  reset();
}

// One cycle; true once the end of the frame is taken.
bool FrameBench::step(Progress* p, const NextTriangle& next, Listener* listener) {
  const uint64_t cycle = unit_.cycle();
  // A frame that waits was offered by run(); a triangle follows when its port does not stall.
  if (!triangles_.offered() && p->more && !stalls_(Port::kTriangle, cycle)) {
    spec::Triangle triangle;
    p->more = next(&triangle);
    if (p->more) triangles_.offer(triangle);
  }
  const bool at_end = !p->more && !triangles_.offered();
  if (at_end && !stalls_(Port::kEnd, cycle)) end_valid_.set_bit(true);
  clear_ready_.set_bit(!stalls_(Port::kClear, cycle));
  memory_.drive(stalls_, cycle);
  unit_.settle();

  const bool frame_taken = frames_.taken();
  const bool triangle_taken = triangles_.taken();
  const bool cleared = clear_valid_.bit() && clear_ready_.bit();
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
  if (triangle_taken) ++p->triangles;
  if (moved) p->last_event = cycle;
  if (cycle - p->last_event > kDeadlockCycles) {
    throw RtlError(fmt::format("top: nothing moves since cycle {}", p->last_event));
  }
  unit_.clock();
  if (frame_taken) frames_.withdraw();
  if (triangle_taken) triangles_.withdraw();
  if (ended) end_valid_.set_bit(false);
  return ended;
}

}  // namespace pineda::tb
