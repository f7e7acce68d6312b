// Lines of words from a text file, with errors that name the line.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace pineda::scene {

/// Opens a file for reading, or throws InputError with the system's reason.
std::unique_ptr<std::istream> open_file(const std::string& path);

/// What a message quotes of a file: short, and printable whatever the file holds.
std::string quoted(const std::string& text);

/// Reads a text line by line and splits each into words. Words are separated by blanks; a carriage
/// return counts as a blank, so files with CR LF line ends read the same.
class LineReader {
 public:
  LineReader(std::string file, std::unique_ptr<std::istream> stream)
      : file_(std::move(file)), stream_(std::move(stream)) {}

  /// The next line as it stands, without its line end; false at the end of the file.
  bool next_raw();
  /// The next line that is neither blank nor a comment ('#'), split into words.
  bool next();
  void rewind();

  const std::string& raw() const { return text_; }
  const std::vector<const char*>& words() const { return words_; }
  bool is(const char* keyword) const;
  uint64_t line() const { return line_; }
  /// The stream, just behind the line, for a file that goes on in another format.
  std::istream& stream() { return *stream_; }

  /// Word `i` as a number, whatever strtof returns; throws if it is none.
  float number(size_t i) const;
  /// Word `i` as a decimal integer in [low, high]; `what` names it, "a width" for instance.
  int integer(size_t i, int low, int high, const char* what) const;
  /// Throws unless the line has `count` words; `form` shows the line that was expected.
  void expect_words(size_t count, const char* form) const;
  /// Throws "FILE:LINE: expected EXPECTED, got 'GOT'".
  [[noreturn]] void fail(const std::string& expected, const std::string& got) const;

 private:
  void split();

  std::string file_;
  std::unique_ptr<std::istream> stream_;
  std::string text_;   // the line
  std::string split_;  // the line, each word closed by a NUL
  std::vector<const char*> words_;
  uint64_t line_ = 0;
};

}  // namespace pineda::scene
