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
                    int depth_latency_cycles) {
  if (depth_latency_cycles < 1 || depth_latency_cycles > spec::kMaxDepthLatencyCycles) {
    throw RtlError(fmt::format("depth latency is {} cycles, must be 1 to {}", depth_latency_cycles,
                               spec::kMaxDepthLatencyCycles));
  }
  depth_latency_cycles_ = depth_latency_cycles;
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
  const PinedaBenchFrame frame{state_.data(),        triangles_.data(),   count_,
                               buffer_.width,        buffer_.height,      depth_latency_cycles_,
                               buffer_.depth.data(), buffer_.color.data()};
  const uint64_t cycles = plugin_->run(bench_, &frame);
  if (cycles == 0) throw RtlError("bench: nothing moves any more");
  return static_cast<timing::Cycle>(cycles);
}

}  // namespace pineda::tb
