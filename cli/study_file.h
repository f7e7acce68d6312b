// Reads a study: scenes, designs, memories, technologies and measures in a TOML file.
#pragma once

#include <stdexcept>
#include <string>

#include "studies/run/study.h"

namespace pineda::cli {

/// What is wrong with a study's file, in one line: file, line, what was expected.
class StudyFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct StudyFile {
  studies::Study study;
  size_t left_out = 0;  // combinations of parameters that cannot be built
  std::string reason;   // of the first of them
};

/// In       TOML; docs/studies.md has its keys. Paths are relative to the file's folder.
/// Errors   StudyFileError: no file, no TOML, an unknown key, an empty list or range, two things of one
///          name, a scene that is not there, a technology without cells.
StudyFile read_study(const std::string& path);

}  // namespace pineda::cli
