// The option that chooses the vector unit of the quick model, for this program and the benchmarks.
#pragma once

#include <CLI/CLI.hpp>

namespace pineda::cli {

/// --simd NAME: one of fast::levels(), which is selected when the option is read.
void add_simd_option(CLI::App* command);

}  // namespace pineda::cli
