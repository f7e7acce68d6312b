#include "studies/cycles/sample.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/scene/read_ahead.h"
#include "model/spec/random.h"

namespace pineda::studies {
namespace {

constexpr uint64_t kWarmUp = 64;
constexpr uint64_t kLongestWindow = 256;
constexpr uint64_t kShortestWindow = 64;
constexpr uint64_t kFewestWindows = 30;

// A block of triangles, by number; `end` is excluded.
struct Block {
  uint64_t begin;
  uint64_t end;
  uint64_t stratum_triangles;
};

class Blocks {
 public:
  Blocks(const SamplePlan& plan, uint64_t seed)
      : plan_(plan), blocks_(plan.triangles / plan.window), random_(seed) {}

  /// Draws a random block from the next stratum.
  std::optional<Block> next() {
    if (stratum_ == plan_.windows) return std::nullopt;
    const uint64_t from = first_block(stratum_);
    const uint64_t until = first_block(++stratum_);
    const uint64_t drawn = from + random_.bits() % (until - from);
    return Block{begin(drawn), begin(drawn + 1), begin(until) - begin(from)};
  }

 private:
  uint64_t first_block(uint64_t stratum) const { return stratum * blocks_ / plan_.windows; }
  uint64_t begin(uint64_t block) const { return block * plan_.triangles / blocks_; }

  SamplePlan plan_;
  uint64_t blocks_;
  spec::Random random_;
  uint64_t stratum_ = 0;
};

/// The triangles of warm-ups and windows, in order. The others are skipped.
class SampledTriangles {
 public:
  SampledTriangles(scene::SnappedSource* source, const SamplePlan& plan, uint64_t seed)
      : source_(*source), plan_(plan), blocks_(plan, seed), block_(blocks_.next()) {
    read();
  }

  bool next(spec::Triangle* triangle) {
    while (block_) {
      read_from(block_->begin - std::min(block_->begin, plan_.warm_up));
      if (number_ < block_->end) {
        *triangle = next_;
        read();
        return true;
      }
      block_ = blocks_.next();
    }
    return false;
  }

 private:
  void read() { number_ = source_.next(&next_) ? next_.id : plan_.triangles; }

  // Reads up to triangle `number`. Clipped pieces of a triangle share its number; dropped triangles
  // leave gaps.
  void read_from(uint64_t number) {
    while (number_ < number) {
      if (number_ + 1 < number) source_.skip(number - number_ - 1);
      read();
    }
  }

  scene::SnappedSource& source_;
  SamplePlan plan_;
  Blocks blocks_;
  std::optional<Block> block_;
  spec::Triangle next_;  // read ahead, not yet handed over
  uint64_t number_ = 0;  // number of next_; at the end, the number of triangles
};

/// Feeds warm-ups and windows to the model, and measures by how many cycles each window delays the
/// cycle in which the pipeline is empty. Triangles are read and skipped while the model works.
class Sampler {
 public:
  Sampler(const timing::RasterTop& top, scene::SnappedSource* source, const SamplePlan& plan,
          uint64_t seed)
      : top_(top),
        plan_(plan),
        blocks_(plan, seed),
        block_(blocks_.next()),
        ahead_(kRing, [source, plan, seed,
                       triangles = std::optional<SampledTriangles>()](Chunk* chunk) mutable {
          if (!triangles) triangles.emplace(source, plan, seed);
          chunk->resize(kChunk);
          size_t count = 0;
          while (count < kChunk && triangles->next(&(*chunk)[count])) ++count;
          chunk->resize(count);
          return count > 0;
        }) {
    read();
  }

  bool pull(spec::Triangle* triangle) {
    if (simulated_ == 1) started_ = top_.idle_from();
    while (block_) {
      if (!begun_ && number_ >= block_->begin && simulated_ > 0) begun_ = top_.idle_from();
      if (number_ < block_->end) {
        *triangle = (*chunk_)[at_++];
        ++simulated_;
        read();
        return true;
      }
      end_window();
    }
    ended_ = top_.idle_from();
    return false;
  }

  /// The cycle in which the first triangle has left the pipeline. The cycles until then fill the
  /// pipeline and belong to no window.
  timing::Cycle started() const { return started_; }
  /// The cycle in which all triangles have left the pipeline.
  timing::Cycle ended() const { return ended_; }
  uint64_t simulated() const { return simulated_; }
  const std::vector<SampledWindow>& windows() const { return windows_; }

 private:
  using Chunk = std::vector<spec::Triangle>;
  static constexpr size_t kRing = 3;
  static constexpr size_t kChunk = kLongestWindow + kWarmUp;

  // Looks at the next triangle; at the end its number is that of all triangles.
  void read() {
    if (chunk_ != nullptr && at_ == chunk_->size()) chunk_ = nullptr;
    if (chunk_ == nullptr) {
      chunk_ = ahead_.next();
      at_ = 0;
    }
    number_ = chunk_ != nullptr ? (*chunk_)[at_].id : plan_.triangles;
  }

