// The words of enumerations: one table for each, used by files, options, reports and errors.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pineda::spec {

/// A row of a table with nothing but a value and its word. Other tables have rows of their own
/// types with further members. Rows are in the order of the enumeration; the function names(Enum),
/// declared beside each enumeration, returns its table.
template <class Value>
struct Name {
  Value value;
  const char* word;
};

/// The words of a bool in raster state and options; design files use true and false.
inline constexpr Name<bool> kSwitchNames[] = {{false, "off"}, {true, "on"}};
constexpr const auto& names(bool) { return kSwitchNames; }

/// The row of a value.
/// Errors   std::out_of_range: a number that is no value of the enumeration.
template <class Value>
constexpr const auto& row_of(Value value) {
  for (const auto& row : names(value)) {
    if (row.value == value) return row;
  }
  throw std::out_of_range("names: no such value");
}

/// "lequal" of DepthFunc::kLequal.
template <class Value>
constexpr const char* name_of(Value value) {
  return row_of(value).word;
}

/// The value with this word; nothing if there is none.
template <class Value>
constexpr std::optional<Value> named(std::string_view word) {
  for (const auto& row : names(Value{})) {
    if (word == row.word) return row.value;
  }
  return std::nullopt;
}

/// All values, in order.
template <class Value>
constexpr auto values_of() {
  constexpr size_t kCount = std::extent_v<std::remove_reference_t<decltype(names(Value{}))>>;
  std::array<Value, kCount> values{};
  for (size_t i = 0; i < kCount; ++i) values[i] = names(Value{})[i].value;
  return values;
}

/// All words, in order.
template <class Value>
std::vector<std::string> word_list() {
  std::vector<std::string> words;
  for (const auto& row : names(Value{})) words.emplace_back(row.word);
  return words;
}

/// Joins words with a separator, and the last one with another: "none, back or front" for ", " and
/// " or ".
inline std::string joined(const std::vector<std::string>& words, const char* separator,
                          const char* last_separator) {
  std::string text;
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? separator : last_separator;
    text += words[i];
  }
  return text;
}

/// "none, back, front".
template <class Value>
std::string words_of() {
  return joined(word_list<Value>(), ", ", ", ");
}

/// "none, back or front".
template <class Value>
std::string alternatives() {
  return joined(word_list<Value>(), ", ", " or ");
}

}  // namespace pineda::spec
