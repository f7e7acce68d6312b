// What pineda needs found, for a person and for a program.
#pragma once

#include <string>

#include "cli/output.h"
#include "studies/needs/needs.h"

namespace pineda::cli {

Json needs_json(const studies::Needs& needs, const spec::Design& base);

/// What the scene uses, the table of parameters, what is left.
void print_needs(const Output& output, const studies::Needs& needs, const spec::Design& base);

/// The design as a file: what differs from the base where that is a named design, and as a comment
/// what it holds.
std::string needs_toml(const studies::Needs& needs, const spec::Design& base);

}  // namespace pineda::cli
