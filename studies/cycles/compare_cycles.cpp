#include "studies/cycles/compare_cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "model/timing/counted/counters.h"
#include "model/timing/raster_top.h"
#include "studies/cycles/child.h"
#include "studies/cycles/retirement.h"
#include "tb/bench_top.h"
#include "tb/frame_bench.h"
#include "tb/ready.h"

namespace pineda::studies {
namespace {

using timing::Cycle;

/// Notes the cycle of each triangle's last write.
class Retirement final : public timing::Listener {
 public:
  void depth(Cycle cycle, const spec::DepthWrite& write) override {
    retired_.note(cycle, write.id);
  }
  void color(Cycle cycle, const spec::ColorWrite& write) override {
    retired_.note(cycle, write.id);
  }
  const std::vector<int64_t>& cycles() const { return retired_.cycles(); }

 private:
  RetireCycles retired_;
};

// CPU time of this process, so that other processes do not disturb the measurement.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Run>
double seconds_of(Run run) {
  const double start = cpu_seconds();
  run();
  return cpu_seconds() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

auto pull_from(const std::vector<spec::Triangle>& triangles) {
  return [&triangles, i = size_t{0}](spec::Triangle* triangle) mutable {
    if (i == triangles.size()) return false;
    *triangle = triangles[i++];
    return true;
  };
}

bool same(const core::FrameBuffer& a, const core::FrameBuffer& b) {
  return a.depth == b.depth && a.color == b.color;
}

/// The RTL under the listening bench, and the bare RTL whose speed is measured.
struct Rtl {
  tb::RtlLibrary library;
  std::vector<std::unique_ptr<tb::BenchTop>> bare;

  Rtl(const spec::Contract& contract, const CycleOptions& options)
      : library(contract, options.say) {
    if (options.runs == 0) return;
    for (const std::string& compiler : options.compilers) {
      bare.push_back(std::make_unique<tb::BenchTop>(contract, compiler, options.say));
    }
  }
};

/// One frame on the model and on the RTL.
class Comparison {
 public:
  Comparison(Rtl* rtl, const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
             const CycleOptions& options)
      : rtl_(*rtl),
        frame_(frame),
        triangles_(triangles),
        options_(options),
        model_("raster_top", rtl->library.contract()) {
    model_.set_memory(timing());
    model_.set_ready(tb::ready_of({options.stall_mode, options.seed}));
  }

  CyclePoint run() {
    compare();
    if (options_.runs > 0) measure();
    return point_;
  }

 private:
  /// Called for the model and for each RTL: each has its own memory.
  std::shared_ptr<memory::MemoryTiming> timing() const {
    return memory::make_timing(options_.memory, rtl_.library.contract(),
                               options_.depth_latency_cycles);
  }

  tb::BenchOptions bench_options() const {
    tb::BenchOptions bench_options;
    bench_options.memory = timing();
    bench_options.stall_mode = options_.stall_mode;
    bench_options.seed = options_.seed;
    return bench_options;
  }

  void compare() {
    tb::FrameBench bench(rtl_.library, bench_options());
    Retirement rtl;
    const timing::FrameResult of_rtl = bench.run(frame_, pull_from(triangles_), &rtl);
    Retirement model;
    model_.set_bits(true);
    const timing::FrameResult of_model = model_.run(frame_, triangles_, &model);
    point_.rtl_cycles = of_rtl.cycles;
    point_.model_cycles = of_model.cycles;
    point_.same_frame = same(model_.buffer(), bench.buffer());
    point_.retire = retire_errors(model.cycles(), rtl.cycles());
    compare_counters(of_model, of_rtl);
  }

  void compare_counters(const timing::FrameResult& model, const timing::FrameResult& rtl) {
    const spec::Contract& contract = rtl_.library.contract();
    const auto counters = timing::counter_list(contract, model);
    const auto differences =
        timing::counter_differences(counters, timing::counter_list(contract, rtl));
    point_.counters = counters.size();
    point_.counters_off = differences.size();
    if (differences.empty()) return;
    const std::string& name = differences.front().name;
    name.copy(point_.first_counter.data(), point_.first_counter.size() - 1);
  }

  void measure() {
    for (const auto& top : rtl_.bare) top->load(frame_, triangles_, bench_options());
    std::vector<double> time, bits;
    std::vector<std::vector<double>> rtl(rtl_.bare.size());
    for (int i = 0; i < options_.runs; ++i) {
      time.push_back(model_seconds(false));
      bits.push_back(model_seconds(true));
      for (size_t k = 0; k < rtl_.bare.size(); ++k)
        rtl[k].push_back(rtl_seconds(rtl_.bare[k].get()));
    }
    point_.time_seconds = median(time);
    point_.bits_seconds = median(bits);
    point_.compilers = std::min(rtl_.bare.size(), point_.rtl.size());
    for (size_t k = 0; k < point_.compilers; ++k) {
      rtl_.bare[k]->compiler().copy(point_.rtl[k].compiler.data(),
                                    point_.rtl[k].compiler.size() - 1);
      point_.rtl[k].seconds = median(rtl[k]);
    }
  }

  double model_seconds(bool bits) {
    model_.set_bits(bits);
    int64_t cycles = 0;
    const double seconds = seconds_of([&] { cycles = model_.run(frame_, triangles_).cycles; });
    require(cycles == point_.model_cycles, "the model", cycles, point_.model_cycles);
    return seconds;
  }

  double rtl_seconds(tb::BenchTop* top) const {
    int64_t cycles = 0;
    const double seconds = seconds_of([&] { cycles = top->run(); });
    require(cycles == point_.rtl_cycles, "the bare RTL", cycles, point_.rtl_cycles);
    if (point_.same_frame && !same(top->buffer(), model_.buffer())) {
      throw std::runtime_error("the bare RTL draws another frame");
    }
    return seconds;
  }

  static void require(bool holds, const char* who, int64_t got, int64_t expected) {
    if (holds) return;
    throw std::runtime_error(
        fmt::format("{} takes {} cycles, and {} under a listener", who, got, expected));
  }

  Rtl& rtl_;
  const spec::FrameState& frame_;
  const std::vector<spec::Triangle>& triangles_;
  const CycleOptions& options_;
  timing::RasterTop model_;
  CyclePoint point_;
};

}  // namespace

RetireErrors retire_errors(const std::vector<int64_t>& model, const std::vector<int64_t>& rtl) {
  const auto of = [](const std::vector<int64_t>& cycles, size_t id) {
    return id < cycles.size() ? cycles[id] : -1;
  };
  RetireErrors errors;
  std::vector<int64_t> sizes;
  for (size_t id = 0; id < std::max(model.size(), rtl.size()); ++id) {
    const int64_t expected = of(rtl, id);
    const int64_t got = of(model, id);
    if (expected < 0 && got < 0) continue;
    sizes.push_back(std::abs(got - expected));
    if (sizes.back() > errors.max) {
      errors.max = sizes.back();
      errors.worst = static_cast<uint32_t>(id);
    }
    errors.off += sizes.back() != 0 ? 1 : 0;
  }
  errors.triangles = sizes.size();
  if (!sizes.empty()) {
    const size_t rank = (sizes.size() * 99 + 99) / 100 - 1;  // the nearest-rank percentile
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(rank), sizes.end());
    errors.p99 = sizes[rank];
  }
  return errors;
}

double CyclePoint::error() const {
  return static_cast<double>(std::abs(model_cycles - rtl_cycles)) /
         static_cast<double>(std::max<int64_t>(1, rtl_cycles));
}

bool CyclePoint::is_off() const {
  return model_cycles != rtl_cycles || retire.off != 0 || counters_off != 0 || !same_frame;
}

bool CyclePoint::holds(bool stalls) const {
  if (!stalls) return !is_off();
  return error() <= kCycleErrorBound && retire.p99 <= kRetireP99Bound && counters_off == 0 &&
         same_frame;
}

const RtlSpeed* CyclePoint::fastest() const {
  const auto* end = rtl.data() + compilers;
  const auto* least = std::min_element(
      rtl.data(), end, [](const RtlSpeed& a, const RtlSpeed& b) { return a.seconds < b.seconds; });
  return least == end ? nullptr : least;
}

CyclePoint compare_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                          const std::vector<spec::Triangle>& triangles,
                          const CycleOptions& options) {
  Rtl rtl(contract, options);
  try {
    return in_child([&] { return Comparison(&rtl, frame, triangles, options).run(); });
  } catch (const std::runtime_error& error) {
    throw tb::RtlError(error.what());
  }
}

}  // namespace pineda::studies
