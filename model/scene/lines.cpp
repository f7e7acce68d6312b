#include "model/scene/lines.h"

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

constexpr const char* kBlanks = " \t\r\v\f";

}  // namespace

std::string quoted(const std::string& text) {
  constexpr size_t kLongest = 40;
  std::string shown = text.substr(0, kLongest);
  for (char& c : shown) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + shown + (text.size() > kLongest ? "...'" : "'");
}

std::unique_ptr<std::istream> open_file(const std::string& path) {
  std::error_code unreadable;  // found again, with its cause, when the file is opened
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

bool LineReader::next_raw() {
  if (!std::getline(*stream_, text_)) {
    if (stream_->bad()) throw InputError(file_, line_, "expected more lines, got a read error");
    return false;
  }
  ++line_;
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  return true;
}

bool LineReader::next() {
  while (next_raw()) {
    split();
    if (!words_.empty() && words_[0][0] != '#') return true;
  }
  words_.clear();
  return false;
}

void LineReader::split() {
  words_.clear();
  if (text_.find('\0') != std::string::npos) fail("text", text_);
  split_ = text_;
  char* at = split_.data();
  while (true) {
    at += std::strspn(at, kBlanks);
    if (*at == '\0') return;
    words_.push_back(at);
    at += std::strcspn(at, kBlanks);
    if (*at == '\0') return;
    *at++ = '\0';
  }
}

void LineReader::rewind() {
  stream_->clear();
  if (!stream_->seekg(0)) throw InputError(file_, "expected a file that can be read twice");
  line_ = 0;
}

bool LineReader::is(const char* keyword) const { return std::strcmp(words_[0], keyword) == 0; }

float LineReader::number(size_t i) const {
  char* end = nullptr;
  const float value = std::strtof(words_[i], &end);
  if (end == words_[i] || *end != '\0') fail("a number", words_[i]);
  return value;
}

int LineReader::integer(size_t i, int low, int high, const char* what) const {
  const char* end = words_[i] + std::strlen(words_[i]);
  int value = 0;
  const auto result = std::from_chars(words_[i], end, value);
  if (result.ec != std::errc() || result.ptr != end || value < low || value > high) {
    fail(fmt::format("{} from {} to {}", what, low, high), words_[i]);
  }
  return value;
}

void LineReader::expect_words(size_t count, const char* form) const {
  if (words_.size() != count) {
    throw InputError(file_, line_,
                     fmt::format("expected {} words '{}', got {} in {}", count, form, words_.size(),
                                 quoted(text_)));
  }
}

void LineReader::fail(const std::string& expected, const std::string& got) const {
  // An empty file is wrong at its first line.
  throw InputError(file_, std::max<uint64_t>(line_, 1),
                   fmt::format("expected {}, got {}", expected, quoted(got)));
}

}  // namespace pineda::scene
