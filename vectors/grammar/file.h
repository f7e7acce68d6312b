// Vector files: reading and writing. The grammar is in README.md.
#pragma once

#include <fstream>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "model/files/unfinished.h"
#include "vectors/grammar/cases.h"
#include "vectors/grammar/codec.h"
#include "vectors/grammar/text.h"

namespace pineda::vectors {

/// What a file says about itself before its cases.
struct Header {
  Unit unit = Unit::kSetup;
  spec::Contract contract;  // of its design
  int level = 1;
  uint64_t seed = 1;
};

/// Reads only the header, whose unit decides which Case a Reader takes. Throws Refused.
Header read_header(const std::string& path);

/// Reads a file of SetupCase, TraversalCase, InterpZtestCase or FrameCase, one case at a time.
///
/// Errors   throws Refused: no such file, another unit, an unknown design without parameters, a
///          design that cannot be built, formats that are not the present ones, a malformed line;
///          at the end a cut file, a wrong count or hash of the content.
template <class Case>
class Reader {
 public:
  explicit Reader(const std::string& path);
  /// From a stream; `path` is for the messages.
  Reader(const std::string& path, std::unique_ptr<std::istream> stream);

  const Header& header() const { return header_; }
  /// The next case; false once the file has ended as it must.
  bool next(Case* value);

 private:
  void end();

  Lines lines_;
  Header header_;
  FrameCodec frame_;
  Codec<Case> codec_;
  uint64_t cases_ = 0;
};

/// Writes a file, one case at a time; what follows the last case is written by end().
///
/// Errors   throws Refused where the design's name is not one word, std::out_of_range for a value
///          that its field cannot hold.
template <class Case>
class Writer {
 public:
  Writer(const Header& header, std::ostream* stream);

  void write(const Case& value);
  void end();

 private:
  void content(const std::string& text);

  std::ostream* stream_;
  FrameCodec frame_;
  Codec<Case> codec_;
  uint64_t hash_;
  uint64_t cases_ = 0;
};

/// A file that is whole or not there: under a temporary name beside its own until keep().
class WholeFile {
 public:
  explicit WholeFile(const std::string& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream* stream() { return &stream_; }
  /// Throws Refused where it could not be written.
  void keep();

 private:
  std::string path_, temporary_;
  files::Unfinished unfinished_;  // what a signal removes
  std::ofstream stream_;
};

/// All cases of a file, with the design whose formats they are in.
template <class Case>
struct File {
  spec::Contract contract;
  int level = 1;
  uint64_t seed = 1;
  std::vector<Case> cases;
};

template <class Case>
File<Case> read(const std::string& path);
/// The same from memory; `path` is for the messages.
template <class Case>
File<Case> read_text(const std::string& path, const std::string& text);
/// The bytes of a file.
template <class Case>
std::string write_text(const File<Case>& file);
template <class Case>
void write(const std::string& path, const File<Case>& file);

}  // namespace pineda::vectors
