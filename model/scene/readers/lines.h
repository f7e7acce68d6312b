// Splits the lines of a text file into words; errors name the line.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/readers/blocks.h"

namespace pineda::scene {

/// Opens a file for reading, or throws InputError with the system's reason.
std::unique_ptr<std::istream> open_file(const std::string& path);

/// Text from a file as a message may quote it: shortened, and with printable characters only.
std::string quoted(const std::string& text);

/// Parses a whole word as a number, with the results of strtof and strtod, including hexadecimal
/// numbers, nan and inf. False if it is none. *end must be NUL.
bool parse_number(const char* word, const char* end, float* value);
bool parse_number(const char* word, const char* end, double* value);

/// The syntax of comments and continued lines.
struct LineSyntax {
  bool comment_ends_word = true;     // '#' begins a comment even inside a word
  bool backslash_continues = false;  // '\' at the end of a line joins the next, except in comments
};

/// Reads a text line by line and splits each into words. A line ends with LF. Words are separated
/// by blanks; a carriage return is a blank, so files with CR LF line ends read the same. A byte
/// order mark (UTF-8) at the beginning of the file is skipped.
class LineReader {
 public:
  LineReader(std::string file, std::unique_ptr<std::istream> stream, LineSyntax syntax = {})
      : file_(std::move(file)), blocks_(std::move(stream)), syntax_(syntax) {}

  /// Reads the next line that is neither blank nor a comment, and splits it into words; false at
  /// the end of the file. A line and its continuations count as one line.
  bool next();
  void rewind();

  /// The line, without its line end.
  std::string_view raw() const { return raw_; }
  const std::vector<const char*>& words() const { return words_; }
  const char* end_of_word(size_t i) const { return ends_[i]; }
  bool is(const char* keyword) const;
  /// The number of the line, from 1; if it is continued, that of its first line.
  uint64_t line() const { return line_; }
  /// The bytes after the line, for a file that continues in another format.
  BlockReader& bytes() { return blocks_; }

  /// Word `i` as a number, see parse_number(); throws if it is none.
  float number(size_t i) const;
  /// Word `i` as a decimal integer in [low, high]; `what` names it, "a width" for instance.
  int integer(size_t i, int low, int high, const char* what) const;
  /// Throws unless the line has `count` words; `form` shows the line that was expected.
  void expect_words(size_t count, const char* form) const;
  /// Throws "FILE:LINE: expected EXPECTED, got 'GOT'".
  [[noreturn]] void fail(const std::string& expected, std::string_view got) const;

 private:
  bool next_line();
  bool is_continued() const;
  void append_continuations();
  void split();

  std::string file_;
  BlockReader blocks_;
  LineSyntax syntax_;
  std::string_view raw_;  // in blocks_ or joined_
  std::string joined_;    // a line and its continuations
  std::string split_;     // the line with a NUL after each word
  std::vector<const char*> words_, ends_;
  uint64_t line_ = 0;
  uint64_t lines_read_ = 0;
};

}  // namespace pineda::scene
