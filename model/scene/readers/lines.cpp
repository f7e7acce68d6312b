#include "model/scene/readers/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// Tries from_chars first: it is several times as fast as strtof but does not accept all of its
// forms.
template <class T, class Strto>
bool parse(const char* word, const char* end, T* value, Strto strto) {
  const char* digits = *word == '-' ? word + 1 : word;
  if (*digits == '.' || (*digits >= '0' && *digits <= '9')) {
    const auto result = std::from_chars(word, end, *value);
    if (result.ec == std::errc() && result.ptr == end) return true;
  }
  char* parsed = nullptr;
  *value = strto(word, &parsed);
  return parsed != word && parsed == end;
}

}  // namespace

bool parse_number(const char* word, const char* end, float* value) {
  return parse(word, end, value, std::strtof);
}

bool parse_number(const char* word, const char* end, double* value) {
  return parse(word, end, value, std::strtod);
}

std::string quoted(const std::string& text) {
  constexpr size_t kLongest = 40;
  std::string shown = text.substr(0, kLongest);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + shown + (text.size() > kLongest ? "...'" : "'");
}

std::unique_ptr<std::istream> open_file(const std::string& path) {
  std::error_code unreadable;  // ignored: opening the file reports the error and its cause
  if (std::filesystem::is_directory(path, unreadable)) {
    throw InputError(path, "expected a file, got a directory");
  }
  errno = 0;
  auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*stream) {
    throw InputError(path, fmt::format("expected a file to read, got: {}", std::strerror(errno)));
  }
  return stream;
}

// Reads the next line, as it is in the file, into raw_.
bool LineReader::next_line() {
  size_t searched = 0;
  const void* found = nullptr;
  while (true) {
    const size_t size = blocks_.size();
    if (size > searched) {
      found = std::memchr(blocks_.data() + searched, '\n', size - searched);
    }
    if (found != nullptr) break;
    searched = size;
    if (!blocks_.read_more()) break;
  }
  if (blocks_.is_bad()) throw InputError(file_, line_, "expected more lines, got a read error");
  if (blocks_.size() == 0) return false;
  const size_t length = found != nullptr
                            ? static_cast<size_t>(static_cast<const char*>(found) - blocks_.data())
                            : blocks_.size();
  raw_ = {blocks_.data(), length};
  blocks_.take(length + (found != nullptr ? 1 : 0));
  if (lines_read_++ == 0 && raw_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    raw_.remove_prefix(kByteOrderMark.size());
  }
  if (!raw_.empty() && raw_.back() == '\r') raw_.remove_suffix(1);
  return true;
}

bool LineReader::is_continued() const {
  return !raw_.empty() && raw_.back() == '\\' && raw_.find('#') == std::string_view::npos;
}

void LineReader::append_continuations() {
  joined_.clear();
  bool is_open = true;
  while (is_open) {
    is_open = is_continued();
    joined_.append(raw_.substr(0, raw_.size() - (is_open ? 1 : 0)));
    if (is_open) joined_ += ' ';
    is_open = is_open && next_line();
  }
  raw_ = joined_;
}

bool LineReader::next() {
  while (next_line()) {
    line_ = lines_read_;
    if (syntax_.backslash_continues && is_continued()) append_continuations();
    split();
    if (!words_.empty()) return true;
  }
  raw_ = {};
  words_.clear();
  return false;
}

void LineReader::split() {
  words_.clear();
  ends_.clear();
  if (std::memchr(raw_.data(), '\0', raw_.size()) != nullptr) fail("text", raw_);
  split_.assign(raw_);
  char* at = split_.data();
  while (true) {
    while (is_blank(*at)) ++at;
    if (*at == '\0' || *at == '#') return;
    words_.push_back(at);
    while (*at != '\0' && !is_blank(*at) && !(*at == '#' && syntax_.comment_ends_word)) ++at;
    ends_.push_back(at);
    const char end = *at;
    *at = '\0';
    if (end == '\0' || end == '#') return;
    ++at;
  }
}

void LineReader::rewind() {
  if (!blocks_.rewind()) throw InputError(file_, "expected a file that can be read twice");
  line_ = lines_read_ = 0;
}

bool LineReader::is(const char* keyword) const { return std::strcmp(words_[0], keyword) == 0; }

float LineReader::number(size_t i) const {
  float value = 0;
  if (!parse_number(words_[i], ends_[i], &value)) fail("a number", words_[i]);
  return value;
}

int LineReader::integer(size_t i, int low, int high, const char* what) const {
  int value = 0;
  const auto result = std::from_chars(words_[i], ends_[i], value);
  if (result.ec != std::errc() || result.ptr != ends_[i] || value < low || value > high) {
    fail(fmt::format("{} from {} to {}", what, low, high), words_[i]);
  }
  return value;
}

void LineReader::expect_words(size_t count, const char* form) const {
  if (words_.size() != count) {
    throw InputError(file_, line_,
                     fmt::format("expected {} words '{}', got {} in {}", count, form, words_.size(),
                                 quoted(std::string(raw_))));
  }
}

void LineReader::fail(const std::string& expected, std::string_view got) const {
  // In an empty file the error is in line 1.
  throw InputError(file_, std::max<uint64_t>(line_, 1),
                   fmt::format("expected {}, got {}", expected, quoted(std::string(got))));
}

}  // namespace pineda::scene
