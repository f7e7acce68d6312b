#include "vectors/generator/raw_cases.h"

#include <algorithm>
#include <cstdlib>

#include "model/core/perspective.h"
#include "model/spec/package.h"
#include "model/spec/random.h"

namespace pineda::vectors {
namespace {

using spec::Contract;

// A plane with every bit random: it wraps and leaves the output's range.
spec::Plane raw_plane(spec::Random& random, int bits) {
  const auto any = [&] { return spec::wrap(static_cast<int64_t>(random.bits()), bits); };
  return {any(), any(), any()};
}

/// Draws the stamps of raw_weights().
class WeightDraw {
 public:
  WeightDraw(const Contract& contract, spec::Random* random) : c_(contract), random_(*random) {}

  spec::Stamp stamp(uint32_t id) {
    const spec::Design& d = c_.design;
    spec::Stamp stamp;
    stamp.id = id;
    stamp.x = any(0, (2 << d.tile_log2 >> d.stamp_width_log2) - 1);
    stamp.y = any(0, (2 << d.tile_log2 >> d.stamp_height_log2) - 1);
    // The sample that is drawn for; the others are what follows from it.
    const int lane = any(0, c_.width.lanes - 1);
    const Place place = place_of(stamp, lane);
    kind_ = static_cast<Kind>(any(0, 3));
    for (size_t v = 0; v < 3; ++v) draw_vertex(v, place, &stamp);
    for (int other = 0; other < c_.width.lanes; ++other) {
      if (is_covered(stamp, place_of(stamp, other))) stamp.mask |= 1U << other;
    }
    stamp.planes.z = raw_plane(random_, c_.width.depth_tile_plane);
    draw_attributes(place, &stamp);
    return stamp;
  }

 private:
  enum class Kind { kTiny, kSmall, kAnyLength, kPowers };
  /// A sample's column and row in its tile.
  struct Place {
    int i, j;
  };

  int any(int low, int high) { return random_.between(low, high); }

  Place place_of(const spec::Stamp& stamp, int lane) const {
    const spec::Design& d = c_.design;
    const int tile = (1 << d.tile_log2) - 1;
    return {((stamp.x << d.stamp_width_log2) & tile) + (lane & ((1 << d.stamp_width_log2) - 1)),
            ((stamp.y << d.stamp_height_log2) & tile) + (lane >> d.stamp_width_log2)};
  }

  int64_t greatest_edge() const { return (int64_t{1} << (c_.width.edge - 1)) - 1; }

  // E of an edge, in the units of the doubled area; not 0.
  int64_t edge_value() {
    const int bits = c_.width.area2 - 1;
    if (kind_ == Kind::kTiny) return any(1, 4);
    if (kind_ == Kind::kSmall) return any(1, 64);
    if (kind_ == Kind::kPowers) return int64_t{1} << any(0, bits - 1);
    const int64_t greatest = (int64_t{1} << any(1, bits)) - 1;
    return random_.between(int64_t{1}, greatest);
  }
  int64_t coefficient() {
    const int sign = any(-1, 1);
    if (sign == 0) return 0;
    const int64_t power = int64_t{1} << any(0, c_.width.edge_coeff - 2);
    return sign * (kind_ == Kind::kPowers ? power : random_.between(int64_t{1}, power));
  }
  int32_t inverse_w() {
    const int bits = c_.design.inverse_w_bits;
    if (kind_ == Kind::kPowers) return 1 << any(0, bits - 1);
    if (kind_ == Kind::kTiny) return any(1, 4);  // as no vertex has it
    return any(1 << (bits - 1), (1 << bits) - 1);
  }

