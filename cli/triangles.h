// Triangles of a scene on their way into a model, with the time that reading them takes kept apart.
#pragma once

#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

#include "cli/output.h"
#include "model/scene/read_ahead.h"
#include "model/scene/scene.h"

namespace pineda::cli {

/// Is a source read in a thread of its own? Where there is a second processor, and more than a few
/// chunks of triangles.
inline bool is_read_ahead(const scene::SnappedSource& source, size_t few) {
  const bool is_long = !source.size() || *source.size() > few;
  return is_long && std::thread::hardware_concurrency() > 1;
}

/// Reads ahead in chunks, so that memory stays bounded and the clock is asked rarely.
class ChunkedTriangles {
 public:
  static constexpr size_t kChunk = 2048;  // 544 KB: what is drawn stays in a processor's own cache

  /// Reads on from where the source stands: to read a scene again, rewind it first. Until the end
  /// is reached, the source may be ahead of the chunks, and its counters too.
  ChunkedTriangles(scene::SnappedSource* source, Progress* progress, const char* phase)
      : source_(source), progress_(progress), phase_(phase) {
    if (is_read_ahead(*source, kRing * kChunk)) {
      ahead_.emplace(kRing, [this](Chunk* chunk) { return read(chunk); });
    }
  }

  /// The next chunk; empty at the end of the scene.
  const std::vector<spec::Triangle>& next_chunk() {
    load_seconds_ += seconds_of([this] {
      if (!ahead_) read(&own_);
      chunk_ = ahead_ ? ahead_->next() : &own_;
    });
    if (chunk_ == nullptr) chunk_ = &own_;  // which is empty
    at_ = 0;
    count_ += chunk_->size();
    progress_->update(phase_, count_ & ~uint64_t{63});
    return *chunk_;
  }

  /// One by one, for a model that pulls.
  bool next(spec::Triangle* triangle) {
    if (at_ == chunk_->size() && next_chunk().empty()) return false;
    *triangle = (*chunk_)[at_++];
    return true;
  }

  /// While nothing else was done: what is read meanwhile takes no time here.
  double load_seconds() const { return load_seconds_; }

 private:
  using Chunk = std::vector<spec::Triangle>;
  static constexpr size_t kRing = 3;  // one is drawn, one is read, one lies between

  // False at the end.
  bool read(Chunk* chunk) {
    chunk->resize(kChunk);
    chunk->resize(source_->next_many(chunk->data(), kChunk));
    return !chunk->empty();
  }

  scene::SnappedSource* source_;
  Progress* progress_;
  const char* phase_;
  Chunk own_;
  const Chunk* chunk_ = &own_;
  size_t at_ = 0;
  uint64_t count_ = 0;
  double load_seconds_ = 0;
  std::optional<scene::ReadAhead<Chunk>> ahead_;
};

/// Wall times in seconds.
struct FrameSeconds {
  double drawing = 0;            // of one frame, reading left out
  std::optional<double> stream;  // reading included; none where the scene was read beforehand
};

/// `stream` of the JSON: a .ptrb that was drawn while it was read.
inline void report_stream(const scene::Scene& scene, const FrameSeconds& seconds,
                          const Output& output, Json* json) {
  const auto bytes = scene.source->stream_bytes();
  if (!bytes || !seconds.stream) return;
  const double megabytes_per_second = static_cast<double>(*bytes) / *seconds.stream * 1e-6;
  (*json)["stream"]["seconds"] = *seconds.stream;
  (*json)["stream"]["megabytes_per_second"] = megabytes_per_second;
  output.row("stream", fmt::format("{:.6f} s, reading included ({:.1f} MB/s)", *seconds.stream,
                                   megabytes_per_second));
}

/// Everything in memory, for repeated runs.
inline std::vector<spec::Triangle> load_all(scene::SnappedSource* source, Progress* progress) {
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

/// Seconds of a frame: the median of `runs` in memory, or one run straight from the scene when
/// `runs` is 0. run(pull) draws a frame; run(triangles) too where it is there.
template <class Run>
FrameSeconds frame_seconds(const scene::Scene& scene, int runs, Progress* progress,
                           const char* phase, Run run) {
  if (runs == 0) {
    ChunkedTriangles triangles(scene.source.get(), progress, phase);
    const double seconds =
        seconds_of([&] { run([&](spec::Triangle* t) { return triangles.next(t); }); });
    return {seconds - triangles.load_seconds(), seconds};
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
  return {median(seconds), std::nullopt};
}

}  // namespace pineda::cli
