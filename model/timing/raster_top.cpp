#include "model/timing/raster_top.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "model/memory/kinds.h"

namespace pineda::timing {

namespace {

// Units of a design that cannot be would have no size, so none is made.
const spec::Contract& checked(const spec::Contract& contract) {
  std::string why = spec::invalid_reason(contract.design);
  if (why.empty()) why = spec::no_cycles_reason(contract.design);
  if (why.empty()) return contract;
  why = contract.design.name + (": " + why);
  SC_REPORT_ERROR("pineda/raster_top/design", why.c_str());
  throw std::invalid_argument(why);
}

}  // namespace

// A frame being drawn, however it ends.
class RasterTop::Running {
 public:
  explicit Running(RasterTop* top) : top_(*top) { top_.running_ = true; }
  ~Running() {
    top_.running_ = false;
    top_.frame_.listener = nullptr;
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  RasterTop& top_;
};

RasterTop::RasterTop(sc_core::sc_module_name name, const spec::Contract& contract,
                     Memories memories)
    : sc_module(name),
      contract_(checked(contract)),
      triangles_("triangles", contract),
      setup_("setup", contract),
      prims_("prims", Fifo::kPrims, contract.design.prim_fifo_depth),
      traversal_("traversal", contract),
      stamps_("stamps", contract.design.stamp_fifo_depth),
      interp_ztest_("interp_ztest", contract),
      ports_("memory_ports", contract),
      hierarchical_z_(contract, [this](Cycle cycle) { interp_ztest_.advance(cycle); }),
      last_write_(contract),
      small_walks_(contract) {
  triangles_.tri_o(setup_.tri_i);
  setup_.prim_o(prims_);
  prims_.out_o(traversal_.prim_i);
  traversal_.stamp_o(stamps_);
  stamps_.out_o(interp_ztest_.stamp_i);
  if (contract.design.depth_test) interp_ztest_.depth_io(ports_);
  interp_ztest_.color_wr_o(ports_);
  if (memories == Memories::kOutside) return;
  memory_ = std::make_unique<FrameMemory>(
      "memory", contract,
      memory::make_timing(memory::Kind::kIdeal, contract, contract.design.depth_latency_cycles));
  if (contract.design.depth_test) ports_.depth.socket.bind(memory_->depth_socket);
  ports_.color.socket.bind(memory_->color_socket);
  ports_.depth.set_inside([this](tlm::tlm_command command, Cycle offered) {
    const bool read = command == tlm::TLM_READ_COMMAND;
    return memory_->ready_from(read ? MemoryPort::kDepthRead : MemoryPort::kDepthWrite, offered);
  });
  ports_.color.set_inside([this](tlm::tlm_command, Cycle offered) {
    return memory_->ready_from(MemoryPort::kColorWrite, offered);
  });
}

void RasterTop::end_of_elaboration() {
  const bool depth_missing = contract_.design.depth_test && ports_.depth.socket.size() == 0;
  if (depth_missing) SC_REPORT_FATAL("pineda/raster_top/unbound", ports_.depth.socket.name());
  if (ports_.color.socket.size() == 0) {
    SC_REPORT_FATAL("pineda/raster_top/unbound", ports_.color.socket.name());
  }
}

void RasterTop::set_memory_map(const sc_core::sc_time& period, uint64_t depth_base,
                               uint64_t color_base) {
  period_ = period;
  ports_.depth.set_period(period);
  ports_.color.set_period(period);
  ports_.depth.set_base(depth_base);
  ports_.color.set_base(color_base);
  if (memory_) memory_->set_period(period);
}

void RasterTop::set_depth_latency_cycles(int cycles) {
  set_memory(memory::make_timing(memory::Kind::kIdeal, contract_, cycles));
}

void RasterTop::set_ready(const Ready& ready) {
  ready_ = ready;
  triangles_.set_ready(ready);
  if (memory_) memory_->set_ready(ready);
}

FrameResult RasterTop::run(const spec::FrameState& state, const Pull& pull, Listener* listener) {
  spec::Triangle triangle;
  return draw(
      state,
      [&] {
        return Triangles{&triangle, pull(&triangle) ? size_t{1} : 0};
      },
      listener);
}

FrameResult RasterTop::run(const spec::FrameState& state,
                           const std::vector<spec::Triangle>& triangles, Listener* listener) {
  size_t begun = 0;
  return draw(
      state,
      [&] {
        const size_t first = begun;
        begun = std::min(first + fast::kGroup, triangles.size());
        return Triangles{triangles.data() + first, begun - first};
      },
      listener);
}

FrameResult RasterTop::draw(const spec::FrameState& state, const Next& next, Listener* listener) {
  if (!can_begin(state)) return empty_result(contract_);
  const Running running(this);
  if (!sc_core::sc_start_of_simulation_invoked()) sc_core::sc_start(sc_core::SC_ZERO_TIME);
  begin_frame(state, listener);
  const TriangleSource::Failure failure = triangles_.draw(next, run_from_, &frame_);
  setup_.drain();
  interp_ztest_.drain();
  const FrameResult frame = result();
  pass_time(frame.spent.drained);
  if (failure.thrown) std::rethrow_exception(failure.thrown);
  if (!failure.out_of_range.empty()) {
    SC_REPORT_ERROR("pineda/raster_top/vertex", failure.out_of_range.c_str());
  }
  return frame;
}

// Says why not.
bool RasterTop::can_begin(const spec::FrameState& state) const {
  if (running_) {
    const std::string text = std::string(name()) + " draws a frame already";
    SC_REPORT_ERROR("pineda/raster_top/busy", text.c_str());
    return false;
  }
  const int largest = 1 << contract_.design.guard_bits;
  if (std::min(state.width, state.height) >= 1 && std::max(state.width, state.height) <= largest) {
    return true;
  }
  const std::string text = "expected 1 to " + std::to_string(largest) + " px, got " +
                           std::to_string(state.width) + "x" + std::to_string(state.height);
  SC_REPORT_ERROR("pineda/raster_top/frame", text.c_str());
  return false;
}

// In a process: until the frame's time is over.
void RasterTop::pass_time(Cycle drained) const {
  if (sc_core::sc_get_status() != sc_core::SC_RUNNING) return;
  const auto end =
      begun_ + sc_core::sc_time::from_value(static_cast<uint64_t>(drained) * period_.value());
  if (end > sc_core::sc_time_stamp()) sc_core::wait(end - sc_core::sc_time_stamp());
}

void RasterTop::begin_frame(const spec::FrameState& state, Listener* listener) {
  frame_ = {};
  frame_.state = state;
  frame_.listener = listener;
  hierarchical_z_.begin_frame(state);
  if (contract_.design.hierarchical_z) frame_.hierarchical_z = &hierarchical_z_;
  is_direct_ = listener == nullptr && memory_;
  frame_.tokens = !is_direct_;
  if (is_direct_) {
    begin_direct();
    // Hierarchical z takes tiles out of a walk.
    if (!hierarchical_z_.is_active() && fast::SmallWalks::fit(contract_.design)) {
      small_walks_.begin_frame(state);
      frame_.small_walks = &small_walks_;
    }
  } else {
    ports_.begin_frame(state);
    if (memory_) memory_->begin_frame(state);
  }
  begun_ = sc_core::sc_time_stamp();
  prims_.begin_frame(listener);
  stamps_.begin_frame(listener);
  setup_.begin_frame(&frame_);
  traversal_.begin_frame(&frame_);
  interp_ztest_.begin_frame(&frame_);
  run_from_ = first_ready(ready_, ExternalPort::kClear, kClearOffered) + 1;
}

// Draws without the sockets, straight into a buffer of its own. The memory is inside and nobody
// listens, so nobody can tell the difference.
void RasterTop::begin_direct() {
  const spec::FrameState& state = frame_.state;
  const bool always_ready =
      memory_->is_transparent() && interp_ztest_.keeps_up_with(memory_->fixed_latency());
  if (!always_ready) {
    memory_->begin_timing(state);
    frame_.memory = memory_.get();
  }
  if (!bits_) leave_out_bits();
  if (state.width != direct_.width || state.height != direct_.height) {
    direct_ = fast::TiledBuffer(contract_, state);
  } else {
    direct_.clear_depth = spec::cleared_depth(contract_.design, state);
    if (frame_.has_values) {
      std::fill(direct_.depth.begin(), direct_.depth.end(), direct_.clear_depth);
    }
    if (bits_) std::fill(direct_.color.begin(), direct_.color.end(), 0);
  }
  frame_.buffer = &direct_;
  frame_.depth_latency = memory_->fixed_latency();
}

// Chooses the least that must be computed so that the cycles are right; see set_bits().
void RasterTop::leave_out_bits() {
  if (frame_.memory != nullptr) {
    frame_.planes = fast::Planes::kDepth;
    return;
  }
  frame_.planes = fast::Planes::kNone;
  frame_.has_values = false;
  if (!core::tests_depth(contract_, frame_.state)) return;
  if (hierarchical_z_.is_active()) {
    frame_.planes = fast::Planes::kDepth;
    frame_.has_values = true;
    return;
  }
  last_write_.begin_frame(frame_.state, &direct_);
  frame_.last_write = &last_write_;
}

core::FrameBuffer RasterTop::buffer() const {
  return is_direct_ ? direct_.by_rows(contract_) : memory_->buffer();
}

Cycle RasterTop::idle_from() const {
  return std::max(
      {run_from_, setup_.idle_from(), traversal_.idle_from(), interp_ztest_.idle_from()});
}

FrameResult RasterTop::result() const {
  FrameResult result;
  result.cycles = std::max(interp_ztest_.last_write() + 1, run_from_);
  const Cycle drained = idle_from();
  result.counters = frame_.counters;
  result.counters.stamps = frame_.stamps.stamps;
  result.counters.fragments = frame_.stamps.samples;
  result.spent.stamps_by_samples = frame_.stamps_by_samples;
  result.spent.port_stalls = frame_.port_stalls;
  result.spent.levels = {prims_.levels(drained), traversal_.tile_levels(drained),
                         stamps_.levels(drained)};
  result.knows_passed = frame_.last_write == nullptr;
  result.spent.samples_passed = frame_.counters.passed;
  result.spent.samples_failed = frame_.stamps.samples - frame_.counters.passed;
  result.spent.drained = drained;
  result.spent.units = {setup_.cycles(drained), traversal_.tile_cycles(drained),
                        traversal_.coverage_cycles(drained), traversal_.stamp_cycles(drained),
                        interp_ztest_.cycles(drained)};
  return result;
}

}  // namespace pineda::timing
