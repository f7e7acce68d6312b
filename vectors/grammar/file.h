// Vector files: reading and writing. The grammar is in README.md.
#pragma once

#include <string>
#include <vector>

#include "vectors/grammar/cases.h"
#include "vectors/grammar/text.h"

namespace pineda::vectors {

/// What a file says about itself.
struct Header {
  Unit unit = Unit::kSetup;
  spec::Contract contract;  // of its design
  int level = 1;
  uint64_t seed = 1;
  size_t cases = 0;
};

/// The cases of one unit, with the design whose formats they are in.
template <class Case>
struct File {
  spec::Contract contract;
  int level = 1;
  uint64_t seed = 1;
  std::vector<Case> cases;
};

/// Reads only the header, whose unit decides which Case read() takes. Throws Refused.
Header read_header(const std::string& path);

/// Reads a whole file of SetupCase, TraversalCase, InterpZtestCase or FrameCase.
///
/// Errors   throws Refused: no such file, another unit, an unknown design without parameters, a
///          design that cannot be built, formats that are not the present ones, a wrong count or
///          hash of the content, a cut or malformed file.
template <class Case>
File<Case> read(const std::string& path);

/// The same from memory; `path` is for the messages.
template <class Case>
File<Case> read_text(const std::string& path, const std::string& text);

/// The bytes of a file.
template <class Case>
std::string write_text(const File<Case>& file);

/// Writes to a temporary name beside `path` and renames. Throws Refused when that fails, or when the
/// design's name is not one word.
template <class Case>
void write(const std::string& path, const File<Case>& file);

}  // namespace pineda::vectors
