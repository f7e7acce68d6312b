#include "studies/judge/scorer.h"

#include <algorithm>
#include <cmath>

#include "model/judge/drawing.h"

namespace pineda::studies {
namespace {

constexpr uint8_t kMissing = 1;
constexpr uint8_t kExtra = 2;

judge::Values colors_of(const spec::Design& design) {
  judge::Values values = judge::values_of(design);
  values.smooth = std::min(values.smooth, 4);
  values.channels = std::min(values.channels, 4);
  return values;
}

}  // namespace

Scorer::Scorer(Subject* subject, const spec::FrameState& frame, const spec::Design& design,
               bool with_map)
    : subject_(subject), width_(frame.width), values_(colors_of(design)) {
  if (!with_map) return;
  const size_t pixels = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  subject->map.depth_ulp.assign(pixels, -1.0f);
  subject->map.color_lsb.assign(pixels, -1.0f);
  subject->map.coverage.assign(pixels, 0);
}

void Scorer::begin(const judge::Truth& truth) {
  truth_ = &truth;
  seen_.begin(truth);
}

void Scorer::sample(const judge::Drawn& drawn) {
  const size_t at = pixel(drawn.x, drawn.y);
  if (seen_.draw(drawn.x, drawn.y) == judge::Found::kRight) {
    return values(at, truth_->errors(values_, drawn));
  }
  ++subject_->extra;
  wrong(at, kExtra);
}

void Scorer::sample(const baseline::Sample& sample) {
  judge::Drawn drawn{sample.x, sample.y, sample.z, {}};
  std::copy(sample.rgba.begin(), sample.rgba.end(), drawn.attr.begin());
  this->sample(drawn);
}

void Scorer::end() {
  seen_.for_each_missing([this](int x, int y) {
    ++subject_->missing;
    wrong(pixel(x, y), kMissing);
  });
}

void Scorer::frame(const judge::VisibleFrame& truth, const judge::VisibleFrame& got) {
  const auto against = [](int64_t code, int64_t wanted) {
    return judge::Error{static_cast<double>(code - wanted), code != wanted};
  };
  for (size_t p = 0; p < truth.size(); ++p) {
    if (truth.drawn(p) != got.drawn(p)) {
      ++(truth.drawn(p) ? subject_->missing : subject_->extra);
      wrong(p, truth.drawn(p) ? kMissing : kExtra);
    }
    if (!truth.drawn(p) || !got.drawn(p)) continue;
    judge::Errors errors;
    errors.depth = against(got.z(p), truth.z(p));
    for (size_t i = 0; i < got.rgba(p).size(); ++i) {
      errors.attr[i] = against(got.rgba(p)[i], truth.rgba(p)[i]);
    }
    values(p, errors);
  }
}

void Scorer::values(size_t pixel, const judge::Errors& errors) {
  ++subject_->judged;
  if (values_.depth) subject_->depth.add(errors.depth.units, errors.depth.is_misrounded);
  float worst = 0;
  for (size_t i = 0; i < static_cast<size_t>(values_.channels); ++i) {
    subject_->color.add(errors.attr[i].units, errors.attr[i].is_misrounded);
    worst = std::max(worst, static_cast<float>(std::abs(errors.attr[i].units)));
  }
  ErrorMap& map = subject_->map;
  if (map.coverage.empty()) return;
  if (values_.depth)
    map.depth_ulp[pixel] =
        std::max(map.depth_ulp[pixel], static_cast<float>(std::abs(errors.depth.units)));
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

void DesignScorer::score(const spec::Triangle& triangle, const judge::ScreenTruth& truth) {
  // A depth bias widens the bound by the triangle's slope: the widest one is reported.
  const auto bounds = judge::triangle_bounds(contract_.design, frame_, truth.depth_slope());
  subject_.bounds->depth_ulp = std::max(subject_.bounds->depth_ulp, bounds.depth_ulp);
  scorer_.begin(truth);
  judge::for_each_sample(contract_, frame_, triangle,
                         [this](const judge::Drawn& drawn) { scorer_.sample(drawn); });
  scorer_.end();
}

}  // namespace pineda::studies