  void draw_vertex(size_t v, Place place, spec::Stamp* stamp) {
    const int subpixel_bits = c_.design.subpixel_bits;
    const size_t opposite = (v + 1) % 3;
    const int64_t value = edge_value();
    spec::EdgeFunction& edge = stamp->edge[opposite];
    int64_t low = 0;
    const auto set = [&](int64_t a, int64_t b) {
      const bool is_top_left = a > 0 || (a == 0 && b > 0);
      low = value - (is_top_left ? 0 : 1);
      edge = {a, b, (low >> subpixel_bits) - place.i * a - place.j * b};
    };
    const int64_t a = coefficient();
    set(a, coefficient());
    if (std::abs(edge.e) > greatest_edge()) set(0, 0);
    spec::PerspectiveSet& p = stamp->planes.perspective;
    p.e_low[opposite] = static_cast<int32_t>(low & ((1 << subpixel_bits) - 1));
    p.inverse_w[v] = inverse_w();
    p.inverse_w_shift[v] = any(0, 3) == 0 ? any(0, (1 << spec::kInverseWShiftBits) - 1) : any(0, 2);
  }

  bool is_covered(const spec::Stamp& stamp, Place place) const {
    return std::all_of(stamp.edge.begin(), stamp.edge.end(), [&](const spec::EdgeFunction& edge) {
      const int64_t e = edge.e + place.i * edge.a + place.j * edge.b;
      return e >= 0 && e <= greatest_edge();
    });
  }

  // As close to half a code as two of the vertices' attributes allow: every other one from below.
  void draw_attributes(Place place, spec::Stamp* stamp) {
    const auto product = core::weight_products(c_, *stamp, place.i, place.j);
    const core::Reciprocal r = core::reciprocal(c_, product[0] + product[1] + product[2]);
    const int64_t one = int64_t{1} << spec::kWeightFractionBits;
    const auto weight = [&](size_t v) {
      const int shift = c_.design.reciprocal_bits + r.length - 1 - spec::kWeightFractionBits;
      const auto share = static_cast<spec::int128_t>(product[v]) * r.mantissa;
      return std::min(one, static_cast<int64_t>(spec::round_half_up(share, shift)));
    };
    const int64_t g1 = weight(1), g2 = weight(2);
    const int top = (1 << c_.design.attribute_bits) - 1;
    auto& attr = stamp->planes.perspective.attr;
    for (size_t n = 0; n < static_cast<size_t>(c_.design.attributes); ++n) {
      const int a0 = any(0, top);
      const int first1 = any(0, top), first2 = any(0, top);
      constexpr int kTries = 200;  // of each: the nearest of 40,000
      int64_t nearest = one;
      for (int i = 0; i < kTries; ++i) {
        for (int j = 0; j < kTries; ++j) {
          const int a1 = (first1 + i) & top, a2 = (first2 + j) & top;
          const int64_t sum = g1 * (a1 - a0) + g2 * (a2 - a0) + one / 2;
          const int64_t above = sum & (one - 1);
          const int64_t distance = n % 2 == 0 ? above : one - 1 - above;
          if (distance >= nearest) continue;
          nearest = distance;
          attr[0][n] = a0;
          attr[1][n] = a1;
          attr[2][n] = a2;
        }
      }
    }
  }

  const Contract& c_;
  spec::Random& random_;
  Kind kind_ = Kind::kSmall;
};

}  // namespace

InterpZtestCase raw_stamps(const Contract& c, uint64_t seed, int index) {
  spec::Random random(seed ^ spec::text_hash("raw_planes." + std::to_string(index)));
  const spec::Design& d = c.design;
  InterpZtestCase inputs;
  inputs.name = "raw_planes." + std::to_string(index);
  inputs.frame.width = inputs.frame.height = 2 << d.tile_log2;
  inputs.frame.depth = static_cast<spec::DepthFunc>(index % 9);
  for (uint32_t i = 0; i < 12; ++i) {
    spec::Stamp stamp;
    stamp.id = i;
    stamp.x = static_cast<int>(random.between(0, (2 << d.tile_log2 >> d.stamp_width_log2) - 1));
    stamp.y = static_cast<int>(random.between(0, (2 << d.tile_log2 >> d.stamp_height_log2) - 1));
    stamp.mask = static_cast<uint32_t>(random.between(1, (int64_t{1} << c.width.lanes) - 1));
    stamp.planes.z = raw_plane(random, c.width.depth_tile_plane);
    stamp.planes.z_bias = spec::wrap(static_cast<int64_t>(random.bits()), c.width.depth_bias);
    for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
      stamp.planes.attr[a] = raw_plane(random, c.width.attr_tile_plane);
    }
    inputs.in.push_back(stamp);
  }
  return run_model(c, inputs);
}

