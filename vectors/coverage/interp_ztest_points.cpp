// The coverage of interpolation and depth test, of ports, and of whole frames.
#include <algorithm>
#include <iterator>

#include "model/core/perspective.h"
#include "model/spec/clear_depth.h"
#include "vectors/coverage/points.h"
#include "vectors/coverage/reciprocal_entry.h"

namespace pineda::vectors {

using spec::Contract;
using spec::DepthFunc;

namespace {

bool has_depth(const Contract& c) { return c.design.depth_test; }
bool is_affine(const Contract& c) { return c.design.attributes > 0 && !c.design.perspective; }
bool has_weights(const Contract& c) { return c.design.attributes > 0 && c.design.perspective; }

Bins depth_functions() {
  Bins bins;
  for (const auto& row : spec::kDepthFuncNames) bins.push_back({row.word, ""});
  return bins;
}

// Calls visit(lane, i, j) for each lane of a stamp; i, j: px from the corner of its tile.
template <class Visitor>
void for_each_place(const SeenFragment& s, uint32_t lanes, Visitor&& visit) {
  const spec::Design& d = s.contract.design;
  const int last = (1 << d.tile_log2) - 1;
  const int x = (s.stamp.x << d.stamp_width_log2) & last;
  const int y = (s.stamp.y << d.stamp_height_log2) & last;
  core::for_each_lane(d, lanes, [&](size_t lane, int i, int j) { visit(lane, x + i, y + j); });
}

// Below, in or above the range of codes, once it is rounded.
int range_bin(int64_t value, int fraction_bits, int out_bits) {
  const int64_t rounded = spec::round_half_up(value, fraction_bits);
  return rounded < 0 ? 0 : rounded < int64_t{1} << out_bits ? 1 : 2;
}
Bins ranges() { return named({"below the range", "in the range", "above the range"}); }

int depth_fraction(const Contract& c) {
  return std::max(c.design.tile_fraction_bits, spec::kBiasFractionBits);
}
int64_t plane_value(const spec::Plane& p, int i, int j, int bits) {
  return spec::wrap(p.ref + i * p.dx + j * p.dy, bits);
}

void see_depth_code(const SeenFragment& s, Hits* hits) {
  const Contract& c = s.contract;
  const int f = depth_fraction(c);
  for_each_place(s, s.stamp.mask, [&](size_t, int i, int j) {
    const int64_t z = plane_value(s.stamp.planes.z, i, j, c.width.depth_tile_plane);
    const int64_t sum = z * (int64_t{1} << (f - c.design.tile_fraction_bits)) +
                        s.stamp.planes.z_bias * (int64_t{1} << (f - spec::kBiasFractionBits));
    hits->add(rounding_bin(sum, f));
    hits->add(4 + range_bin(sum, f, c.design.depth_bits));
  });
}

template <class Visitor>
void for_each_attribute(const SeenFragment& s, Visitor&& visit) {
  for_each_place(s, s.passed, [&](size_t, int i, int j) {
    for (size_t a = 0; a < static_cast<size_t>(s.contract.design.attributes); ++a) {
      visit(plane_value(s.stamp.planes.attr[a], i, j, s.contract.width.attr_tile_plane));
    }
  });
}
void see_attribute_rounding(const SeenFragment& s, Hits* hits) {
  for_each_attribute(s, [&](int64_t value) {
    hits->add(rounding_bin(value, s.contract.design.tile_fraction_bits));
  });
}
// A triangle's values stay within half a code of the range.
void see_attribute_range(const SeenGivenStamp& s, Hits* hits) {
  for_each_attribute(s, [&](int64_t value) {
    hits->add(
        range_bin(value, s.contract.design.tile_fraction_bits, s.contract.design.attribute_bits));
  });
}

void see_function(const SeenFragment& s, Hits* hits) {
  const int passes = s.passed == 0 ? 0 : s.passed == s.stamp.mask ? 2 : 1;
  hits->add((static_cast<int>(s.frame.depth) * 2 + (s.frame.depth_write ? 1 : 0)) * 3 + passes);
}
Bins functions(const Contract& c) {
  Bins bins = product(product(depth_functions(), named({"not written", "written"})),
                      named({"none passes", "some pass", "all pass"}));
  for (const DepthFunc func : {DepthFunc::kNever, DepthFunc::kAlways, DepthFunc::kOff}) {
    for (size_t write = 0; write < 2; ++write) {
      Bin* const of = &bins[(static_cast<size_t>(func) * 2 + write) * 3];
      const bool none = func == DepthFunc::kNever;
      for (size_t i = 0; i < 3; ++i) {
        if (i != (none ? 0 : 2)) of[i].unreachable = none ? "no sample passes" : "all pass";
      }
    }
  }
  for (size_t i = 1; i < bins.size() && c.width.lanes == 1; i += 3) {
    if (bins[i].unreachable.empty()) bins[i].unreachable = "a stamp has one sample";
  }
  return bins;
}

void see_comparison(const SeenFragment& s, Hits* hits) {
  if (s.frame.depth == DepthFunc::kOff) return;
  core::for_each_lane(s.contract.design, s.stamp.mask, [&](size_t lane, int, int) {
    const uint32_t z = s.fragment.z[lane], stored = s.stored.z[lane];
    hits->add(static_cast<int>(s.frame.depth) * 3 + (z < stored ? 0 : z == stored ? 1 : 2));
  });
}
Bins comparisons() {
  Bins bins = product(depth_functions(), named({"nearer", "equal", "farther"}));
  for (size_t i = 0; i < 3; ++i) {
    bins[static_cast<size_t>(DepthFunc::kOff) * 3 + i].unreachable = "depths are not compared";
  }
  return bins;
}

void see_lanes(const SeenFragment& s, Hits* hits) {
  const int lanes = s.contract.width.lanes;
  for (int lane = 0; lane < lanes; ++lane) {
    if ((s.stamp.mask >> lane & 1) != 0)
      hits->add((s.passed >> lane & 1) != 0 ? lane : lanes + lane);
  }
}

int greatest_distance(const Contract& c) {
  constexpr int kEach = 32;
  return std::min(c.width.inflight_stamps, kEach);
}
void see_distance(const SeenFragment& s, Hits* hits) {
  if (s.since >= 1 && s.since <= static_cast<size_t>(greatest_distance(s.contract)) &&
      core::tests_depth(s.contract, s.frame) && s.frame.depth_write) {
    hits->add(s.since - 1);
  }
}

void see_address(const SeenFragment& s, Hits* hits) {
  hits->add(length_of(s.stamp.x));
  hits->add(s.contract.width.stamp_x + 1 + length_of(s.stamp.y));
}

void see_written(const SeenFragment& s, Hits* hits) {
  const Contract& c = s.contract;
  const uint32_t far = static_cast<uint32_t>((uint64_t{1} << c.design.depth_bits) - 1);
  const int32_t full = (1 << c.design.attribute_bits) - 1;
  core::for_each_lane(c.design, s.passed, [&](size_t lane, int, int) {
    if (c.design.depth_test && s.fragment.z[lane] == 0) hits->add(0);
    if (c.design.depth_test && s.fragment.z[lane] == far) hits->add(1);
    for (size_t a = 0; a < static_cast<size_t>(c.design.attributes); ++a) {
      if (s.fragment.attr[lane][a] == 0) hits->add(2);
      if (s.fragment.attr[lane][a] == full) hits->add(3);
    }
  });
}
Bins written(const Contract& c) {
  Bins bins = named({"depth 0", "depth greatest", "attribute 0", "attribute greatest"});
  if (!c.design.depth_test) bins[0].unreachable = bins[1].unreachable = "the design has no depth";
  if (c.design.attributes == 0) {
    bins[2].unreachable = bins[3].unreachable = "no attribute is interpolated";
  }
  return bins;
}

void see_cleared(const SeenFragment& s, Hits* hits) {
  const uint32_t code = spec::cleared_depth(s.contract.design, s.frame);
  hits->add(code == 0 ? 0 : code == spec::cleared_depth(s.contract.design, {}) ? 2 : 1);
}

void see_weights(const SeenFragment& s, Hits* hits) {
  for_each_place(s, s.passed, [&](size_t, int i, int j) {
    const auto product = core::weight_products(s.contract, s.stamp, i, j);
    const int64_t sum = product[0] + product[1] + product[2];
    for (size_t v = 0; v < 3; ++v) {
      if (product[v] == 0) hits->add(v);
      if (product[v] == sum) hits->add(3 + v);
    }
  });
}
// Rounding of an attribute, from weights that are rounded down and up.
void see_weighed(const SeenFragment& s, Hits* hits) {
  for_each_place(s, s.passed, [&](size_t, int i, int j) {
    const auto product = core::weight_products(s.contract, s.stamp, i, j);
    const core::Reciprocal r = core::reciprocal(s.contract, product[0] + product[1] + product[2]);
    const int shift = s.contract.design.reciprocal_bits + r.length - 1 - spec::kWeightFractionBits;
    const int64_t one = int64_t{1} << spec::kWeightFractionBits;
    const auto& attr = s.stamp.planes.perspective.attr;
    for (size_t n = 0; n < static_cast<size_t>(s.contract.design.attributes); ++n) {
      int64_t sum = attr[0][n] * one, down = sum;
      for (const size_t v : {size_t{1}, size_t{2}}) {
        const spec::int128_t exact = spec::int128_t{product[v]} * r.mantissa;
        const int64_t step = attr[v][n] - attr[0][n];
        sum += std::min(static_cast<int64_t>(spec::round_half_up(exact, shift)), one) * step;
        down += static_cast<int64_t>(shift > 0 ? exact >> shift : exact << -shift) * step;
      }
      const auto code = [](int64_t value) {
        return spec::round_half_up(value, spec::kWeightFractionBits);
      };
      hits->add(rounding_bin(sum, spec::kWeightFractionBits));
      if (code(down) != code(sum)) hits->add(4);
    }
  });
}
void see_weight_entry(const SeenFragment& s, Hits* hits) {
  for_each_place(s, s.passed, [&](size_t, int i, int j) {
    const auto product = core::weight_products(s.contract, s.stamp, i, j);
    hits->add(reciprocal_entry(s.contract, product[0] + product[1] + product[2]));
  });
}

void see_state(const SeenFragment& s, Hits* hits) {
  hits->add((static_cast<int>(s.frame.cull) * 9 + static_cast<int>(s.frame.depth)) * 2 +
            (s.frame.depth_write ? 1 : 0));
}

void see_hits(const SeenFrame& s, Hits* hits) {
  for (const Sample& sample : s.frame_case.samples) {
    if (sample.hits > 0) hits->add(std::min<int>(sample.hits, 3) - 1);
  }
}

constexpr Point<SeenFragment> kFragmentPoints[] = {
    {"depth_function", "depth function and write, by the samples of a stamp that pass",
     [](const Contract& c) { return where(has_depth(c), functions(c)); }, see_function},
    {"comparison", "depth function, by how a new depth compares with the stored one",
     [](const Contract& c) { return where(has_depth(c), comparisons()); }, see_comparison},
    {"state", "cull state, depth function and write of stamps",
     [](const Contract& c) {
       return where(has_depth(c), product(product(named({"cull none", "cull back", "cull front"}),
                                                  depth_functions()),
                                          named({"not written", "written"})));
     },
     see_state},
    {"depth_code", "rounding and clamping of a depth",
     [](const Contract& c) { return where(has_depth(c), roundings(depth_fraction(c)) + ranges()); },
     see_depth_code},
    {"attribute_rounding", "rounding of an attribute",
     [](const Contract& c) { return where(is_affine(c), roundings(c.design.tile_fraction_bits)); },
     see_attribute_rounding},
    {"lane", "each lane passes, each fails",
     [](const Contract& c) {
       return where(has_depth(c), numbered(0, c.width.lanes - 1, "is a lane that passes") +
                                      numbered(0, c.width.lanes - 1, "is a lane that fails"));
     },
     see_lanes},
    {"hazard", "stamps from one to the next of the same address, while depth is written",
     [](const Contract& c) {
       return where(has_depth(c), numbered(1, greatest_distance(c), "stamps"));
     },
     see_distance},
    {"address", "length in bits of a stamp's column and row",
     [](const Contract& c) {
       return product(named({"column"}), numbered(0, c.width.stamp_x, "bits")) +
              product(named({"row"}), numbered(0, c.width.stamp_y, "bits"));
     },
     see_address},
    {"written", "values at the ends of their formats", written, see_written},
    {"cleared", "what depth is cleared to",
     [](const Contract& c) {
       return where(has_depth(c), named({"0", "between", "the greatest code"}));
     },
     see_cleared},
    {"stamp_bias", "depth bias of a stamp",
     [](const Contract& c) { return where(has_depth(c), signs()); },
     [](const SeenFragment& s, Hits* hits) { hits->add(sign_bin(s.stamp.planes.z_bias)); }},
    {"weight", "perspective: weights that are nothing or all",
     [](const Contract& c) {
       return where(has_weights(c),
                    product(named({"nothing", "all"}), numbered(0, 2, "is the vertex")));
     },
     see_weights},
    {"weighed", "perspective: rounding of an attribute",
     [](const Contract& c) {
       return where(has_weights(c),
                    roundings(spec::kWeightFractionBits) + named({"other if weights are cut off"}));
     },
     see_weighed},
    {"weight_entry", "perspective: entry of the reciprocal's table",
     [](const Contract& c) { return where(has_weights(c), reciprocal_entries(c)); },
     see_weight_entry},
};

}  // namespace

template <>
const std::vector<Point<SeenFragment>>& points<SeenFragment>() {
  static const std::vector<Point<SeenFragment>> kPoints(std::begin(kFragmentPoints),
                                                        std::end(kFragmentPoints));
  return kPoints;
}

template <>
const std::vector<Point<SeenGivenStamp>>& points<SeenGivenStamp>() {
  static const std::vector<Point<SeenGivenStamp>> kPoints{
      {"attribute_range", "clamping of an attribute",
       [](const Contract& c) { return where(is_affine(c), ranges()); }, see_attribute_range},
  };
  return kPoints;
}

template <>
const std::vector<Point<SeenCase>>& points<SeenCase>() {
  static const std::vector<Point<SeenCase>> kPoints{
      {"ports", "which ports stall",
       [](const Contract&) {
         Bins bins;
         for (const auto& row : memory::kStallModeNames) bins.push_back({row.word, ""});
         return bins;
       },
       [](const SeenCase& s, Hits* hits) { hits->add(static_cast<size_t>(s.ports.mode)); }},
  };
  return kPoints;
}

template <>
const std::vector<Point<SeenFrame>>& points<SeenFrame>() {
  static const std::vector<Point<SeenFrame>> kPoints{
      {"hits", "triangles that cover a sample",
       [](const Contract&) {
         return named({"one", "two", "three or more"});
       },
       see_hits},
      {"reset", "whether the frame is begun before, and reset on the way",
       [](const Contract&) {
         return named({"not reset", "reset"});
       },
       [](const SeenFrame& s, Hits* hits) { hits->add(s.frame_case.reset_cycle ? 1 : 0); }},
  };
  return kPoints;
}

}  // namespace pineda::vectors
