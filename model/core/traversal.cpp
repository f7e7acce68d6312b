#include "model/core/traversal.h"

#include <algorithm>

namespace pineda::core {

using spec::Contract;
using spec::Plane;
using spec::round_half_up;
using spec::SetupPrim;
using spec::wrap;

namespace {

size_t affine_attributes(const Contract& c) {
  return c.design.perspective ? 0 : static_cast<size_t>(c.design.attributes);
}

}  // namespace

TileWalk::TileWalk(const Contract& contract, const SetupPrim& prim, TileRows rows)
    : contract_(contract),
      prim_(prim),
      x_(prim.x0 >> contract.design.tile_log2),
      y_(prim.y0 >> contract.design.tile_log2),
      first_x_(x_),
      last_x_(prim.x1 >> contract.design.tile_log2),
      last_y_(std::min(prim.y1 >> contract.design.tile_log2, rows.last)),
      start_x_(x_),
      turns_(any_edge(false, false) && any_edge(true, true)),
      planes_(prim.planes) {
  for (size_t i = 0; i < 3; ++i) edge_[i] = start_edge_[i] = prim.edge[i].e;
  start_ref_[0] = prim.planes.z.ref;
  for (size_t i = 0; i < spec::kMaxAttributes; ++i) start_ref_[i + 1] = prim.planes.attr[i].ref;
  while (y_ < std::min(rows.first, last_y_ + 1)) {
    test();
    step();
  }
}

TileWalk::Test TileWalk::next(Tile* tile) {
  if (y_ > last_y_) return Test::kEnd;
  test();
  const bool rejected = rejects_[0] || rejects_[1] || rejects_[2];
  if (!rejected) fill(tile);
  step();
  return rejected ? Test::kRejected : Test::kKept;
}

bool TileWalk::any_edge(bool falls_rightward, bool falls_downward) const {
  return std::any_of(prim_.edge.begin(), prim_.edge.end(), [&](const spec::EdgeFunction& edge) {
    return (edge.a < 0) == falls_rightward && (edge.b <= 0) == falls_downward;
  });
}

void TileWalk::test() {
  const int64_t span = (1 << contract_.design.tile_log2) - 1;  // first to last sample of a tile
  accepts_ = 0;
  for (size_t i = 0; i < 3; ++i) {
    const int64_t a = span * prim_.edge[i].a;
    const int64_t b = span * prim_.edge[i].b;
    const int64_t zero = 0;
    rejects_[i] = edge_[i] + std::max(a, zero) + std::max(b, zero) < 0;
    const bool accepts = edge_[i] + std::min(a, zero) + std::min(b, zero) >= 0;
    accepts_ |= static_cast<uint32_t>(accepts) << i;
  }
}

void TileWalk::fill(Tile* tile) const {
  const int log2 = contract_.design.tile_log2;
  const int last = (1 << log2) - 1;
  tile->id = prim_.id;
  tile->accepted = accepts_;
  tile->x = x_;
  tile->y = y_;
  tile->x0 = std::max(prim_.x0 - (x_ << log2), 0);
  tile->y0 = std::max(prim_.y0 - (y_ << log2), 0);
  tile->x1 = std::min(prim_.x1 - (x_ << log2), last);
  tile->y1 = std::min(prim_.y1 - (y_ << log2), last);
  for (size_t i = 0; i < 3; ++i)
    tile->edge[i] = {prim_.edge[i].a, prim_.edge[i].b, wrap(edge_[i], contract_.width.tile_edge)};

  const int shift = contract_.design.gradient_fraction_bits - contract_.design.tile_fraction_bits;
  const auto narrow = [shift](const Plane& p, int bits) {
    return Plane{wrap(round_half_up(p.dx, shift), bits), wrap(round_half_up(p.dy, shift), bits),
                 wrap(round_half_up(p.ref, shift), bits)};
  };
  tile->planes.z = narrow(planes_.z, contract_.width.depth_tile_plane);
  for (size_t i = 0; i < affine_attributes(contract_); ++i) {
    tile->planes.attr[i] = narrow(planes_.attr[i], contract_.width.attr_tile_plane);
  }
  tile->planes.z_bias = planes_.z_bias;
  tile->planes.z_steep = planes_.z_steep;
  const auto flat = static_cast<size_t>(contract_.design.flat_attributes);
  std::copy_n(planes_.flat.begin(), flat, tile->planes.flat.begin());
  if (contract_.design.perspective) tile->planes.perspective = planes_.perspective;
}

void TileWalk::step() {
  if (past_ || x_ == (leftward_ ? first_x_ : last_x_)) return step_down();
  bool outside_below = false;  // in the rows below too
  for (size_t i = 0; i < 3; ++i) {
    const bool falls_ahead = (prim_.edge[i].a < 0) != leftward_;
    past_ |= rejects_[i] && falls_ahead;
    outside_below |= rejects_[i] && !falls_ahead && prim_.edge[i].b <= 0;
  }
  const bool to_the_end = turns_ && !leftward_;
  if (to_the_end) past_ = false;
  const bool start_follows = x_ == start_x_ && (outside_below || to_the_end);
  step_across();
  if (!start_follows) return;
  start_x_ = x_;
  start_edge_ = edge_;
  start_ref_[0] = planes_.z.ref;
  for (size_t i = 0; i < spec::kMaxAttributes; ++i) start_ref_[i + 1] = planes_.attr[i].ref;
}

void TileWalk::step_across() {
  const int log2 = contract_.design.tile_log2;
  const int64_t step = leftward_ ? -(int64_t{1} << log2) : int64_t{1} << log2;
  x_ += leftward_ ? -1 : 1;
  for (size_t i = 0; i < 3; ++i) edge_[i] += prim_.edge[i].a * step;
  const auto across = [step](Plane* p, int bits) { p->ref = wrap(p->ref + p->dx * step, bits); };
  across(&planes_.z, contract_.width.depth_plane);
  for (size_t i = 0; i < affine_attributes(contract_); ++i) {
    across(&planes_.attr[i], contract_.width.attr_plane);
  }
}

void TileWalk::step_down() {
  const int log2 = contract_.design.tile_log2;
  x_ = start_x_;
  ++y_;
  past_ = false;
  leftward_ = turns_;
  for (size_t i = 0; i < 3; ++i) {
    start_edge_[i] += prim_.edge[i].b * (int64_t{1} << log2);
    edge_[i] = start_edge_[i];
  }
  const auto down = [log2](Plane* p, int64_t* start, int bits) {
    p->ref = *start = wrap(*start + p->dy * (int64_t{1} << log2), bits);
  };
  down(&planes_.z, &start_ref_[0], contract_.width.depth_plane);
  for (size_t i = 0; i < affine_attributes(contract_); ++i) {
    down(&planes_.attr[i], &start_ref_[i + 1], contract_.width.attr_plane);
  }
}

StampWalk::StampWalk(const Contract& contract, const Tile& tile)
    : contract_(contract),
      tile_(tile),
      first_x_(tile.x0 >> contract.design.stamp_width_log2),
      last_x_(tile.x1 >> contract.design.stamp_width_log2),
      last_y_(tile.y1 >> contract.design.stamp_height_log2),
      x_(first_x_),
      y_(tile.y0 >> contract.design.stamp_height_log2) {}

void StampWalk::begin(spec::Stamp* stamp) const {
  stamp->id = tile_.id;
  stamp->first = true;
  stamp->planes = tile_.planes;
  if (contract_.design.perspective) stamp->edge = tile_.edge;
}

bool StampWalk::next(uint32_t* mask, int* x, int* y) {
  if (y_ > last_y_) return false;
  const int w_log2 = contract_.design.stamp_width_log2;
  const int h_log2 = contract_.design.stamp_height_log2;
  uint32_t bits = 0;
  for (int lane = 0; lane < contract_.width.lanes; ++lane) {
    const int px = (x_ << w_log2) + (lane & ((1 << w_log2) - 1));
    const int py = (y_ << h_log2) + (lane >> w_log2);
    bool inside = px >= tile_.x0 && px <= tile_.x1 && py >= tile_.y0 && py <= tile_.y1;
    for (size_t i = 0; i < 3; ++i) {
      const auto& edge = tile_.edge[i];
      inside &= (tile_.accepted >> i & 1) != 0 || edge.e + px * edge.a + py * edge.b >= 0;
    }
    bits |= static_cast<uint32_t>(inside) << lane;
  }
  *mask = bits;
  *x = (tile_.x << (contract_.design.tile_log2 - w_log2)) + x_;
  *y = (tile_.y << (contract_.design.tile_log2 - h_log2)) + y_;
  if (x_ < last_x_) {
    ++x_;
  } else {
    x_ = first_x_;
    ++y_;
  }
  return true;
}

}  // namespace pineda::core
