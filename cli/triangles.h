// Triangles of a scene on their way into a model, with the time that reading them takes kept apart.
#pragma once

#include <deque>
#include <vector>

#include "cli/output.h"
#include "model/scene/source.h"

namespace pineda::cli {

/// Reads ahead in chunks, so that memory stays bounded and the clock is asked rarely.
class ChunkedTriangles {
 public:
  static constexpr size_t kChunk = 4096;

  ChunkedTriangles(scene::TriangleSource* source, Progress* progress, const char* phase)
      : source_(source), progress_(progress), phase_(phase) {
    source_->rewind();
  }

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

}  // namespace pineda::cli
