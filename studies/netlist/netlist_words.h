// A struct as the hex digits of a netlist's port.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "model/spec/pack.h"

namespace pineda::studies {

/// As -DSYNTHESIS has the structs: the number of a triangle, which lies on top, has one bit.
template <class T>
class NetlistWords {
 public:
  explicit NetlistWords(const spec::Contract& contract) : packer_(contract) {
    bits_ = packer_.bits() - (packer_.position("id") < 0 ? 0 : spec::kTriangleIdBits - 1);
  }

  int bits() const { return bits_; }
  std::string hex(const T& value) const {
    const spec::Packed words = packer_.pack(value);
    std::string digits;
    for (int at = (bits_ - 1) / 4 * 4; at >= 0; at -= 4) {
      digits += "0123456789abcdef"[spec::get_bits(words.data(), at, std::min(4, bits_ - at))];
    }
    return digits;
  }
  /// Nothing where a bit is unknown, or where there are more or fewer digits.
  std::optional<T> token(const std::string& hex) const {
    const bool is_known = hex.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_known || hex.size() != static_cast<size_t>((bits_ + 3) / 4)) return std::nullopt;
    spec::Packed words(static_cast<size_t>(packer_.words()) + 1);
    int at = 0;
    for (auto digit = hex.rbegin(); digit != hex.rend(); ++digit, at += 4) {
      const int value = *digit <= '9' ? *digit - '0' : *digit - 'a' + 10;
      spec::set_bits(words.data(), at, 4, static_cast<uint64_t>(value));
    }
    return packer_.unpack(words.data());
  }

 private:
  spec::Packer<T> packer_;
  int bits_ = 0;
};

}  // namespace pineda::studies
