// The exception for bad input, with a one-line message.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace pineda::scene {

/// Input that does not follow its format, in one line: "FILE:LINE: expected ..., got ...". Also
/// reports a file that cannot be written.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& what)
      : std::runtime_error(file + ": " + what) {}
  InputError(const std::string& file, uint64_t line, const std::string& what)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + what) {}
};

}  // namespace pineda::scene
