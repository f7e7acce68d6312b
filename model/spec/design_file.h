// Reads a design from a TOML file, with the keys that `pineda designs` prints. Parameters that the
// file leaves out are those of its base design.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "model/spec/design.h"

namespace pineda::spec {

/// What is wrong with a design file, in one line: the file, the line, what was expected.
class DesignFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// In       TOML, flat: `base` (a named design, high_tile unless given), `name` (the file's stem
///          unless given), `summary`, and any parameter of a design by its key in
///          parameters.h.
/// Out      the design; its name and summary live as long as the program.
/// Errors   DesignFileError: no file, no TOML, an unknown key, a value of another type or out of
///          range, a combination that cannot be built.
Design read_design(const std::string& path);

/// The same from text; `path` is what errors name.
Design parse_design(const std::string& text, const std::string& path);

/// A parameter's key and value, as a design file writes them.
struct Setting {
  const char* key;
  std::string value;
};

/// The parameters in which a design differs from `base`, in the order of a design file.
std::vector<Setting> differences(const Design& design, const Design& base);

/// The text of a design file that states every parameter.
std::string design_toml(const Design& design);

/// The text of a design file that states only what differs from a named design.
std::string design_toml(const Design& design, const Design& base);

}  // namespace pineda::spec
