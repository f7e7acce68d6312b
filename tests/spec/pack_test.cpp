// Packing: the first field on top, element 0 lowest, every bit owned by one field.
#include "model/spec/pack.h"

#include <gtest/gtest.h>

#include <string>

#include "model/spec/random.h"

namespace pineda::spec {
namespace {

constexpr Contract kContract = contract(kHighTile);

// A design whose structs have other counts and widths.
constexpr Design wide_stamps() {
  Design d;
  d.subpixel_bits = 4;
  d.depth_bits = 16;
  d.attributes = 7;
  d.attribute_bits = 11;
  d.tile_log2 = 4;
  d.stamp_width_log2 = 2;
  d.stamp_height_log2 = 2;
  return d;
}

TEST(Bits, HandWorkedAcrossWords) {
  uint32_t words[3] = {0, 0, 0};
  set_bits(words, 28, 8, 0xab);
  EXPECT_EQ(words[0], 0xb0000000u);
  EXPECT_EQ(words[1], 0x0000000au);
  EXPECT_EQ(get_bits(words, 28, 8), 0xabu);
  set_bits(words, 16, 64, 0x0123456789abcdefu);
  EXPECT_EQ(words[0], 0xcdef0000u);
  EXPECT_EQ(words[1], 0x456789abu);
  EXPECT_EQ(words[2], 0x00000123u);
  EXPECT_EQ(get_bits(words, 16, 64), 0x0123456789abcdefu);
}

TEST(Bits, SetLeavesAllOtherBitsAlone) {
  for (const uint32_t fill : {0u, 0xffffffffu}) {
    for (int bits = 1; bits <= 64; ++bits) {
      for (int position = 0; position + bits <= 96; ++position) {
        uint32_t words[3] = {fill, fill, fill};
        set_bits(words, position, bits, fill == 0 ? UINT64_MAX : 0);
        for (int i = 0; i < 96; ++i) {
          const bool changed = i >= position && i < position + bits;
          ASSERT_EQ(get_bits(words, i, 1), (fill & 1) ^ (changed ? 1u : 0u))
              << bits << " bits at " << position << ", bit " << i;
        }
      }
    }
  }
}

template <class T>
void random_fields(Random& random, const Contract& c, T* value) {
  for (const auto& field : fields<T>(c)) {
    for (int i = 0; i < field.count; ++i) {
      const auto raw = static_cast<int64_t>(random.bits());
      const int64_t unsigned_value =
          field.bits >= 64 ? raw : raw & ((int64_t{1} << field.bits) - 1);
      field.set(c, *value, i, field.is_signed ? wrap(raw, field.bits) : unsigned_value);
    }
  }
}

template <class T>
class Packing : public testing::Test {};
using Structs = testing::Types<FrameState, Triangle, SetupPrim, Tile, Stamp, DepthRead, DepthData,
                               DepthWrite, ColorWrite>;

struct StructNames {
  template <class T>
  static std::string GetName(int) {
    return struct_name<T>();
  }
};
TYPED_TEST_SUITE(Packing, Structs, StructNames);

TYPED_TEST(Packing, RoundTripKeepsEveryField) {
  Random random(1);
  for (const Contract& c : {kContract, contract(wide_stamps())}) {
    const Packer<TypeParam> packer(c);
    for (int n = 0; n < 200; ++n) {
      TypeParam value{};
      random_fields(random, c, &value);
      Packed words(static_cast<size_t>(packer.words()), 0xdeadbeef);  // stale
      packer.pack(value, words.data());
      const TypeParam back = packer.unpack(words.data());
      for (const auto& field : packer.table()) {
        for (int i = 0; i < field.count; ++i) {
          ASSERT_EQ(field.get(c, back, i), field.get(c, value, i)) << field.name << '[' << i << ']';
        }
      }
      ASSERT_EQ(packer.pack(back), words);
      if (packer.bits() % 32 != 0) {
        ASSERT_EQ(words.back() >> packer.bits() % 32, 0u);
      }
    }
  }
}

// A walking one: each bit of the packed struct belongs to one element of one field, in the table's
// order from the top, the elements of a field from the bottom. This is also the proof that a
// misplaced field is seen: no bit moves without changing the one value that owns it.
TYPED_TEST(Packing, WalkingOneLandsInTheFieldAndElementOfTheTable) {
  for (const Contract& c : {kContract, contract(wide_stamps())}) {
    const Packer<TypeParam> packer(c);
    int top = packer.bits();
    for (const auto& owner : packer.table()) {
      top -= owner.bits * owner.count;
      for (int bit = 0; bit < owner.bits * owner.count; ++bit) {
        Packed words(static_cast<size_t>(packer.words()));
        set_bits(words.data(), top + bit, 1, 1);
        const TypeParam value = packer.unpack(words.data());
        for (const auto& field : packer.table()) {
          for (int i = 0; i < field.count; ++i) {
            const bool mine = &field == &owner && i == bit / owner.bits;
            const int64_t wanted =
                !mine ? 0
                : field.is_signed
                    ? wrap(static_cast<int64_t>(uint64_t{1} << bit % owner.bits), owner.bits)
                    : int64_t{1} << bit % owner.bits;
            ASSERT_EQ(field.get(c, value, i), wanted) << field.name << '[' << i << "] bit " << bit;
          }
        }
      }
    }
    EXPECT_EQ(top, 0);
  }
}

TEST(PackOrder, FirstFieldLiesOnTopAndElementZeroLowest) {
  const Packer<Triangle> packer(kContract);
  Triangle t;
  t.id = 0xcafef00d;
  t.v[0].x = -1;
  t.v[2].attr[3] = 0xa5;
  const Packed words = packer.pack(t);
  EXPECT_EQ(get_bits(words.data(), packer.bits() - 32, 32), 0xcafef00du);
  // x: three of 23 bits right below; vertex 0 is the lowest of them.
  EXPECT_EQ(get_bits(words.data(), packer.bits() - 32 - 69, 23), 0x7fffffu);
  EXPECT_EQ(get_bits(words.data(), packer.bits() - 32 - 46, 46), 0u);
  // attr is the last field, so it starts at bit 0; the last element is its top byte.
  EXPECT_EQ(get_bits(words.data(), 88, 8), 0xa5u);
  EXPECT_EQ(get_bits(words.data(), 0, 64), 0u);
}

}  // namespace
}  // namespace pineda::spec
