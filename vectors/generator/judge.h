// Judges scenes by exact arithmetic: no vector that it contradicts is written.
#pragma once

#include <optional>
#include <string>

#include "model/spec/bounds.h"
#include "vectors/generator/scenes.h"

namespace pineda::vectors {

/// Nothing if each triangle is dropped for a true cause, or drawn with exactly its samples and with
/// depth and attributes within the bounds; else what is wrong, in one line. Of a triangle of more
/// than 4096 samples only 32 rows are judged, from its SetupPrim.
std::optional<std::string> misjudged(const spec::Contract& contract, const Scene& scene,
                                     const spec::ErrorBounds& bounds);

}  // namespace pineda::vectors
