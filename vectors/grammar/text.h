// Lines of a vector file: words, hex columns, and refusals that name file and line.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
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

/// The words of a file, line by line; one line is kept. A line is words with one space between them.
class Lines {
 public:
  Lines(std::string path, std::unique_ptr<std::istream> stream);

  /// Goes to the next line; false at the end of the file. Blank lines are skipped.
  bool next();

  bool at_end() const { return at_end_; }
  size_t words() const { return words_.size(); }
  /// Word `i` of the line; `what` names it in the refusal of a line that is too short.
  const std::string& word(size_t i, const std::string& what) const;
  const std::string& word(size_t i) const { return words_[i]; }  // that is there
  bool starts_with(const char* keyword) const { return !at_end_ && words_[0] == keyword; }
  const std::string& line() const { return line_; }
  int number() const { return number_; }
  /// From the next line on, lines are content; of all content before the current line:
  void begin_content();
  uint64_t content_hash() const { return hash_; }

  /// Throws "FILE:LINE: expected EXPECTED, got GOT"; without `got`, the current line.
  [[noreturn]] void refuse(const std::string& expected) const;
  [[noreturn]] void refuse(const std::string& expected, const std::string& got) const;
  /// The same for line `number`.
  [[noreturn]] void refuse_at(int number, const std::string& expected,
                              const std::string& got) const;

 private:
  std::string path_;
  std::unique_ptr<std::istream> stream_;
  int number_ = 0;
  bool at_end_ = false;
  std::string line_;
  uint64_t hash_;            // of the content before the current line
  bool is_content_ = false;  // the current line
  std::vector<std::string> words_;
};

/// `bits` bits of a value, two's complement, in as many lower-case hex digits as they fill.
std::string hex(int64_t value, int bits);
/// The same, appended.
void append_hex(int64_t value, int bits, std::string* text);

/// What hex() wrote, zero-extended; nothing for any other form and for a value of more bits.
std::optional<uint64_t> hex_value(const std::string& word, int bits);

/// The same, or refuses. `word` is of the current line, `what` names its column.
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
    for_each_column([&](const auto& field, int i) { text += " " + name_of(field, i); });
    return text + "\n";
  }

  /// Throws std::out_of_range for a value that its field cannot hold.
  std::string write(const T& value) const {
    std::string text = keyword();
    for_each_column([&](const auto& field, int i) {
      const int64_t number = field.get(contract_, value, i);
      const bool fits = field.is_signed ? spec::wrap(number, field.bits) == number
                                        : field.bits == 64 || number >> field.bits == 0;
      if (!fits) {
        throw std::out_of_range(std::string("vectors: ") + keyword() + " " + name_of(field, i) +
                                ": " + std::to_string(number) + " is too wide for its field");
      }
      text += ' ';
      append_hex(number, field.bits, &text);
    });
    return text + "\n";
  }

  /// The struct of the current line, which starts with the keyword; goes to the next line.
  T read(Lines* lines) const {
    T value{};
    size_t word = 0;
    for_each_column([&](const auto& field, int i) {
      if (++word >= lines->words() || !hex_value(lines->word(word), field.bits)) {
        const std::string what = keyword() + (" " + name_of(field, i));
        parse_hex(*lines, lines->word(word, what), field.bits, what);  // refuses
      }
      const auto number = static_cast<int64_t>(*hex_value(lines->word(word), field.bits));
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
      for (int i = 0; i < field.count; ++i) visit(field, i);
    }
  }
  static std::string name_of(const spec::Field<T>& field, int i) {
    return field.count > 1 ? field.name + ("[" + std::to_string(i) + "]") : field.name;
  }

  spec::Contract contract_;
  std::vector<spec::Field<T>> table_;
};

}  // namespace pineda::vectors
