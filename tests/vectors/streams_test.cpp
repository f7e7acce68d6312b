// Rows of streams hold what the structs hold, at the places where SystemVerilog has them.
#include "vectors/grammar/streams.h"

#include <gtest/gtest.h>

#include "model/spec/difference.h"
#include "model/spec/pack.h"
#include "tests/vectors/samples.h"

namespace pineda::vectors {
namespace {

TEST(Streams, ARowIsPackedAsItsStructIs) {
  const SetupCase value = sample_case<SetupCase>();
  const auto shapes = stream_shapes<SetupCase>(kContract);
  ASSERT_EQ(shapes.size(), 4u);
  EXPECT_EQ(shapes[0].name, "case");
  EXPECT_EQ(shapes[1].name, "triangle");
  EXPECT_EQ(shapes[2].name, "setup_prim");
  EXPECT_EQ(shapes[3].name, "drop");
  std::vector<size_t> rows(shapes.size());
  const spec::Packer<spec::SetupPrim> packer(kContract);
  EXPECT_EQ(shapes[2].bits, packer.bits());
  for_each_row<SetupCase>(kContract, value, [&](size_t stream, const std::vector<int64_t>& values) {
    const StreamShape& shape = shapes[stream];
    ASSERT_EQ(values.size(), shape.columns.size());
    if (stream == 2) {
      spec::Packed words(static_cast<size_t>(packer.words()) + 1);
      for (size_t i = 0; i < values.size(); ++i) {
        spec::set_bits(words.data(), shape.columns[i].position, shape.columns[i].bits,
                       static_cast<uint64_t>(values[i]));
      }
      const spec::SetupPrim read = packer.unpack(words.data());
      EXPECT_EQ(spec::difference(kContract, value.out[rows[stream]], read), std::nullopt);
    }
    ++rows[stream];
  });
  EXPECT_EQ(rows, (std::vector<size_t>{1, 3, 2, 3}));
}

TEST(Streams, OfAFrameHoldCountersAndSamples) {
  const FrameCase value = sample_case<FrameCase>();
  const auto shapes = stream_shapes<FrameCase>(kContract);
  std::vector<int64_t> last;
  for_each_row<FrameCase>(kContract, value, [&](size_t stream, const std::vector<int64_t>& values) {
    if (stream == 2) {
      EXPECT_EQ(values[0], 3);  // triangles
    } else if (stream == 3) {
      last = values;
    }
  });
  const Sample& sample = value.samples.back();
  EXPECT_EQ(shapes[3].bits, 16 + 16 + 24 + 4 * 8 + 16);
  EXPECT_EQ(last,
            (std::vector<int64_t>{sample.x, sample.y, sample.depth, sample.color[0],
                                  sample.color[1], sample.color[2], sample.color[3], sample.hits}));
}

}  // namespace
}  // namespace pineda::vectors