  void end_window() {
    const timing::Cycle now = top_.idle_from();
    windows_.push_back(
        {block_->stratum_triangles, block_->end - block_->begin, now - begun_.value_or(now)});
    begun_.reset();
    block_ = blocks_.next();
  }

  const timing::RasterTop& top_;
  SamplePlan plan_;
  Blocks blocks_;
  std::optional<Block> block_;
  timing::Cycle started_ = 0;
  timing::Cycle ended_ = 0;
  std::optional<timing::Cycle> begun_;  // the cycle in which the window begins
  uint64_t simulated_ = 0;
  std::vector<SampledWindow> windows_;
  const Chunk* chunk_ = nullptr;
  size_t at_ = 0;        // of the next triangle in *chunk_
  uint64_t number_ = 0;  // its number
  scene::ReadAhead<Chunk> ahead_;
};

double cycles_a_triangle(const SampledWindow& window) {
  return static_cast<double>(window.cycles) / static_cast<double>(window.triangles);
}

// Variance and skewness of the cycles per triangle within a stratum.
struct Moments {
  double variance = 0;
  double skewness = 0;
};

Moments moments_of(const std::vector<SampledWindow>& windows) {
  std::vector<double> x;
  for (const SampledWindow& window : windows) x.push_back(cycles_a_triangle(window));
  double squares = 0;
  double bend_squares = 0;
  double bend_cubes = 0;
  for (size_t i = 1; i < x.size(); ++i) {
    squares += (x[i] - x[i - 1]) * (x[i] - x[i - 1]);
    if (i + 1 == x.size()) break;
    const double bend = x[i] - (x[i - 1] + x[i + 1]) / 2;
    bend_squares += bend * bend;
    bend_cubes += bend * bend * bend;
  }
  const auto n = static_cast<double>(x.size());
  Moments moments;
  moments.variance = squares / (2 * (n - 1));
  const double second = bend_squares / (n - 2) / 1.5;
  if (second > 0) moments.skewness = bend_cubes / (n - 2) / .75 / std::pow(second, 1.5);
  return moments;
}

}  // namespace

std::optional<SamplePlan> plan_sample(uint64_t triangles, double share) {
  const double simulated = share * static_cast<double>(triangles);
  const auto window =
      static_cast<int64_t>(simulated / kFewestWindows) - static_cast<int64_t>(kWarmUp);
  SamplePlan plan;
  plan.triangles = triangles;
  plan.warm_up = kWarmUp;
  plan.window = static_cast<uint64_t>(std::clamp<int64_t>(window, kShortestWindow, kLongestWindow));
  const uint64_t run = plan.window + plan.warm_up;
  plan.windows =
      std::max(static_cast<uint64_t>(simulated / static_cast<double>(run)), kFewestWindows);
  if (2 * plan.windows * run > triangles) return std::nullopt;
  return plan;
}

// Cornish-Fisher expansion around the quantile of the normal distribution.
double student_t_95(double degrees) {
  constexpr double z = 1.959963985;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  return z + (z3 + z) / (4 * degrees) + (5 * z5 + 16 * z3 + 3 * z) / (96 * degrees * degrees) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * degrees * degrees * degrees);
}

CycleEstimate estimate_cycles(const std::vector<SampledWindow>& windows,
                              timing::Cycle other_cycles) {
  if (windows.size() < 3) throw std::invalid_argument("estimate: expected three windows or more");
  const Moments moments = moments_of(windows);
  CycleEstimate estimate;
  double squares = 0;
  for (const SampledWindow& window : windows) {
    const auto triangles = static_cast<double>(window.stratum_triangles);
    estimate.cycles += triangles * cycles_a_triangle(window);
    squares += triangles * (triangles - static_cast<double>(window.triangles)) * moments.variance;
  }
  estimate.cycles += static_cast<double>(other_cycles);
  const auto n = static_cast<double>(windows.size());
  const double degrees = 2 * (n - 1) * (n - 1) / (3 * n - 4);
  estimate.half_width = student_t_95(degrees) * std::sqrt(squares);
  estimate.skewness = moments.skewness;
  const double skewness = std::max(0., moments.skewness);
  estimate.windows_wanted = static_cast<uint64_t>(std::ceil(25 * skewness * skewness));
  return estimate;
}

SampleResult sample_cycles(timing::RasterTop* top, const spec::Contract& contract,
                           const spec::FrameState& frame, scene::SnappedSource* source,
                           const SamplePlan& plan, uint64_t seed,
                           const std::function<void(uint64_t)>& progress) {
  if (contract.design.hierarchical_z) {
    throw std::invalid_argument("sample: hierarchical z wants the depth of every triangle");
  }
  Sampler sampler(*top, source, plan, seed);
  const auto frame_result = top->run(frame, [&](spec::Triangle* triangle) {
    if (progress) progress(sampler.simulated());
    return sampler.pull(triangle);
  });
  SampleResult result;
  result.windows = sampler.windows();
  result.estimate = estimate_cycles(
      result.windows, sampler.started() + frame_result.spent.drained - sampler.ended());
  for (const SampledWindow& window : result.windows) result.counted += window.triangles;
  result.simulated = sampler.simulated();
  return result;
}

}  // namespace pineda::studies
