// Bad input: one clear line.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace pineda::scene {

/// The input is not what its format promises: "FILE:LINE: expected ..., got ...", one line.
/// The same class reports a file that cannot be written.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& what)
      : std::runtime_error(file + ": " + what) {}
  InputError(const std::string& file, uint64_t line, const std::string& what)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + what) {}
};

}  // namespace pineda::scene
