// Re-reads an open scene without snapping, so that it can be snapped for another design.
#pragma once

#include <algorithm>

#include "model/scene/snap.h"

namespace pineda::scene {

/// Reads the screen triangles of a source as they were before it snapped them. Triangles that the
/// source dropped or clipped stay dropped or clipped. Counters of snapping are not copied, since
/// snapping again will count.
class Unsnapped final : public ScreenReader {
 public:
  explicit Unsnapped(SnappedSource* source) : source_(source) {}
  explicit Unsnapped(std::unique_ptr<SnappedSource> source)
      : owned_(std::move(source)), source_(owned_.get()) {}

  bool read(ScreenTriangle* triangle, Counters* counters) override {
    const Counters before = source_->counters();
    spec::Triangle snapped;
    const bool is_one = source_->next(&snapped);
    if (is_one) *triangle = source_->screen();
    const Counters& after = source_->counters();
    for (const auto member :
         {&Counters::triangles, &Counters::nan_dropped, &Counters::clipped, &Counters::clipped_away,
          &Counters::perspective, &Counters::affine_colors}) {
      counters->*member += after.*member - before.*member;
    }
    counters->affine_lsb = std::max(counters->affine_lsb, after.affine_lsb);
    counters->rounded_slope = after.rounded_slope;  // set when the scene was opened
    return is_one;
  }
  void rewind() override { source_->rewind(); }
  std::optional<uint64_t> size() const override { return source_->size(); }
  std::optional<uint64_t> stream_bytes() const override { return source_->stream_bytes(); }
  uint64_t skip(uint64_t triangles) override { return source_->skip(triangles); }

 private:
  std::unique_ptr<SnappedSource> owned_;
  SnappedSource* source_;
};

}  // namespace pineda::scene
