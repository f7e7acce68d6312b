// What stops an area study.
#pragma once

#include <stdexcept>

namespace pineda::studies {

/// Bad input of an area study, or a tool that is missing or fails. One line.
class AreaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pineda::studies
