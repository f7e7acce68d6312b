// A picture of where a design's area goes.
#pragma once

#include <string>

#include "studies/area/area.h"

namespace pineda::studies {

/// An SVG file: a bar for each module at its place in the hierarchy, the largest first within its
/// unit. Modules of less than half a percent share a bar.
std::string area_picture(const AreaStudy& study, const std::string& title);

}  // namespace pineda::studies
