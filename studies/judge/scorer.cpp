#include "studies/judge/scorer.h"

#include <algorithm>
#include <cmath>

#include "model/core/frame.h"

namespace pineda::studies {
namespace {

constexpr uint8_t kMissing = 1;
constexpr uint8_t kExtra = 2;

/// Takes a triangle's fragments apart.
struct FragmentSink {
  const spec::Design& design;
  Scorer* to;
  void prim(const spec::SetupPrim&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) const {
    const int width = 1 << design.stamp_width_log2;
    for (uint32_t mask = stamp.mask; mask != 0; mask &= mask - 1) {
      const int lane = __builtin_ctz(mask);
      const auto l = static_cast<size_t>(lane);
      std::array<int, 4> rgba{};
      for (size_t i = 0; i < rgba.size(); ++i) {
        const auto n = static_cast<size_t>(design.attributes);
        rgba[i] = i < n ? fragment.attr[l][i] : stamp.planes.flat[i - n];
      }
      to->sample({stamp.x * width + lane % width,
                  (stamp.y << design.stamp_height_log2) + lane / width, fragment.z[l], rgba});
    }
  }
};

}  // namespace

Scorer::Scorer(Subject* subject, const spec::FrameState& frame, const spec::Design& design,
               bool with_map)
    : subject_(subject),
      width_(frame.width),
      depth_(design.depth_test),
      perspective_(design.perspective),
      attributes_(static_cast<size_t>(std::min(design.attributes, 4))),
      channels_(static_cast<size_t>(std::min(spec::channels(design), 4))) {
  if (!with_map) return;
  const size_t pixels = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  subject->map.depth_ulp.assign(pixels, -1.0f);
  subject->map.color_lsb.assign(pixels, -1.0f);
  subject->map.coverage.assign(pixels, 0);
}

void Scorer::begin(const Truth& truth) {
  truth_ = &truth;
  seen_.assign(truth.samples().size(), 0);
}

void Scorer::sample(const baseline::Sample& sample) {
  const int64_t index = truth_->find(sample.x, sample.y);
  if (index < 0 || seen_[static_cast<size_t>(index)] != 0) {
    ++subject_->extra;
    wrong(pixel(sample.x, sample.y), kExtra);
    return;
  }
  seen_[static_cast<size_t>(index)] = 1;
  const exact::Sample& truth = truth_->samples()[static_cast<size_t>(index)];
  std::array<double, 4> error{};
  std::array<bool, 4> misrounded{};
  for (size_t i = 0; i < channels_; ++i) {
    if (i >= attributes_) {
      error[i] = sample.rgba[i] - truth_->flat()[i];
      misrounded[i] = error[i] != 0;
      continue;
    }
    const exact::Value& value = truth_->attribute(truth, i, perspective_);
    error[i] = value.error_of(sample.rgba[i]);
    misrounded[i] = sample.rgba[i] != value.nearest;
  }
  values(pixel(sample.x, sample.y), truth.z.error_of(sample.z), sample.z != truth.z.nearest, error,
         misrounded);
}

void Scorer::end() {
  for (size_t i = 0; i < seen_.size(); ++i) {
    if (seen_[i] != 0) continue;
    ++subject_->missing;
    const exact::Sample& truth = truth_->samples()[i];
    wrong(pixel(truth.x, truth.y), kMissing);
  }
}

void Scorer::frame(const VisibleFrame& truth, const VisibleFrame& got) {
  for (size_t p = 0; p < truth.size(); ++p) {
    if (truth.drawn(p) != got.drawn(p)) {
      ++(truth.drawn(p) ? subject_->missing : subject_->extra);
      wrong(p, truth.drawn(p) ? kMissing : kExtra);
    }
    if (!truth.drawn(p) || !got.drawn(p)) continue;
    std::array<double, 4> error{};
    std::array<bool, 4> misrounded{};
    for (size_t i = 0; i < channels_; ++i) {
      error[i] = got.rgba(p)[i] - truth.rgba(p)[i];
      misrounded[i] = error[i] != 0;
    }
    values(p, static_cast<double>(got.z(p) - truth.z(p)), got.z(p) != truth.z(p), error,
           misrounded);
  }
}

void Scorer::values(size_t pixel, double depth_error, bool depth_misrounded,
                    const std::array<double, 4>& color_error,
                    const std::array<bool, 4>& misrounded) {
  ++subject_->judged;
  if (depth_) subject_->depth.add(depth_error, depth_misrounded);
  float worst = 0;
  for (size_t i = 0; i < channels_; ++i) {
    subject_->color.add(color_error[i], misrounded[i]);
    worst = std::max(worst, static_cast<float>(std::abs(color_error[i])));
  }
  ErrorMap& map = subject_->map;
  if (map.coverage.empty()) return;
  if (depth_)
    map.depth_ulp[pixel] =
        std::max(map.depth_ulp[pixel], static_cast<float>(std::abs(depth_error)));
  map.color_lsb[pixel] = std::max(map.color_lsb[pixel], worst);
}

void Scorer::wrong(size_t pixel, uint8_t kind) {
  if (!subject_->map.coverage.empty()) subject_->map.coverage[pixel] |= kind;
}

DesignScorer::DesignScorer(const spec::Design& design, const spec::FrameState& frame, bool with_map)
    : contract_(spec::contract(design)),
      frame_(frame),
      scorer_(&subject_, frame, design, with_map) {
  subject_.name = design.name;
  subject_.summary = design.summary;
  subject_.is_design = true;
  subject_.bounds = spec::error_bounds(design);
}

void DesignScorer::score(const spec::Triangle& triangle, const Truth& truth) {
  // The bound of the triangle that a depth bias makes least certain.
  const double slope = std::ldexp(frame_.bias_slope, -spec::kBiasFactorFractionBits);
  const spec::Design& d = contract_.design;
  subject_.bounds->depth_ulp = std::max(
      subject_.bounds->depth_ulp, spec::error_bounds(d).depth_ulp +
                                      spec::depth_bias_error_bound(d, slope, truth.depth_slope()));
  scorer_.begin(truth);
  core::FrameCounters counters;
  core::draw_triangle(contract_, frame_, {}, triangle, &counters,
                      FragmentSink{contract_.design, &scorer_});
  scorer_.end();
}

}  // namespace pineda::studies
