// The Verilated top in a bare loop: what an engineer would write who wants nothing but speed. Sees
// the Verilator header of one design, whose constants come from its package; compiled in one piece
// with what Verilator generates.
#include "tb/bench_plugin.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "Vraster_top.h"
#include "model/spec/pack.h"
#include "verilated.h"

namespace package {
#include "package_constants.inc"
#ifndef PINEDA_DEPTH
constexpr int DEPTH_BITS = 24;
#endif
#ifndef PINEDA_ATTRIBUTES
constexpr int ATTRIBUTES = 0;
#endif
#ifndef PINEDA_FLAT_ATTRIBUTES
constexpr int FLAT_ATTRIBUTES = 0;
#endif
}  // namespace package

struct PinedaBench {
  PinedaBench();
  ~PinedaBench();
  uint64_t run(const PinedaBenchFrame& frame);

 private:
  // Depth data that is under way to the top.
  struct Response {
    uint64_t cycle = 0;
    uint32_t words[(package::LANES * package::DEPTH_BITS + 31) / 32 + 1];
  };
  template <class Outside>
  uint64_t draw(Outside outside);
  void start(const PinedaBenchFrame& frame);
  void ready(uint32_t moving);
  void clear_depth();
  void read(uint64_t due, Response* response);
  void write_depth();
  void write_color();
  void edge();

  VerilatedContext context_;
  std::unique_ptr<Vraster_top> top_;
  PinedaBenchFrame frame_{};
  std::vector<Response> due_;  // read n's is at n modulo its size
};

namespace {

constexpr int kChannels = package::ATTRIBUTES + package::FLAT_ATTRIBUTES;
constexpr uint64_t kDeadlockCycles = 8'000'000;

/// `bits` bits of a port from `position` on.
uint64_t get(QData port, int position, int bits) {
  return port >> position & ((uint64_t{1} << bits) - 1);
}
template <size_t Words>
uint64_t get(const VlWide<Words>& port, int position, int bits) {
  return pineda::spec::get_bits(port.m_storage, position, bits);
}

// Ports lie in one word or less, in two, or in more.
template <class Port>
void set(Port* port, const uint32_t* words) {
  *port = static_cast<Port>(words[0]);
}
void set(QData* port, const uint32_t* words) {
  *port = words[0] | static_cast<uint64_t>(words[1]) << 32;
}
template <size_t Words>
void set(VlWide<Words>* port, const uint32_t* words) {
  std::copy_n(words, Words, port->m_storage);
}

constexpr int kColorPayloadBits =
    (package::FLAT_ATTRIBUTES + package::LANES * package::ATTRIBUTES) * package::ATTR_BITS;

/// The address of the stamp that lies above `payload_bits` of a port and the mask.
template <class Port>
uint64_t stamp_x(const Port& port, int payload_bits) {
  return get(port, payload_bits + package::LANES + package::STAMP_Y_BITS, package::STAMP_X_BITS);
}
template <class Port>
uint64_t stamp_y(const Port& port, int payload_bits) {
  return get(port, payload_bits + package::LANES, package::STAMP_Y_BITS);
}

/// Calls visit(lane, sample) for each lane of that stamp.
template <class Port, class Visit>
void for_each_lane(const Port& port, int payload_bits, int width, Visit visit) {
  using namespace package;
  const uint64_t mask = get(port, payload_bits, LANES);
  const uint64_t y = stamp_y(port, payload_bits) << STAMP_HEIGHT_LOG2;
  const uint64_t x = stamp_x(port, payload_bits) << STAMP_WIDTH_LOG2;
  const uint64_t first = y * static_cast<uint64_t>(width) + x;
  for (int lane = 0; lane < LANES; ++lane) {
    if ((mask >> lane & 1) == 0) continue;
    visit(lane, first + static_cast<uint64_t>((lane >> STAMP_WIDTH_LOG2) * width +
                                              (lane & ((1 << STAMP_WIDTH_LOG2) - 1))));
  }
}

/// Nobody stalls: the compiler leaves all that is about stalls out of the loop.
struct AlwaysReady {
  static constexpr bool kStalls = false;
  uint64_t latency;

