#include "vectors/runner/sparse_memories.h"

#include <algorithm>
#include <cstddef>

namespace pineda::vectors {

using spec::Contract;

template <class Visitor>
void SparseMemories::touch(const Contract& c, int x, int y, uint32_t mask, Visitor&& visit) {
  const int left = x << c.design.stamp_width_log2;
  const int top = y << c.design.stamp_height_log2;
  core::for_each_lane(c.design, mask, [&](size_t lane, int column, int row) {
    const Sample cleared{left + column, top + row, clear_depth_, {}, 0};
    visit(lane, &samples_.emplace(std::pair(cleared.y, cleared.x), cleared).first->second);
  });
}

spec::DepthData SparseMemories::read(const Contract& c, int x, int y, uint32_t mask) const {
  const int left = x << c.design.stamp_width_log2;
  const int top = y << c.design.stamp_height_log2;
  spec::DepthData data;
  core::for_each_lane(c.design, mask, [&](size_t lane, int column, int row) {
    const auto sample = samples_.find({top + row, left + column});
    data.z[lane] = sample == samples_.end() ? clear_depth_ : sample->second.depth;
  });
  return data;
}

void SparseMemories::write(const Contract& c, const spec::DepthWrite& w) {
  touch(c, w.x, w.y, w.mask, [&](size_t lane, Sample* sample) { sample->depth = w.z[lane]; });
}

void SparseMemories::write(const Contract& c, const spec::ColorWrite& w) {
  touch(c, w.x, w.y, w.mask, [&](size_t lane, Sample* sample) {
    const auto flat = std::copy_n(w.attr[lane].begin(), c.design.attributes, sample->color.begin());
    std::copy_n(w.flat.begin(), c.design.flat_attributes, flat);
  });
}

void SparseMemories::count_hits(const Contract& c, const spec::Stamp& stamp) {
  touch(c, stamp.x, stamp.y, stamp.mask, [](size_t, Sample* sample) {
    if (sample->hits != UINT16_MAX) ++sample->hits;
  });
}

std::vector<Sample> SparseMemories::samples() const {
  std::vector<Sample> all;
  for (const auto& [place, sample] : samples_) all.push_back(sample);
  return all;
}

}  // namespace pineda::vectors
