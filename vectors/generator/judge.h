// Scenes before the exact judge: no vector is written that exact arithmetic does not bear out.
#pragma once

#include <optional>
#include <string>

#include "model/spec/bounds.h"
#include "vectors/generator/scenes.h"

namespace pineda::vectors {

/// Nothing, if each triangle is dropped for a true cause or is drawn with exactly its samples and
/// with depth and attributes within the bounds; else what is wrong, in one line. A triangle of
/// more than 4096 samples is judged on 32 of its rows, from its SetupPrim.
std::optional<std::string> misjudged(const spec::Contract& contract, const Scene& scene,
                                     const spec::ErrorBounds& bounds);

}  // namespace pineda::vectors
