// Converts a struct to and from the bits of its SystemVerilog packed struct, using its table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/spec/fields.h"

namespace pineda::spec {

/// A packed struct: bit i is bit i%32 of word i/32. The first field is in the top bits.
using Packed = std::vector<uint32_t>;

/// Reads `bits` (1 to 64) bits from bit `position` on, zero-extended.
inline uint64_t get_bits(const uint32_t* words, int position, int bits) {
  const uint32_t* word = words + position / 32;
  const int shift = position % 32;
  uint64_t value = word[0] >> shift;
  if (shift + bits > 32) value |= uint64_t{word[1]} << (32 - shift);
  if (shift + bits > 64) value |= uint64_t{word[2]} << (64 - shift);
  return bits == 64 ? value : value & ((uint64_t{1} << bits) - 1);
}

/// Writes the low `bits` bits of `value`; leaves all other bits as they are.
inline void set_bits(uint32_t* words, int position, int bits, uint64_t value) {
  uint32_t* word = words + position / 32;
  const int shift = position % 32;
  const uint64_t mask = bits == 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
  value &= mask;
  const auto put = [](uint32_t* to, uint64_t part_mask, uint64_t part) {
    *to = (*to & ~static_cast<uint32_t>(part_mask)) | static_cast<uint32_t>(part);
  };
  put(word, mask << shift, value << shift);
  if (shift + bits > 32) put(word + 1, mask >> (32 - shift), value >> (32 - shift));
  if (shift + bits > 64) put(word + 2, mask >> (64 - shift), value >> (64 - shift));
}

/// Packs and unpacks T. The table of fields is built once, in the constructor.
template <class T>
class Packer {
 public:
  explicit Packer(const Contract& c) : contract_(c), table_(fields<T>(c)) {
    bits_ = packed_bits(table_);
  }

  int bits() const { return bits_; }
  int words() const { return (bits_ + 31) / 32; }
  const std::vector<Field<T>>& table() const { return table_; }

  /// The lowest bit of a field's element 0; -1 if there is no such field.
  int position(const std::string& name) const {
    int position = bits_;
    for (const auto& field : table_) {
      position -= field.bits * field.count;
      if (name == field.name) return position;
    }
    return -1;
  }

  /// Writes all words() words of `words`, whatever they held before.
  void pack(const T& value, uint32_t* words) const {
    for (int i = 0; i < this->words(); ++i) words[i] = 0;
    int position = bits_;
    for (const auto& field : table_) {
      position -= field.bits * field.count;
      for (int i = 0; i < field.count; ++i) {
        set_bits(words, position + i * field.bits, field.bits,
                 static_cast<uint64_t>(field.get(contract_, value, i)));
      }
    }
  }

  T unpack(const uint32_t* words) const {
    T value{};
    int position = bits_;
    for (const auto& field : table_) {
      position -= field.bits * field.count;
      for (int i = 0; i < field.count; ++i) {
        const uint64_t raw = get_bits(words, position + i * field.bits, field.bits);
        field.set(contract_, value, i,
                  field.is_signed ? wrap(static_cast<int64_t>(raw), field.bits)
                                  : static_cast<int64_t>(raw));
      }
    }
    return value;
  }

  Packed pack(const T& value) const {
    Packed words(static_cast<size_t>(this->words()));
    pack(value, words.data());
    return words;
  }

 private:
  Contract contract_;
  std::vector<Field<T>> table_;
  int bits_ = 0;
};

}  // namespace pineda::spec
