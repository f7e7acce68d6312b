#include "tb/unit_bench.h"

namespace pineda::tb {
namespace {

class WriteRecorder : public Listener {
 public:
  explicit WriteRecorder(InterpZtestBench::Writes* writes) : writes_(writes) {}
  void depth(Cycle cycle, const spec::DepthWrite& write) override {
    writes_->depth.add(cycle, write);
  }
  void color(Cycle cycle, const spec::ColorWrite& write) override {
    writes_->color.add(cycle, write);
  }

 private:
  InterpZtestBench::Writes* writes_;
};

}  // namespace

InterpZtestBench::InterpZtestBench(const RtlLibrary& library, const BenchOptions& options)
    : unit_(library, "interp_ztest"),
      stalls_(options.stall_mode, options.seed),
      stamps_(unit_, "stamp"),
      idle_(unit_.port("idle_o")),
      memory_(unit_, memory_of(options)) {
  if (unit_.contract().design.depth_test) {
    depth_func_ = unit_.port("depth_func_i");
    depth_write_ = unit_.port("depth_write_i");
  }
  unit_.reset();
}

InterpZtestBench::Writes InterpZtestBench::run_on(PagedBuffer memory, const spec::FrameState& frame,
                                                  const std::vector<spec::Stamp>& stamps,
                                                  std::vector<Cycle>* accepted) {
  Writes writes;
  WriteRecorder recorder(&writes);
  if (depth_func_) {
    *static_cast<uint8_t*>(depth_func_->data) = static_cast<uint8_t>(frame.depth);
    depth_write_->set_bit(frame.depth_write);
  }
  if (unit_.contract().design.hierarchical_z) {
    *static_cast<uint16_t*>(unit_.port("frame_width_i").data) = static_cast<uint16_t>(frame.width);
    *static_cast<uint16_t*>(unit_.port("frame_height_i").data) =
        static_cast<uint16_t>(frame.height);
  }
  memory_.start(frame, std::move(memory), unit_.cycle());
  size_t next = 0;
  const Cycle start = unit_.cycle();
  Cycle last_event = start;
  for (bool done = false; !done;) {
    const Cycle cycle = unit_.cycle();
    if (!stamps_.offered() && next < stamps.size() && !stalls_(Port::kInput, cycle - start)) {
      stamps_.offer(stamps[next++]);
    }
    memory_.drive(stalls_, cycle);
    unit_.settle();
    const bool took = stamps_.taken();
    const bool wrote = memory_.sample(cycle, &recorder);
    if (took && accepted != nullptr) accepted->push_back(cycle);
    if (took || wrote) last_event = cycle;
    if (cycle - last_event > deadlock_cycles(frame)) {
      throw RtlError(fmt::format("interp_ztest: nothing moves since cycle {}", last_event));
    }
    require_in_time(unit_, start, cycle_limit_);
    done = next == stamps.size() && !stamps_.offered() && idle_.bit();
    unit_.clock();
    if (took) stamps_.withdraw();
  }
  return writes;
}

}  // namespace pineda::tb
