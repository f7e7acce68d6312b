#include "model/spec/pack.h"

#include <algorithm>

namespace pineda::spec {

uint64_t get_bits(const uint32_t* words, int position, int bits) {
  uint64_t value = 0;
  for (int done = 0; done < bits;) {
    const int word = (position + done) / 32;
    const int shift = (position + done) % 32;
    const int take = std::min(32 - shift, bits - done);
    const uint64_t part = (words[word] >> shift) & ((uint64_t{1} << take) - 1);
    value |= part << done;
    done += take;
  }
  return value;
}

void set_bits(uint32_t* words, int position, int bits, uint64_t value) {
  for (int done = 0; done < bits;) {
    const int word = (position + done) / 32;
    const int shift = (position + done) % 32;
    const int take = std::min(32 - shift, bits - done);
    const auto mask = static_cast<uint32_t>(((uint64_t{1} << take) - 1) << shift);
    const auto part = static_cast<uint32_t>((value >> done) << shift);
    words[word] = (words[word] & ~mask) | (part & mask);
    done += take;
  }
}

}  // namespace pineda::spec
