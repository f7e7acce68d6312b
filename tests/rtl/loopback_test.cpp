// Every struct, one bit at a time, through the RTL's view of its fields and back.
#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

// A port as bits.
spec::Packed read_bits(const PortData& port) {
  spec::Packed words((port.bytes + 3) / 4, 0);
  std::memcpy(words.data(), port.data, port.bytes);
  return words;
}

// Sets one bit of a struct at a time. Counts where packed bits and fields disagree, in both
// directions.
template <class T>
int disagreements(const RtlLibrary& library) {
  const spec::Contract& c = library.contract();
  const std::string name = spec::struct_name<T>();
  RtlUnit unit(library, "loopback");
  PayloadPort<T> whole_in(unit, name + "_i");
  PayloadPort<T> whole_out(unit, name + "_o");
  const spec::Packer<T> packer(c);
  const spec::Packed zeros(static_cast<size_t>(packer.words()), 0);
  int wrong = 0;
  int bits = 0;
  for (const auto& field : packer.table()) {
    for (int i = 0; i < field.count * field.bits; ++i, ++bits) {
      const int element = i / field.bits;
      T value = packer.unpack(zeros.data());  // some structs do not start as zeros
      field.set(c, value, element, spec::wrap(int64_t{1} << (i % field.bits), 64));
      whole_in.set(value);
      // The field's own ports must show this bit, all others zero.
      for (const auto& other : packer.table()) {
        const PortData in = unit.port(name + "_" + other.name + "_i");
        std::memset(in.data, 0, in.bytes);
        if (&other == &field) {
          spec::Packed words((in.bytes + 3) / 4, 0);
          spec::set_bits(words.data(), i, 1, 1);
          std::memcpy(in.data, words.data(), in.bytes);
        }
      }
      unit.settle();
      for (const auto& other : packer.table()) {
        const auto out = read_bits(unit.port(name + "_" + other.name + "_o"));
        for (int b = 0; b < other.count * other.bits; ++b) {
          const uint64_t expected = &other == &field && b == i ? 1 : 0;
          wrong += spec::get_bits(out.data(), b, 1) == expected ? 0 : 1;
        }
      }
      wrong += packer.pack(whole_out.get()) == packer.pack(value) ? 0 : 1;
    }
  }
  EXPECT_EQ(bits, packer.bits());
  return wrong;
}

template <class T>
class LoopbackRtl : public testing::Test {};
using Structs =
    testing::Types<spec::FrameState, spec::Triangle, spec::SetupPrim, spec::Tile, spec::Stamp,
                   spec::DepthRead, spec::DepthData, spec::DepthWrite, spec::ColorWrite>;
struct StructName {
  template <class T>
  static std::string GetName(int) {
    return spec::struct_name<T>();
  }
};
TYPED_TEST_SUITE(LoopbackRtl, Structs, StructName);

TYPED_TEST(LoopbackRtl, EveryBitArrivesInItsField) {
  EXPECT_EQ(disagreements<TypeParam>(rtl()), 0);
}

TEST(LoopbackRtlMutant, SwappedFieldsAreCaught) {
  EXPECT_GT(disagreements<spec::Tile>(mutant()), 0);
}

}  // namespace
}  // namespace pineda::tb
