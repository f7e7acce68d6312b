#include "vectors/grammar/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace pineda::vectors {

bool Lines::next() {
  do {
    line_.clear();
    words_.clear();
    ++number_;
    if (position_ >= text_.size()) {
      at_end_ = true;
      return false;
    }
    const size_t end = std::min(text_.find('\n', position_), text_.size());
    line_ = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
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

std::string hex(int64_t value, int bits) {
  const uint64_t code = static_cast<uint64_t>(value) & (~uint64_t{0} >> (64 - bits));
  return fmt::format("{:0{}x}", code, (bits + 3) / 4);
}

uint64_t parse_hex(const Lines& lines, const std::string& word, int bits, const std::string& what) {
  const auto digits = static_cast<size_t>(bits + 3) / 4;
  const bool plain = word.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (word.size() != digits || !plain) {
    lines.refuse(fmt::format("{} hex digits of {}", digits, what), "'" + word + "'");
  }
  uint64_t value = 0;
  std::from_chars(word.data(), word.data() + word.size(), value, 16);
  if (bits < 64 && value >> bits != 0) {
    lines.refuse(fmt::format("a value of {} bits for {}", bits, what), "'" + word + "'");
  }
  return value;
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
