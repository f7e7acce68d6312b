// A design from a TOML file: the keys that `pineda designs` prints, what is left out from a base.
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

/// A parameter's key and value, as a file says them.
struct Setting {
  const char* key;
  std::string value;
};

/// The parameters in which a design differs from another, in the order of such a file.
std::vector<Setting> differences(const Design& design, const Design& base);

/// The design as such a file, every parameter stated.
std::string design_toml(const Design& design);

/// The same with what differs from a named design alone.
std::string design_toml(const Design& design, const Design& base);

}  // namespace pineda::spec
