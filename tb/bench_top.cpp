#include "tb/bench_top.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "model/spec/pack.h"
#include "model/spec/package.h"
#include "tb/plugin_cache.h"
#include "tb/rtl.h"

namespace pineda::tb {

std::vector<std::string> bench_compilers() {
  std::vector<std::string> compilers;
  for (const char* name : {"g++", "clang++"}) {
    if (on_path(name)) compilers.emplace_back(name);
  }
  return compilers;
}

namespace {

constexpr uint32_t bit_of(Port port) { return uint32_t{1} << static_cast<int>(port); }
static_assert(bit_of(Port::kTriangle) == kPinedaBenchTriangle);
static_assert(bit_of(Port::kEnd) == kPinedaBenchEnd);
static_assert(bit_of(Port::kClear) == kPinedaBenchClear);
static_assert(bit_of(Port::kDepthRead) == kPinedaBenchDepthRead);
static_assert(bit_of(Port::kDepthWrite) == kPinedaBenchDepthWrite);
static_assert(bit_of(Port::kColorWrite) == kPinedaBenchColorWrite);

constexpr Port kPorts[] = {Port::kTriangle,  Port::kEnd,        Port::kClear,
                           Port::kDepthRead, Port::kDepthWrite, Port::kColorWrite};
constexpr MemoryPort kMemories[] = {MemoryPort::kDepthRead, MemoryPort::kDepthWrite,
                                    MemoryPort::kColorWrite};

}  // namespace

/// Memories and stalls, as a MemoryEnd and a FrameBench have them.
class BenchTop::Outside {
 public:
  explicit Outside(const BenchOptions& options)
      : timing_(memory_of(options)), stalls_(options.stall_mode, options.seed) {}

  bool stalls() const { return stalls_.any() || timing_->fixed_latency() == 0; }
  int latency_cycles() const { return static_cast<int>(timing_->fixed_latency()); }
  const PinedaBenchOutside* face() const { return stalls() ? &face_ : nullptr; }

  void begin_frame(const spec::FrameState& frame) { timing_->begin_frame(frame); }

 private:
  uint32_t moving(uint64_t cycle) {
    const auto now = static_cast<Cycle>(cycle);
    uint32_t ports = ~uint32_t{0};
    if (stalls_.any()) {
      ports = 0;
      for (const Port port : kPorts) ports |= moves_(port, now) ? bit_of(port) : 0;
    }
    for (const MemoryPort port : kMemories) {
      if (timing_->ready_from(port, now) != now) ports &= ~bit_of(memory::stalling(port));
    }
    return ports;
  }

  uint64_t accept(uint32_t bit, uint64_t cycle, uint32_t x, uint32_t y) {
    const MemoryPort port = bit == kPinedaBenchDepthRead    ? MemoryPort::kDepthRead
                            : bit == kPinedaBenchDepthWrite ? MemoryPort::kDepthWrite
                                                            : MemoryPort::kColorWrite;
    return static_cast<uint64_t>(
        timing_->accept(port, static_cast<Cycle>(cycle), static_cast<int>(x), static_cast<int>(y)));
  }

  std::shared_ptr<MemoryTiming> timing_;
  Stalls stalls_;
  memory::Moving moves_{stalls_};
  PinedaBenchOutside face_{
      this, [](void* self, uint64_t cycle) { return static_cast<Outside*>(self)->moving(cycle); },
      [](void* self, uint32_t port, uint64_t cycle, uint32_t x, uint32_t y) {
        return static_cast<Outside*>(self)->accept(port, cycle, x, y);
      }};
};

BenchTop::BenchTop(const spec::Contract& contract, const std::string& compiler,
                   const std::function<void(const std::string&)>& say)
    : contract_(contract) {
  const std::string file = cached_bench_plugin(contract, compiler, say);
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) throw PluginError(dlerror());
  using Entry = const PinedaBenchPlugin* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(handle_, "pineda_bench_plugin"));
  plugin_ = entry != nullptr ? entry() : nullptr;
  if (plugin_ == nullptr || plugin_->abi != kPinedaBenchAbi ||
      plugin_->package_hash != spec::package_hash(contract_)) {
    dlclose(handle_);
    throw PluginError(fmt::format("{}: not a bench plug-in of this version and design", file));
  }
  bench_ = plugin_->open();
}

BenchTop::~BenchTop() {
  plugin_->close(bench_);
  dlclose(handle_);
}

void BenchTop::load(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
                    const BenchOptions& options) {
  outside_ = std::make_unique<Outside>(options);
  frame_ = frame;
  buffer_ = core::FrameBuffer(contract_, frame);
  state_ = spec::Packer<spec::FrameState>(contract_).pack(frame);
  const spec::Packer<spec::Triangle> packer(contract_);
  const auto words = static_cast<size_t>(packer.words());
  count_ = triangles.size();
  triangles_.resize(words * triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    packer.pack(triangles[i], triangles_.data() + i * words);
  }
}

timing::Cycle BenchTop::run() {
  outside_->begin_frame(frame_);
  PinedaBenchFrame frame{};
  frame.state = state_.data();
  frame.triangles = triangles_.data();
  frame.count = count_;
  frame.width = buffer_.width;
  frame.height = buffer_.height;
  frame.outside = outside_->face();
  frame.depth_latency_cycles = outside_->latency_cycles();
  frame.depth = buffer_.depth.data();
  frame.color = buffer_.color.data();
  const uint64_t cycles = plugin_->run(bench_, &frame);
  if (cycles == 0) throw RtlError("bench: nothing moves any more");
  return static_cast<timing::Cycle>(cycles);
}

}  // namespace pineda::tb
