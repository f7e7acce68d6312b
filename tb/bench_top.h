// The RTL as fast as it can be simulated: nothing is looked at but its cycles and its frame.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/core/frame.h"
#include "model/timing/counted/cycles.h"
#include "tb/bench_plugin.h"

namespace pineda::tb {

/// The compilers that can build a bench plug-in here: of g++ and clang++ those on the path.
std::vector<std::string> bench_compilers();

/// The top alone of one design, with ideal memories and without stalls.
///
/// In       load(): a frame, its triangles, the latency of the depth memory; nothing of them is
///          packed any more when run() starts.
/// Out      the cycles, which are those of FrameBench; buffer().
/// Errors   PluginError: the plug-in cannot be had; RtlError: a latency out of range, a deadlock.
class BenchTop {
 public:
  BenchTop(const spec::Contract& contract, const std::string& compiler,
           const std::function<void(const std::string&)>& say = {});
  ~BenchTop();
  BenchTop(const BenchTop&) = delete;
  BenchTop& operator=(const BenchTop&) = delete;

  /// "g++ 12.2".
  std::string compiler() const { return plugin_->compiler; }

  void load(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
            int depth_latency_cycles);
  /// Draws what was loaded, as often as wanted; from the first clock edge to the last write.
  timing::Cycle run();

  /// Memories as the last run left them; hits are not counted.
  const core::FrameBuffer& buffer() const { return buffer_; }

 private:
  spec::Contract contract_;
  void* handle_ = nullptr;
  const PinedaBenchPlugin* plugin_ = nullptr;
  PinedaBench* bench_ = nullptr;
  std::vector<uint32_t> state_, triangles_;  // packed
  uint64_t count_ = 0;                       // of triangles
  int depth_latency_cycles_ = 1;
  core::FrameBuffer buffer_;
};

}  // namespace pineda::tb
