// What `pineda error` found, as one page.
#pragma once

#include <string>

#include "studies/error/error.h"

namespace pineda::studies {

/// HTML with the plots inside it; beside it only the error maps, as map_file() names them, of the
/// subjects that have one.
std::string error_page(const ErrorStudy& study, const std::string& scene);

}  // namespace pineda::studies
