#include "model/core/tile_shader.h"

#include <algorithm>

#include "model/core/lanes.h"
#include "model/core/perspective.h"

namespace pineda::core {

using spec::Plane;
using spec::round_half_up;
using spec::wrap;

namespace {

// From planes modulo 2^bits to codes: the one rounding and the clamp, as vectors of Value.
template <class Value>
struct Coder {
  Value half_range, mask;  // of the plane's modulus
  int up;                  // to the fraction bits of the bias
  Value add;               // the bias, and half a code
  int fraction_bits;
  Value top;

  Coder(int plane_bits, int tile_fraction_bits, int out_bits, int64_t bias)
      : half_range(static_cast<Value>(int64_t{1} << (plane_bits - 1))),
        mask(static_cast<Value>((int64_t{1} << plane_bits) - 1)) {
    const int f =
        bias == 0 ? tile_fraction_bits : std::max(tile_fraction_bits, spec::kBiasFractionBits);
    up = f - tile_fraction_bits;
    add = static_cast<Value>(int64_t{1} << (f - 1));
    if (bias != 0) add += static_cast<Value>(bias * (int64_t{1} << (f - spec::kBiasFractionBits)));
    fraction_bits = f;
    top = static_cast<Value>((int64_t{1} << out_bits) - 1);
  }

  // Shifts to the left and back would wrap as well, but few vector units shift signed 64-bit
  // numbers to the right.
  template <class Vector>
  PINEDA_INLINE void operator()(Vector* v) const {
    Vector sum = ((((*v + half_range) & mask) - half_range) << up) + add;
    sum &= sum > 0;
    sum >>= fraction_bits;
    const auto over = sum > top;
    *v = (sum & ~over) | (top & over);
  }
};

// A row of samples of a frame, as far as the frame goes.
template <class Element, class Vector>
PINEDA_INLINE void load(const Element* from, int count, Vector* to) {
  if (count >= kBlockPx) {
    std::memcpy(to, from, sizeof *to);
    return;
  }
  *to = Vector{};
  std::memcpy(to, from, static_cast<size_t>(count) * sizeof(Element));
}
template <class Element, class Vector>
PINEDA_INLINE void store(const Vector& from, int count, Element* to) {
  if (count >= kBlockPx) {
    std::memcpy(to, &from, sizeof from);
    return;
  }
  std::memcpy(to, &from, static_cast<size_t>(count) * sizeof(Element));
}

// Where a block's rows lie.
struct Rows {
  int x, y;       // of the block, px from the tile's corner
  int count;      // samples of a row that the tile and the frame have
  size_t sample;  // of the first row
  size_t width;   // of the frame

