// The first field in which two structs differ, as a scoreboard or a vector test prints it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/spec/fields.h"

namespace pineda::spec {

/// A field's value in hex (two's complement of `bits` bits) and as the real number it stands for:
/// value_text(39, 8, "px^2", -1) is "0x7fffffffff (-0.00390625 px^2)". 1 <= bits <= 64.
std::string value_text(int bits, int fraction_bits, const char* unit, int64_t value);

/// "NAME: expected VALUE, got VALUE".
std::string difference_text(const std::string& name, int bits, int fraction_bits, const char* unit,
                            int64_t expected, int64_t got);

/// Compares two values of T field by field. The table of fields is built once, in the constructor.
template <class T>
class Comparer {
 public:
  explicit Comparer(const Contract& c) : contract_(c), table_(fields<T>(c)) {}

  /// "e[1]: expected 0x7fffffffff (-0.00390625 px^2), got 0x0000000000 (0 px^2)", or nothing.
  std::optional<std::string> difference(const T& expected, const T& got) const {
    for (const auto& field : table_) {
      for (int i = 0; i < field.count; ++i) {
        const int64_t a = field.get(contract_, expected, i);
        const int64_t b = field.get(contract_, got, i);
        if (a == b) continue;
        const std::string element = field.count > 1 ? "[" + std::to_string(i) + "]" : "";
        return difference_text(field.name + element, field.bits, field.fraction_bits, field.unit, a,
                               b);
      }
    }
    return std::nullopt;
  }

  /// Ordered sequences: "stamp 12: mask: expected ...", "stamp 40: expected the end, got one more"
  /// or "stamp 40: expected one more, got the end". Elements count from 0.
  std::optional<std::string> difference(const std::vector<T>& expected,
                                        const std::vector<T>& got) const {
    const size_t common = std::min(expected.size(), got.size());
    const auto element = [](size_t i) {
      return std::string(struct_name<T>()) + " " + std::to_string(i) + ": ";
    };
    for (size_t i = 0; i < common; ++i) {
      if (const auto text = difference(expected[i], got[i])) return element(i) + *text;
    }
    if (expected.size() < got.size()) return element(common) + "expected the end, got one more";
    if (expected.size() > got.size()) return element(common) + "expected one more, got the end";
    return std::nullopt;
  }

 private:
  Contract contract_;
  std::vector<Field<T>> table_;
};

/// The same for a single comparison, of two structs of fields.h or of two vectors of them.
template <class T>
std::optional<std::string> difference(const Contract& c, const T& expected, const T& got) {
  return Comparer<T>(c).difference(expected, got);
}
template <class T>
std::optional<std::string> difference(const Contract& c, const std::vector<T>& expected,
                                      const std::vector<T>& got) {
  return Comparer<T>(c).difference(expected, got);
}

}  // namespace pineda::spec
