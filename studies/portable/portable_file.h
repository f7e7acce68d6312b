// Files of portable cases: reading and writing. docs/formats.md has the grammar.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

#include "studies/portable/portable_case.h"
#include "vectors/grammar/text.h"

namespace pineda::studies {

/// What a file says before its cases.
struct PortableHeader {
  FrameTolerance tolerance;  // with the formats
  std::string design;        // of the vectors that the scenes were taken from, as level and seed
  int level = 1;
  uint64_t seed = 1;
};

/// Is it a file of portable cases, by its first line?
bool is_portable(const std::string& path);

std::string portable_header(const PortableHeader& header);
/// The last line.
std::string portable_end(uint64_t cases);

/// Reads a file case by case.
///
/// Errors   vectors::Refused, scene::InputError: a line that is not as it must be. What follows from a
///          scene is computed anew and compared with the file, so no line of it can be stale.
class PortableReader {
 public:
  explicit PortableReader(const std::string& path);
  PortableReader(const std::string& path, std::unique_ptr<std::istream> stream);

  const PortableHeader& header() const { return header_; }
  /// False once the file has ended as it must.
  bool next(PortableCase* value);

 private:
  void read_header();
  std::string value(const char* key);
  double number(const char* key);
  void read_scene(PortableCase* value);
  void compare(const PortableCase& value);

  std::string path_;
  vectors::Lines lines_;
  PortableHeader header_;
  spec::Contract contract_;
  std::vector<std::pair<int, std::string>> case_lines_;  // with their numbers
  uint64_t cases_ = 0;
};

}  // namespace pineda::studies