  size_t operator[](int row) const { return sample + static_cast<size_t>(row) * width; }
};

// Calls visit(rows, block) for the blocks in the box of `cover`; block: their number in the tile.
template <class Visitor>
PINEDA_INLINE void for_each_block(const spec::Design& d, const TileCover& cover,
                                  const FrameBuffer& buffer, Visitor&& visit) {
  const auto width = static_cast<size_t>(buffer.width);
  for (int y = cover.y0 & -kBlockPx; y <= cover.y1; y += kBlockPx) {
    for (int x = cover.x0 & -kBlockPx; x <= cover.x1; x += kBlockPx) {
      const int left = (cover.x << d.tile_log2) + x;
      const int top = (cover.y << d.tile_log2) + y;
      const Rows rows{x, y, std::min({kBlockPx, 1 << d.tile_log2, buffer.width - left}),
                      static_cast<size_t>(top) * width + static_cast<size_t>(left), width};
      visit(rows, block_of(d, x, y));
    }
  }
}

uint32_t row_of(uint64_t block, int row) {
  return static_cast<uint32_t>(block >> (kBlockPx * row) & 0xff);
}

struct DepthTest {
  Plane plane;
  Coder<int64_t> coder;
  PassesWhen when;
  bool writes;
};

// Tests the covered samples of a block and writes those that pass; returns them.
PINEDA_INLINE uint64_t test_block(const DepthTest& test, const Rows& at, uint64_t covered,
                                  uint32_t* depth) {
  Int64x8 x = __builtin_convertvector(kLaneNumbers, Int64x8) + at.x;
  x = x * test.plane.dx + test.plane.ref;
  BlockBits passed;
  for (int row = 0; row < kBlockPx; ++row) {
    const uint32_t lanes = row_of(covered, row);
    if (lanes == 0) continue;
    Int64x8 v = x + (at.y + row) * test.plane.dy;
    test.coder(&v);
    const auto z = __builtin_convertvector(v, Uint32x8);
    uint32_t* const samples = depth + at[row];
    Uint32x8 stored;
    load(samples, at.count, &stored);
    const auto pass = ((kLaneBits & lanes) != 0) & (((z < stored) & -int{test.when.less}) |
                                                    ((z == stored) & -int{test.when.equal}) |
                                                    ((z > stored) & -int{test.when.greater}));
    const auto bits = reinterpret_cast<Uint32x8>(pass);
    passed.add(row, bits);
    if (test.writes) {
      const Uint32x8 merged = (z & bits) | (stored & ~bits);
      store(merged, at.count, samples);
    }
  }
  return passed.bits();
}

/// Which samples of a block passed or failed, all blocks of a tile together.
struct Outcome {
  uint64_t passed = 0;
  uint64_t failed = 0;
};

PINEDA_CLONES Outcome test_tile(const spec::Design& d, const DepthTest& test,
                                const TileCover& cover, FrameBuffer* buffer, TileSamples* samples) {
  Outcome outcome;
  for_each_block(d, cover, *buffer, [&](const Rows& at, size_t block) PINEDA_INLINED {
    const uint64_t covered = cover.covered.blocks[block];
    samples->blocks[block] = test_block(test, at, covered, buffer->depth.data());
    outcome.passed |= samples->blocks[block];
    outcome.failed |= samples->blocks[block] ^ covered;
  });
  return outcome;
}

PINEDA_CLONES void count_tile(const spec::Design& d, const TileCover& cover, FrameBuffer* buffer) {
  typedef uint16_t Uint16x8 __attribute__((vector_size(16)));
  for_each_block(d, cover, *buffer, [&](const Rows& at, size_t block) PINEDA_INLINED {
    for (int row = 0; row < kBlockPx; ++row) {
      const uint32_t lanes = row_of(cover.covered.blocks[block], row);
      if (lanes == 0) continue;
      uint16_t* const samples = buffer->hits.data() + at[row];
      Uint16x8 hits;
      load(samples, at.count, &hits);
      const auto covered = __builtin_convertvector((kLaneBits & lanes) != 0, Uint16x8);
      hits += covered & (hits != UINT16_MAX) & 1;
      store(hits, at.count, samples);
    }
  });
}

struct AffineValues {
  const Plane* planes;
  const int32_t* flat;
};

// Four codes a sample, which is what most designs have: a sample is 64 bits.
template <class Value, class Vector>
PINEDA_INLINE void write_four(
    const std::array<std::array<Value, kBlockPx>, spec::kMaxAttributes>& codes, uint32_t lanes,
    uint16_t* color) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  Int64x8 samples{};
  for (size_t a = 0; a < 4; ++a) {
    Vector v;
    std::memcpy(&v, codes[a].data(), sizeof v);
    samples |= __builtin_convertvector(v, Int64x8) << (16 * a);
  }
  std::array<uint64_t, kBlockPx> words;
  std::memcpy(words.data(), &samples, sizeof samples);
  if (lanes == 0xff) {
    std::memcpy(color, words.data(), sizeof words);
    return;
  }
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<size_t>(__builtin_ctz(lanes));
    std::memcpy(color + 4 * lane, &words[lane], sizeof words[lane]);
  }
}

// The colours of a row of samples, where they passed.
template <class Value, class Vector>
PINEDA_INLINE void write_row(const spec::Design& d, const Coder<Value>& coder,
                             const AffineValues& values, int x, int y, uint32_t lanes,
                             uint16_t* color) {
  const auto attributes = static_cast<size_t>(d.attributes);
  const auto n = static_cast<size_t>(spec::channels(d));
  const Vector numbers = __builtin_convertvector(kLaneNumbers, Vector) + static_cast<Value>(x);
  std::array<std::array<Value, kBlockPx>, spec::kMaxAttributes> codes;
  for (size_t a = 0; a < attributes; ++a) {
    const Plane& p = values.planes[a];
    Vector v = numbers * static_cast<Value>(p.dx) + static_cast<Value>(p.ref + y * p.dy);
    coder(&v);
    std::memcpy(codes[a].data(), &v, sizeof v);
  }
  if (n == 4 && attributes == 4) return write_four<Value, Vector>(codes, lanes, color);
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<size_t>(__builtin_ctz(lanes));
    uint16_t* const to = color + lane * n;
    for (size_t a = 0; a < attributes; ++a) to[a] = static_cast<uint16_t>(codes[a][lane]);
    for (size_t a = attributes; a < n; ++a) {
      to[a] = static_cast<uint16_t>(values.flat[a - attributes]);
    }
  }
}

