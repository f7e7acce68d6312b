#include "model/fast/tile_shader.h"

#include <algorithm>

#include "model/core/perspective.h"
#include "model/fast/reciprocal.h"
#include "model/fast/tile_values.h"

namespace pineda::fast {

namespace {

Format format_of(const spec::Design& d, int plane_bits, int code_bits) {
  return {plane_bits, d.tile_fraction_bits, code_bits,
          d.gradient_fraction_bits - d.tile_fraction_bits};
}

}  // namespace

TileShader::TileShader(const spec::Contract& contract, const spec::FrameState& frame, Values values)
    : contract_(contract),
      tests_depth_(core::tests_depth(contract, frame)),
      has_colors_(values == Values::kAll && spec::channels(contract.design) > 0),
      depth_{
          format_of(contract.design, contract.width.depth_tile_plane, contract.design.depth_bits),
          core::passes_when(frame.depth), frame.depth_write},
      colors_{format_of(contract.design, contract.width.attr_tile_plane,
                        contract.design.attribute_bits)},
      tested_(contract.design) {}

void TileShader::begin(const spec::SetupPrim& prim) {
  prim_ = &prim;
  depth_.bias = prim.planes.z_bias;
  colors_.planes = prim.planes.attr.data();
  colors_.flat = prim.planes.flat.data();
}

TileOffset TileShader::offset(int x, int y) const {
  const int log2 = contract_.design.tile_log2;
  return {static_cast<uint64_t>(x - (prim_->x0 >> log2)) << log2,
          static_cast<uint64_t>(y - (prim_->y0 >> log2)) << log2};
}

uint32_t TileShader::depth_floor(int tile_x, int tile_y) const {
  const TilePlane z = plane_in_tile(prim_->planes.z, depth_.format, offset(tile_x, tile_y));
  const int head = 64 - depth_.format.plane_bits;
  const auto value = [head](uint64_t top) { return static_cast<int64_t>(top) >> head; };
  spec::PlaneSet planes;
  planes.z_steep = prim_->planes.z_steep;
  planes.z_bias = prim_->planes.z_bias;
  planes.z = {value(z.dx), value(z.dy), value(z.ref)};
  return core::depth_floor(contract_, planes);
}

void TileShader::count_hits(const TileCover& cover, TiledBuffer* buffer) const {
  count_tile(cover, buffer);
}

void TileShader::draw(const TileCover& cover, TiledBuffer* buffer) {
  const TileOffset tile = offset(cover.x, cover.y);
  if (tests_depth_) {
    depth_.plane = plane_in_tile(prim_->planes.z, depth_.format, tile);
    test_depth(cover, buffer);
  } else {
    all_ = &cover.covered;
  }
  counts_.add(passed());
  if (!has_colors_ || passed().count == 0) return;
  colors_.tile = tile;
  if (contract_.design.perspective) {
    draw_perspective(cover, buffer);
  } else {
    write_tile(contract_.design, colors_, cover, passed(), buffer);
  }
}

void TileShader::test_depth(const TileCover& cover, TiledBuffer* buffer) {
  const Outcome outcome = test_tile(depth_, cover, buffer, &tested_);
  all_ = nullptr;
  if (outcome.passed == 0) {
    tested_.count = tested_.sample_count = 0;
    std::fill(tested_.stamps.begin(), tested_.stamps.end(), 0);
  } else if (outcome.failed != 0) {
    find_stamps(contract_.design, cover, &tested_);
  } else {
    all_ = &cover.covered;
  }
}

void TileShader::draw_perspective(const TileCover& cover, TiledBuffer* buffer) {
  const spec::Design& d = contract_.design;
  const auto across = static_cast<int64_t>(colors_.tile.right);
  const auto down = static_cast<int64_t>(colors_.tile.down);
  for (size_t i = 0; i < 3; ++i) {
    const spec::EdgeFunction& e = prim_->edge[i];
    stamp_.edge[i] = {e.a, e.b, e.e + e.a * across + e.b * down};
  }
  stamp_.planes.perspective = prim_->planes.perspective;
  color_.flat = prim_->planes.flat;
  const int columns_log2 = cover.box.columns_log2;
  passed().for_each_stamp([&](int place) {
    const uint32_t passed = lanes_of(d, this->passed(), place);
    stamp_.x = (cover.x << columns_log2) + (place & ((1 << columns_log2) - 1));
    stamp_.y = (cover.y << (d.tile_log2 - d.stamp_height_log2)) + (place >> columns_log2);
    const int x = (stamp_.x << d.stamp_width_log2) - (cover.x << d.tile_log2);
    const int y = (stamp_.y << d.stamp_height_log2) - (cover.y << d.tile_log2);
    core::for_each_lane(d, passed, [&](size_t lane, int column, int row) {
      const auto product = core::weight_products(contract_, stamp_, x + column, y + row);
      const auto sum = reciprocal(contract_, product[0] + product[1] + product[2]);
      core::weigh_attributes(contract_, stamp_, product, sum, &color_.attr[lane]);
    });
    color_.x = stamp_.x;
    color_.y = stamp_.y;
    color_.mask = passed;
    buffer->write(contract_, color_);
  });
}

}  // namespace pineda::fast
