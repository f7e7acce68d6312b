// The exception for bad input, with a one-line message.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace pineda::scene {

/// Input that does not follow its format, in one line: "FILE:LINE: expected ..., got ...". Also
/// reports a file that cannot be written. What it quotes from a file is printable: other characters
/// become '?'.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& what)
      : std::runtime_error(file + ": " + printable(what)) {}
  InputError(const std::string& file, uint64_t line, const std::string& what)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + printable(what)) {}

 private:
  static std::string printable(std::string text) {
    for (char& c : text) {
      if (c < ' ' || c > '~') c = '?';
    }
    return text;
  }
};

}  // namespace pineda::scene