template <class Value, class Vector>
PINEDA_INLINE void write_tile(const spec::Design& d, const Coder<Value>& coder,
                              const AffineValues& values, const TileCover& cover,
                              const TileSamples& passed, FrameBuffer* buffer) {
  const auto n = static_cast<size_t>(buffer->channels);
  for_each_block(d, cover, *buffer, [&](const Rows& at, size_t block) PINEDA_INLINED {
    for (int row = 0; row < kBlockPx; ++row) {
      const uint32_t lanes = row_of(passed.blocks[block], row);
      if (lanes == 0) continue;
      write_row<Value, Vector>(d, coder, values, at.x, at.y + row, lanes,
                               buffer->color.data() + at[row] * n);
    }
  });
}

PINEDA_CLONES void write_narrow(const spec::Design& d, const Coder<int32_t>& coder,
                                const AffineValues& values, const TileCover& cover,
                                const TileSamples& passed, FrameBuffer* buffer) {
  write_tile<int32_t, Int32x8>(d, coder, values, cover, passed, buffer);
}
PINEDA_CLONES void write_wide(const spec::Design& d, const Coder<int64_t>& coder,
                              const AffineValues& values, const TileCover& cover,
                              const TileSamples& passed, FrameBuffer* buffer) {
  write_tile<int64_t, Int64x8>(d, coder, values, cover, passed, buffer);
}

}  // namespace

TileShader::TileShader(const spec::Contract& contract, const spec::FrameState& frame, Values values,
                       bool with_masks)
    : contract_(contract),
      frame_(frame),
      values_(values),
      with_masks_(with_masks || (values == Values::kAll && contract.design.perspective)),
      when_(passes_when(frame.depth)),
      passed_(contract.design) {}

void TileShader::begin(const spec::SetupPrim& prim) {
  prim_ = &prim;
  const spec::Design& d = contract_.design;
  if (d.depth_test) narrow(prim.planes.z, contract_.width.depth_tile_plane, &z_);
  if (values_ == Values::kDepth || d.perspective) return;
  for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
    narrow(prim.planes.attr[a], contract_.width.attr_tile_plane, &attr_[a]);
  }
}

void TileShader::narrow(const Plane& p, int tile_bits, Plane* in_tile) const {
  const int shift = contract_.design.gradient_fraction_bits - contract_.design.tile_fraction_bits;
  in_tile->dx = wrap(round_half_up(p.dx, shift), tile_bits);
  in_tile->dy = wrap(round_half_up(p.dy, shift), tile_bits);
}

int64_t TileShader::reference(const Plane& p, int x, int y, int plane_bits, int tile_bits) const {
  const int log2 = contract_.design.tile_log2;
  const int shift = contract_.design.gradient_fraction_bits - contract_.design.tile_fraction_bits;
  // Modulo 2^64, so that references far away wrap as steps to them do.
  const auto steps = [log2](int64_t slope, int tiles) {
    return static_cast<uint64_t>(slope) * (static_cast<uint64_t>(tiles) << log2);
  };
  const uint64_t ref = static_cast<uint64_t>(p.ref) + steps(p.dx, x - (prim_->x0 >> log2)) +
                       steps(p.dy, y - (prim_->y0 >> log2));
  return wrap(round_half_up(wrap(static_cast<int64_t>(ref), plane_bits), shift), tile_bits);
}

uint32_t TileShader::depth_floor(int tile_x, int tile_y) const {
  spec::PlaneSet planes;
  planes.z_steep = prim_->planes.z_steep;
  planes.z_bias = prim_->planes.z_bias;
  planes.z = z_;
  planes.z.ref = reference(prim_->planes.z, tile_x, tile_y, contract_.width.depth_plane,
                           contract_.width.depth_tile_plane);
  return core::depth_floor(contract_, planes);
}

