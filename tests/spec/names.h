// A check that every table of names must pass.
#pragma once

#include <set>
#include <string>

#include "model/spec/names.h"

namespace pineda::spec {

/// What is wrong with the table of an enumeration that ends with `last`: a row out of order, a word
/// twice, a value without a row. Empty if nothing is.
template <class Row, size_t N, class Value>
std::string fault(const Row (&rows)[N], Value last) {
  std::set<std::string> words;
  for (size_t i = 0; i < N; ++i) {
    if (static_cast<size_t>(rows[i].value) != i) return std::string("order: ") + rows[i].word;
    if (!words.insert(rows[i].word).second) return std::string("twice: ") + rows[i].word;
  }
  return static_cast<size_t>(last) + 1 == N ? "" : "not all values";
}

}  // namespace pineda::spec
