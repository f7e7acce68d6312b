#include "model/scene/readers/gltf/data_uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace pineda::scene {
namespace {

constexpr std::string_view kScheme = "data:", kBase64 = ";base64";
constexpr int8_t kNoDigit = -1;

bool is_same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == y;
  });
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::array<int8_t, 256> base64_digits() {
  std::array<int8_t, 256> value;
  value.fill(kNoDigit);
  const std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < digits.size(); ++i) {
    value[static_cast<unsigned char>(digits[i])] = static_cast<int8_t>(i);
  }
  return value;
}

std::optional<std::string> base64_decoded(std::string_view text) {
  static const std::array<int8_t, 256> kDigits = base64_digits();
  for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return {};
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  uint32_t bits = 0;
  int held = 0;  // number of bits not written yet
  for (const char c : text) {
    const int8_t digit = kDigits[static_cast<unsigned char>(c)];
    if (digit == kNoDigit) return {};
    bits = bits << 6 | static_cast<uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xff);
  }
  return bytes;
}

}  // namespace

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  for (size_t i = 0; i < text.size(); ++i) {
    const int high = text.size() - i > 2 ? hex_digit(text[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
    if (text[i] == '%' && low >= 0) {
      decoded += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

bool read_data_uri(std::string_view uri, std::optional<std::string>* bytes) {
  if (!is_same(uri.substr(0, kScheme.size()), kScheme)) return false;
  bytes->reset();
  const size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return true;
  const std::string_view type = uri.substr(0, comma);
  std::string_view data = uri.substr(comma + 1);
  std::string decoded;
  if (data.find('%') != std::string_view::npos) {
    decoded = percent_decoded(data);
    data = decoded;
  }
  const bool is_base64 =
      type.size() >= kBase64.size() && is_same(type.substr(type.size() - kBase64.size()), kBase64);
  *bytes = is_base64 ? base64_decoded(data) : std::string(data);
  return true;
}

}  // namespace pineda::scene