void TileShader::count_hits(const TileCover& cover, FrameBuffer* buffer) const {
  count_tile(contract_.design, cover, buffer);
}

void TileShader::draw(const TileCover& cover, FrameBuffer* buffer) {
  if (tests_depth(contract_, frame_)) {
    test_depth(cover, buffer);
  } else {
    passed_.blocks = cover.covered.blocks;
    pass_all(cover);
  }
  counts_.add(passed_);
  const bool colors = values_ == Values::kAll && spec::channels(contract_.design) > 0;
  if (!colors || passed_.count == 0) return;
  if (contract_.design.perspective) {
    draw_perspective(cover, buffer);
  } else {
    draw_affine(cover, buffer);
  }
}

void TileShader::test_depth(const TileCover& cover, FrameBuffer* buffer) {
  const spec::Design& d = contract_.design;
  const int bits = contract_.width.depth_tile_plane;
  z_.ref = reference(prim_->planes.z, cover.x, cover.y, contract_.width.depth_plane, bits);
  const DepthTest test{
      z_, Coder<int64_t>(bits, d.tile_fraction_bits, d.depth_bits, prim_->planes.z_bias), when_,
      frame_.depth_write};
  const Outcome outcome = test_tile(d, test, cover, buffer, &passed_);
  if (outcome.failed == 0) return pass_all(cover);
  if (outcome.passed != 0) return find_stamps(d, cover, with_masks_, &passed_, nullptr);
  passed_.count = passed_.sample_count = 0;
  std::fill(passed_.stamps.begin(), passed_.stamps.end(), 0);
}

// The blocks are those covered already.
void TileShader::pass_all(const TileCover& cover) {
  if (with_masks_) return find_stamps(contract_.design, cover, true, &passed_, nullptr);
  passed_.stamps = cover.covered.stamps;
  passed_.count = cover.covered.count;
  passed_.sample_count = cover.covered.sample_count;
  passed_.first = cover.covered.first;
  passed_.last = cover.covered.last;
}

void TileShader::draw_affine(const TileCover& cover, FrameBuffer* buffer) {
  const spec::Design& d = contract_.design;
  const int bits = contract_.width.attr_tile_plane;
  for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
    attr_[a].ref =
        reference(prim_->planes.attr[a], cover.x, cover.y, contract_.width.attr_plane, bits);
  }
  const AffineValues values{attr_.data(), prim_->planes.flat.data()};
  const auto coder = [&](auto value) {
    return Coder<decltype(value)>(bits, d.tile_fraction_bits, d.attribute_bits, 0);
  };
  // Steps are taken without wrapping them.
  if (bits + std::max(d.tile_log2, spec::ceil_log2(kBlockPx)) + 1 < 32) {
    write_narrow(d, coder(int32_t{}), values, cover, passed_, buffer);
  } else {
    write_wide(d, coder(int64_t{}), values, cover, passed_, buffer);
  }
}

void TileShader::draw_perspective(const TileCover& cover, FrameBuffer* buffer) {
  const spec::Design& d = contract_.design;
  const int64_t across = int64_t{cover.x - (prim_->x0 >> d.tile_log2)} << d.tile_log2;
  const int64_t down = int64_t{cover.y - (prim_->y0 >> d.tile_log2)} << d.tile_log2;
  for (size_t i = 0; i < 3; ++i) {
    const spec::EdgeFunction& e = prim_->edge[i];
    stamp_.edge[i] = {e.a, e.b, e.e + e.a * across + e.b * down};
  }
  stamp_.planes.perspective = prim_->planes.perspective;
  stamp_.planes.flat = prim_->planes.flat;
  const int columns_log2 = d.tile_log2 - d.stamp_width_log2;
  cover.for_each_stamp(passed_, columns_log2, [&](int test, int place) {
    const uint32_t passed = passed_.mask[static_cast<size_t>(test)];
    stamp_.x = (cover.x << columns_log2) + (place & ((1 << columns_log2) - 1));
    stamp_.y = (cover.y << (d.tile_log2 - d.stamp_height_log2)) + (place >> columns_log2);
    interpolate_attributes(contract_, stamp_, passed, &fragment_);
    color_write(contract_, stamp_, fragment_, passed, &color_);
    buffer->write(contract_, color_);
  });
}

}  // namespace pineda::core
