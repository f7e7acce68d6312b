// Triangles of a scene on their way into a model, with the time that reading them takes kept apart.
#pragma once

#include <type_traits>
#include <vector>

#include "cli/output.h"
#include "model/scene/scene.h"

namespace pineda::cli {

/// Reads ahead in chunks, so that memory stays bounded and the clock is asked rarely.
class ChunkedTriangles {
 public:
  static constexpr size_t kChunk = 4096;

  /// Reads on from where the source stands: to read a scene again, rewind it first.
  ChunkedTriangles(scene::TriangleSource* source, Progress* progress, const char* phase)
      : source_(source), progress_(progress), phase_(phase) {}

  /// The next chunk; empty at the end of the scene.
  const std::vector<spec::Triangle>& next_chunk() {
    load_seconds_ += seconds_of([this] {
      chunk_.clear();
      spec::Triangle triangle;
      while (chunk_.size() < kChunk && source_->next(&triangle)) chunk_.push_back(triangle);
    });
    at_ = 0;
    count_ += chunk_.size();
    progress_->update(phase_, count_ & ~uint64_t{63});
    return chunk_;
  }

  /// One by one, for a model that pulls.
  bool next(spec::Triangle* triangle) {
    if (at_ == chunk_.size() && next_chunk().empty()) return false;
    *triangle = chunk_[at_++];
    return true;
  }

  double load_seconds() const { return load_seconds_; }

 private:
  scene::TriangleSource* source_;
  Progress* progress_;
  const char* phase_;
  std::vector<spec::Triangle> chunk_;
  size_t at_ = 0;
  uint64_t count_ = 0;
  double load_seconds_ = 0;
};

/// Everything in memory, for repeated runs.
inline std::vector<spec::Triangle> load_all(scene::TriangleSource* source, Progress* progress) {
  std::vector<spec::Triangle> all;
  ChunkedTriangles triangles(source, progress, "loading");
  for (auto* chunk = &triangles.next_chunk(); !chunk->empty(); chunk = &triangles.next_chunk()) {
    all.insert(all.end(), chunk->begin(), chunk->end());
  }
  return all;
}

/// Pulls from a vector.
inline auto pull_from(const std::vector<spec::Triangle>& triangles) {
  return [&triangles, i = size_t{0}](spec::Triangle* triangle) mutable {
    if (i == triangles.size()) return false;
    *triangle = triangles[i++];
    return true;
  };
}

/// Seconds of a frame, reading left out: the median of `runs` in memory, or one run straight from
/// the scene when `runs` is 0. run(pull) draws a frame; run(triangles) too where it is there.
template <class Run>
double frame_seconds(const scene::Scene& scene, int runs, Progress* progress, const char* phase,
                     Run run) {
  if (runs == 0) {
    ChunkedTriangles triangles(scene.source.get(), progress, phase);
    const double seconds =
        seconds_of([&] { run([&](spec::Triangle* t) { return triangles.next(t); }); });
    return seconds - triangles.load_seconds();
  }
  const auto triangles = load_all(scene.source.get(), progress);
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    seconds.push_back(seconds_of([&] {
      if constexpr (std::is_invocable_v<Run, const std::vector<spec::Triangle>&>) {
        run(triangles);
      } else {
        run(pull_from(triangles));
      }
    }));
  }
  return median(seconds);
}

}  // namespace pineda::cli