  static constexpr uint32_t moving(uint64_t) { return ~uint32_t{0}; }
  template <class Port>
  uint64_t accept(uint32_t, uint64_t cycle, const Port&, int) const {
    return cycle + latency;
  }
};

struct Stalling {
  static constexpr bool kStalls = true;
  const PinedaBenchOutside& outside;

  uint32_t moving(uint64_t cycle) const { return outside.moving(outside.self, cycle); }
  template <class Port>
  uint64_t accept(uint32_t who, uint64_t cycle, const Port& port, int payload_bits) const {
    return outside.accept(outside.self, who, cycle,
                          static_cast<uint32_t>(stamp_x(port, payload_bits)),
                          static_cast<uint32_t>(stamp_y(port, payload_bits)));
  }
};

}  // namespace

PinedaBench::PinedaBench() : top_(std::make_unique<Vraster_top>(&context_)) {
  top_->rst_ni = 0;
  top_->eval();
  edge();
  edge();
  top_->rst_ni = 1;
}

PinedaBench::~PinedaBench() {
  top_->final();
  top_.reset();
  Verilated::threadContextp(Verilated::defaultContextp());
}

// One rising edge. Afterwards the clock is set low, which the next eval() takes up.
void PinedaBench::edge() {
  top_->clk_i = 1;
  top_->eval();
  top_->clk_i = 0;
}

void PinedaBench::start(const PinedaBenchFrame& frame) {
  frame_ = frame;
  const auto samples = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  std::fill_n(frame.color, samples * kChannels, uint16_t{0});
#ifdef PINEDA_DEPTH
  due_.assign(static_cast<size_t>(package::INFLIGHT_STAMPS), Response{});
#else
  std::fill_n(frame.depth, samples, uint32_t{0xffffff});
#endif
  set(&top_->frame_i, frame.state);
  top_->frame_valid_i = 1;
}

// The ports on which the top waits for the outside.
void PinedaBench::ready(uint32_t moving) {
  top_->clear_ready_i = (moving & kPinedaBenchClear) != 0;
  top_->color_wr_ready_i = (moving & kPinedaBenchColorWrite) != 0;
#ifdef PINEDA_DEPTH
  top_->depth_rd_ready_i = (moving & kPinedaBenchDepthRead) != 0;
  top_->depth_wr_ready_i = (moving & kPinedaBenchDepthWrite) != 0;
#endif
}

uint64_t PinedaBench::run(const PinedaBenchFrame& frame) {
  start(frame);
  if (frame.outside != nullptr) return draw(Stalling{*frame.outside});
  return draw(AlwaysReady{static_cast<uint64_t>(frame.depth_latency_cycles)});
}

template <class Outside>
uint64_t PinedaBench::draw(Outside outside) {
  constexpr size_t kTriangleWords = (package::TRIANGLE_BITS + 31) / 32;
  const uint32_t* triangle = frame_.triangles;
  const uint32_t* const end = triangle + frame_.count * kTriangleWords;
  bool offered = false;                             // the triangle, or the end
  [[maybe_unused]] size_t asked = 0, answered = 0;  // reads
  uint64_t last_write = 0;  // the cycle after the last write; the clear counts as one
  uint64_t last_event = 0;
  ready(~uint32_t{0});
  for (uint64_t cycle = 0;; ++cycle) {
    const uint32_t moving = outside.moving(cycle);
    const auto moves = [moving](uint32_t port) { return (moving & port) != 0; };
    if (Outside::kStalls) ready(moving);
    // A triangle is offered from the cycle on in which the one before it is gone.
    offered |= moves(triangle != end ? kPinedaBenchTriangle : kPinedaBenchEnd);
    top_->tri_valid_i = offered && triangle != end;
    top_->end_valid_i = offered && triangle == end;
    if (triangle != end) set(&top_->tri_i, triangle);
#ifdef PINEDA_DEPTH
    const Response& response = due_[answered % due_.size()];
    const bool due = answered != asked && response.cycle <= cycle;
    top_->depth_rsp_valid_i = due;
    if (due) set(&top_->depth_rsp_i, response.words);
#endif
    top_->eval();

    bool written = top_->clear_valid_o != 0 && moves(kPinedaBenchClear);
#ifdef PINEDA_DEPTH
    if (written) clear_depth();
    if (due && top_->depth_rsp_ready_o != 0) ++answered;
    // A read sees the writes accepted before its cycle.
    if (top_->depth_rd_valid_o != 0 && moves(kPinedaBenchDepthRead)) {
      read(outside.accept(kPinedaBenchDepthRead, cycle, top_->depth_rd_o, 0),
           &due_[asked++ % due_.size()]);
    }
    if (top_->depth_wr_valid_o != 0 && moves(kPinedaBenchDepthWrite)) {
      outside.accept(kPinedaBenchDepthWrite, cycle, top_->depth_wr_o,
                     package::LANES * package::DEPTH_BITS);
      write_depth();
      written = true;
    }
#endif
    if (top_->color_wr_valid_o != 0 && moves(kPinedaBenchColorWrite)) {
      outside.accept(kPinedaBenchColorWrite, cycle, top_->color_wr_o, kColorPayloadBits);
      write_color();
      written = true;
    }
    if (written) last_write = last_event = cycle + 1;
    const bool frame_taken = top_->frame_valid_i != 0 && top_->frame_ready_o != 0;
    const bool taken = top_->tri_valid_i != 0 && top_->tri_ready_o != 0;
    const bool ended = top_->end_valid_i != 0 && top_->end_ready_o != 0;
    edge();
    if (frame_taken) top_->frame_valid_i = 0;
    if (taken) {
      triangle += kTriangleWords;
      offered = false;
      last_event = cycle;
    }
    if (ended) break;
    if (cycle > last_event + kDeadlockCycles) return 0;
  }
  top_->end_valid_i = 0;
  return last_write;
}

