// Lines of a vector file: words, hex columns, and refusals that name file and line.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "model/spec/fields.h"

namespace pineda::vectors {

/// A file that is not taken. what() is one line: "FILE:LINE: expected ..., got ...".
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The words of a file, line by line. A line is words with one space between them.
class Lines {
 public:
  Lines(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}

  /// Goes to the next line; false at the end of the file. Blank lines are skipped.
  bool next();

  bool at_end() const { return at_end_; }
  size_t words() const { return words_.size(); }
  /// Word `i` of the line; `what` names it in the refusal of a line that is too short.
  const std::string& word(size_t i, const std::string& what) const;
  bool starts_with(const char* keyword) const { return !at_end_ && words_[0] == keyword; }
  const std::string& line() const { return line_; }
  int number() const { return number_; }
  /// What follows the current line.
  std::string rest() const { return text_.substr(position_); }

  /// Throws "FILE:LINE: expected EXPECTED, got GOT"; without `got`, the current line.
  [[noreturn]] void refuse(const std::string& expected) const;
  [[noreturn]] void refuse(const std::string& expected, const std::string& got) const;
  /// The same for line `number`.
  [[noreturn]] void refuse_at(int number, const std::string& expected,
                              const std::string& got) const;

 private:
  std::string path_;
  std::string text_;
  size_t position_ = 0;
  int number_ = 0;
  bool at_end_ = false;
  std::string line_;
  std::vector<std::string> words_;
};

/// `bits` bits of a value, two's complement, in as many lower-case hex digits as they fill.
std::string hex(int64_t value, int bits);

/// What hex() wrote, zero-extended; refuses any other form and a value of more bits. `word` is of
/// the current line, `what` names its column.
uint64_t parse_hex(const Lines& lines, const std::string& word, int bits, const std::string& what);

/// A decimal number.
uint64_t parse_decimal(const Lines& lines, const std::string& word, const std::string& what);

/// Lines that hold one struct T: its name, then each element of each field in the table's order.
template <class T>
class Row {
 public:
  explicit Row(const spec::Contract& c) : Row(c, spec::fields<T>(c)) {}
  /// A row of some of the struct's fields.
  Row(const spec::Contract& c, std::vector<spec::Field<T>> table)
      : contract_(c), table_(std::move(table)) {}

  const char* keyword() const { return spec::struct_name<T>(); }

  /// "columns stamp tri x y mask ... attr_dx[0] ...\n"
  std::string columns() const {
    std::string text = std::string("columns ") + keyword();
    for_each_column([&](const auto&, int, const std::string& name) { text += " " + name; });
    return text + "\n";
  }

  /// Throws std::out_of_range for a value that its field cannot hold.
  std::string write(const T& value) const {
    std::string text = keyword();
    for_each_column([&](const auto& field, int i, const std::string& name) {
      const int64_t number = field.get(contract_, value, i);
      const bool fits = field.is_signed ? spec::wrap(number, field.bits) == number
                                        : field.bits == 64 || number >> field.bits == 0;
      if (!fits) {
        throw std::out_of_range(std::string("vectors: ") + keyword() + " " + name + ": " +
                                std::to_string(number) + " is too wide for its field");
      }
      text += " " + hex(number, field.bits);
    });
    return text + "\n";
  }

  /// The struct of the current line, which starts with the keyword; goes to the next line.
  T read(Lines* lines) const {
    T value{};
    size_t word = 0;
    for_each_column([&](const auto& field, int i, const std::string& name) {
      const std::string what = keyword() + (" " + name);
      const auto number =
          static_cast<int64_t>(parse_hex(*lines, lines->word(++word, what), field.bits, what));
      field.set(contract_, value, i, field.is_signed ? spec::wrap(number, field.bits) : number);
    });
    if (lines->words() != word + 1) {
      lines->refuse(std::to_string(word) + " columns of " + keyword(),
                    std::to_string(lines->words() - 1));
    }
    lines->next();
    return value;
  }

  /// All consecutive lines of this struct.
  std::vector<T> read_all(Lines* lines) const {
    std::vector<T> values;
    while (lines->starts_with(keyword())) values.push_back(read(lines));
    return values;
  }

  std::string write_all(const std::vector<T>& values) const {
    std::string text;
    for (const T& value : values) text += write(value);
    return text;
  }

 private:
  template <class Visitor>
  void for_each_column(Visitor&& visit) const {
    for (const auto& field : table_) {
      for (int i = 0; i < field.count; ++i) {
        const std::string element = field.count > 1 ? "[" + std::to_string(i) + "]" : "";
        visit(field, i, field.name + element);
      }
    }
  }

  spec::Contract contract_;
  std::vector<spec::Field<T>> table_;
};

}  // namespace pineda::vectors
