#include "studies/judge/scene_truth.h"

namespace pineda::studies {

void TruthCache::start(const exact::Format& format) {
  if (format.depth_bits == depth_bits_) return;
  depth_bits_ = format.depth_bits;
  kept_.clear();
  samples_ = 0;
}

const judge::ScreenTruth& TruthCache::truth(size_t number, const exact::ScreenJudge& judge,
                                            exact::Span rows) {
  const exact::Span all = judge.rows();
  const bool is_whole = rows.first == all.first && rows.last == all.last;
  if (is_whole && number < kept_.size()) return kept_[number];
  other_.judge(judge, rows);
  if (!is_whole || number != kept_.size() || samples_ + other_.samples().size() > most_samples_) {
    return other_;
  }
  samples_ += other_.samples().size();
  return kept_.emplace_back(other_);
}

}  // namespace pineda::studies
