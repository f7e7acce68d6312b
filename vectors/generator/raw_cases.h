// Cases with tokens as no triangle gives them. The exact judge cannot check them: core alone defines what
// comes of them.
#pragma once

#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// Stamps with random planes: they wrap, clamp and round where scenes cannot. Of a design with perspective
/// see raw_weights(): these stamps have no edges.
InterpZtestCase raw_stamps(const spec::Contract& contract, uint64_t seed, int index);

/// Stamps of a design with perspective that hang on the last bits of their weights: at one sample of each,
/// attributes are as close to half a code as its weights allow, above and below. Edge functions are small,
/// of any length, or powers of two, as are 1/w and the edges' coefficients.
InterpZtestCase raw_weights(const spec::Contract& contract, uint64_t seed, int index);

/// SetupPrims whose edges bound no triangle: each falls any way, and passes near the box or at any
/// distance.
TraversalCase raw_prims(const spec::Contract& contract, uint64_t seed, int index);

}  // namespace pineda::vectors
