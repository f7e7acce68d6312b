// The RTL as fast as it can be simulated: nothing is looked at but its cycles and its frame.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/core/frame.h"
#include "model/timing/counted/cycles.h"
#include "tb/bench_plugin.h"
#include "tb/frame_bench.h"

namespace pineda::tb {

/// The compilers that can build a bench plug-in here: of g++ and clang++ those on the path.
std::vector<std::string> bench_compilers();

/// The top alone of one design, between the memories and the stalls of a FrameBench. Where the
/// memories are ideal and nobody stalls, nothing is asked of either while it runs.
///
/// In       load(): a frame, its triangles, memory and stalls; nothing of them is packed any more
///          when run() starts.
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
            const BenchOptions& options);
  /// Draws what was loaded, as often as wanted; from the first clock edge to the last write.
  timing::Cycle run();

  /// Memories as the last run left them; hits are not counted.
  const core::FrameBuffer& buffer() const { return buffer_; }

 private:
  spec::Contract contract_;
  void* handle_ = nullptr;
  const PinedaBenchPlugin* plugin_ = nullptr;
  PinedaBench* bench_ = nullptr;
  spec::FrameState frame_;
  std::vector<uint32_t> state_, triangles_;  // packed
  uint64_t count_ = 0;                       // of triangles
  class Outside;
  std::unique_ptr<Outside> outside_;
  core::FrameBuffer buffer_;
};

}  // namespace pineda::tb
