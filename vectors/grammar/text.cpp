#include "vectors/grammar/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "model/spec/package.h"

namespace pineda::vectors {

Lines::Lines(std::string path, std::unique_ptr<std::istream> stream)
    : path_(std::move(path)), stream_(std::move(stream)), hash_(spec::text_hash("")) {}

void Lines::begin_content() {
  hash_ = spec::text_hash("");
  line_.clear();
  is_content_ = false;
}

bool Lines::next() {
  words_.clear();
  do {
    if (is_content_) hash_ = spec::text_hash(line_ + "\n", hash_);
    is_content_ = true;
    ++number_;
    if (!std::getline(*stream_, line_)) {
      line_.clear();
      at_end_ = true;
      return false;
    }
  } while (line_.empty());
  for (size_t from = 0; from <= line_.size();) {
    const size_t end = std::min(line_.find(' ', from), line_.size());
    words_.push_back(line_.substr(from, end - from));
    from = end + 1;
  }
  return true;
}

void Lines::refuse(const std::string& expected) const {
  constexpr size_t kShown = 40;
  if (at_end_) refuse(expected, "the end of the file");
  refuse(expected, "'" + line_.substr(0, kShown) + (line_.size() > kShown ? "...'" : "'"));
}

void Lines::refuse(const std::string& expected, const std::string& got) const {
  refuse_at(number_, expected, got);
}

void Lines::refuse_at(int number, const std::string& expected, const std::string& got) const {
  throw Refused(fmt::format("{}:{}: expected {}, got {}", path_, number, expected, got));
}

const std::string& Lines::word(size_t i, const std::string& what) const {
  if (i >= words_.size()) refuse(what, at_end_ ? "the end of the file" : "the end of the line");
  return words_[i];
}

void append_hex(int64_t value, int bits, std::string* text) {
  const uint64_t code = static_cast<uint64_t>(value) & (~uint64_t{0} >> (64 - bits));
  const auto digits = static_cast<size_t>(bits + 3) / 4;
  std::array<char, 16> all;
  for (size_t i = 0; i < digits; ++i) {
    all[i] = "0123456789abcdef"[code >> 4 * (digits - 1 - i) & 15];
  }
  text->append(all.data(), digits);
}

std::string hex(int64_t value, int bits) {
  std::string text;
  append_hex(value, bits, &text);
  return text;
}

std::optional<uint64_t> hex_value(const std::string& word, int bits) {
  const auto digits = static_cast<size_t>(bits + 3) / 4;
  uint64_t value = 0;
  for (const char c : word) {
    const bool is_digit = c >= '0' && c <= '9', is_letter = c >= 'a' && c <= 'f';
    if (!is_digit && !is_letter) return std::nullopt;
    value = value << 4 | static_cast<uint64_t>(is_digit ? c - '0' : c - 'a' + 10);
  }
  const bool fits = word.size() == digits && (bits == 64 || value >> bits == 0);
  return fits ? std::optional(value) : std::nullopt;
}

uint64_t parse_hex(const Lines& lines, const std::string& word, int bits, const std::string& what) {
  if (const auto value = hex_value(word, bits)) return *value;
  const auto digits = static_cast<size_t>(bits + 3) / 4;
  const bool plain = word.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (word.size() != digits || !plain) {
    lines.refuse(fmt::format("{} hex digits of {}", digits, what), "'" + word + "'");
  }
  lines.refuse(fmt::format("a value of {} bits for {}", bits, what), "'" + word + "'");
}

uint64_t parse_decimal(const Lines& lines, const std::string& word, const std::string& what) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    lines.refuse("a decimal number for " + what, "'" + word + "'");
  }
  return value;
}

}  // namespace pineda::vectors
