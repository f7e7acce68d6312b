#include "model/core/frame.h"

namespace pineda::core {

Interpolator::Interpolator(const spec::Contract& contract, const spec::FrameState& frame,
                           const spec::Triangle& triangle)
    : contract_(contract) {
  if (contract.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    exact_.emplace(contract, frame, triangle);
  }
}

void Interpolator::operator()(const spec::Stamp& stamp, spec::Fragment* fragment) const {
  if (!exact_) return interpolate(contract_, stamp, fragment);
  exact_->depth(contract_, stamp, fragment);
  exact_->attributes(contract_, stamp, stamp.mask, fragment);
}

}  // namespace pineda::core
