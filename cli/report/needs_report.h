// What pineda needs found, for a person and for a program.
#pragma once

#include <string>

#include "cli/output.h"
#include "studies/needs/needs.h"

namespace pineda::cli {

Json needs_json(const studies::Needs& needs, const spec::Design& base);

/// What the scene uses, the table of parameters, what is left.
void print_needs(const Output& output, const studies::Needs& needs, const spec::Design& base);

/// The design as a file, with a comment on what it holds. Of a named base only the differences are
/// stated.
std::string needs_toml(const studies::Needs& needs, const spec::Design& base);

}  // namespace pineda::cli