#ifdef PINEDA_DEPTH
void PinedaBench::clear_depth() {
  const auto samples = static_cast<size_t>(frame_.width) * static_cast<size_t>(frame_.height);
  std::fill_n(frame_.depth, samples, static_cast<uint32_t>(top_->clear_depth_o));
}

void PinedaBench::read(uint64_t due, Response* response) {
  response->cycle = due;
  for_each_lane(top_->depth_rd_o, 0, frame_.width, [&](int lane, uint64_t sample) {
    pineda::spec::set_bits(response->words, lane * package::DEPTH_BITS, package::DEPTH_BITS,
                           frame_.depth[sample]);
  });
}

void PinedaBench::write_depth() {
  const auto& port = top_->depth_wr_o;
  for_each_lane(
      port, package::LANES * package::DEPTH_BITS, frame_.width, [&](int lane, uint64_t sample) {
        frame_.depth[sample] =
            static_cast<uint32_t>(get(port, lane * package::DEPTH_BITS, package::DEPTH_BITS));
      });
}
#endif

void PinedaBench::write_color() {
  using namespace package;
  const auto& port = top_->color_wr_o;
  constexpr int kFlatBits = FLAT_ATTRIBUTES * ATTR_BITS;
  for_each_lane(port, kColorPayloadBits, frame_.width, [&](int lane, uint64_t sample) {
    uint16_t* to = frame_.color + sample * kChannels;
    for (int a = 0; a < ATTRIBUTES; ++a) {
      const int position = kFlatBits + (lane * ATTRIBUTES + a) * ATTR_BITS;
      *to++ = static_cast<uint16_t>(get(port, position, ATTR_BITS));
    }
    for (int a = 0; a < FLAT_ATTRIBUTES; ++a) {
      *to++ = static_cast<uint16_t>(get(port, a * ATTR_BITS, ATTR_BITS));
    }
  });
}

namespace {

#define PINEDA_TEXT_OF(text) #text
#define PINEDA_TEXT(macro) PINEDA_TEXT_OF(macro)

const PinedaBenchPlugin kPlugin = {
    kPinedaBenchAbi,
    PINEDA_RTL_DESIGN,
#include "package_hash.inc"
    ,
#ifdef __clang__
    "clang++ " PINEDA_TEXT(__clang_major__) "." PINEDA_TEXT(__clang_minor__),
#else
    "g++ " PINEDA_TEXT(__GNUC__) "." PINEDA_TEXT(__GNUC_MINOR__),
#endif
    [] { return new PinedaBench; },
    [](PinedaBench* bench) { delete bench; },
    [](PinedaBench* bench, const PinedaBenchFrame* frame) { return bench->run(*frame); },
};

}  // namespace

const PinedaBenchPlugin* pineda_bench_plugin(void) { return &kPlugin; }
