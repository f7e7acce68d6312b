// A study as `pineda error` might find it, made up: 8 designs, 13 baselines, some close together.
#pragma once

#include "studies/error/error.h"

namespace pineda::studies {

/// Every design holds; baselines miss samples, are far off, judge nothing or have no time.
ErrorStudy sample_study();

/// The subject of that name; it must be there.
Subject* find(ErrorStudy* study, const std::string& name);

}  // namespace pineda::studies
