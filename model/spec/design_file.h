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
///          unless given), `summary`, and any parameter of a design by its name; tiles and stamps
///          in px: tile_px, stamp_width_px, stamp_height_px.
/// Out      the design; its name and summary live as long as the program.
/// Errors   DesignFileError: no file, no TOML, an unknown key, a value of another type or out of
///          range, a combination that cannot be built.
Design read_design(const std::string& path);

/// The same from text; `path` is what errors name.
Design parse_design(const std::string& text, const std::string& path);

/// A parameter by the name and with the value that a design file has.
struct Parameter {
  std::string name;
  std::string value;
};

/// Every parameter of a design, in the order of such a file.
std::vector<Parameter> parameters(const Design& design);

/// The design as such a file, every parameter stated.
std::string design_toml(const Design& design);

/// The same with what differs from a named design alone.
std::string design_toml(const Design& design, const Design& base);

}  // namespace pineda::spec