TraversalCase raw_prims(const Contract& c, uint64_t seed, int index) {
  const spec::Design& d = c.design;
  TraversalCase inputs;
  inputs.name = "raw_edges." + std::to_string(index);
  spec::Random random(seed ^ spec::text_hash(inputs.name));
  const int side = std::min(4 << d.tile_log2, 1 << d.guard_bits);
  inputs.frame.width = inputs.frame.height = side;
  const auto sorted = [&](int* low, int* high) {
    *low = static_cast<int>(random.between(0, side - 1));
    *high = static_cast<int>(random.between(*low, side - 1));
  };
  const auto of_any_length = [&](int bits) {
    const int64_t greatest = (int64_t{1} << random.between(0, bits)) - 1;
    return random.between(-greatest, greatest);
  };
  for (uint32_t i = 0; i < 4; ++i) {
    spec::SetupPrim prim;
    prim.id = i;
    sorted(&prim.x0, &prim.x1);
    sorted(&prim.y0, &prim.y1);
    for (spec::EdgeFunction& edge : prim.edge) {
      edge.a = of_any_length(c.width.edge_coeff - 1);
      edge.b = of_any_length(c.width.edge_coeff - 1);
      const int64_t x = random.between(0, side - 1), y = random.between(0, side - 1);
      const int64_t near = of_any_length(8) - edge.a * x - edge.b * y;
      const int64_t room = side * (std::abs(edge.a) + std::abs(edge.b));
      const int64_t farthest = (int64_t{1} << (c.width.edge - 1)) - 1 - room;
      const int64_t anywhere = of_any_length(c.width.edge - 1);
      edge.e = random.between(0, 3) == 0 ? std::clamp(anywhere, -farthest, farthest) : near;
    }
    prim.planes.z = raw_plane(random, c.width.depth_plane);
    prim.planes.z_bias = spec::wrap(static_cast<int64_t>(random.bits()), c.width.depth_bias);
    for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
      prim.planes.attr[a] = raw_plane(random, c.width.attr_plane);
    }
    spec::PerspectiveSet& p = prim.planes.perspective;
    for (size_t k = 0; k < 3 && d.perspective; ++k) {
      p.e_low[k] = static_cast<int32_t>(random.between(0, (1 << d.subpixel_bits) - 1));
      p.inverse_w[k] = static_cast<int32_t>(
          random.between(1 << (d.inverse_w_bits - 1), (1 << d.inverse_w_bits) - 1));
      p.inverse_w_shift[k] =
          static_cast<int32_t>(random.between(0, (1 << spec::kInverseWShiftBits) - 1));
      for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
        p.attr[k][a] = static_cast<int32_t>(random.between(0, (1 << d.attribute_bits) - 1));
      }
    }
    inputs.in.push_back(prim);
  }
  return run_model(c, inputs);
}

InterpZtestCase raw_weights(const Contract& c, uint64_t seed, int index) {
  InterpZtestCase inputs;
  inputs.name = "raw_weights." + std::to_string(index);
  spec::Random random(seed ^ spec::text_hash(inputs.name));
  WeightDraw draw(c, &random);
  inputs.frame.width = inputs.frame.height = 2 << c.design.tile_log2;
  inputs.frame.depth = spec::DepthFunc::kAlways;
  for (uint32_t i = 0; i < 12; ++i) inputs.in.push_back(draw.stamp(i));
  return run_model(c, inputs);
}

}  // namespace pineda::vectors
