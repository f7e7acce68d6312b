// The coverage of setup.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "model/core/planes.h"
#include "model/spec/reciprocal/schemes.h"
#include "vectors/coverage/lone_bits.h"
#include "vectors/coverage/points.h"
#include "vectors/coverage/reciprocal_entry.h"

namespace pineda::vectors {

using spec::Contract;

SeenTriangle::SeenTriangle(const Contract& c, const spec::FrameState& f, const spec::Triangle& t)
    : contract(c), frame(f), triangle(t), drop(core::setup(c, f, t, &prim)) {
  const auto& v = t.v;
  area2 = (int64_t{v[1].x} - v[0].x) * (int64_t{v[2].y} - v[0].y) -
          (int64_t{v[2].x} - v[0].x) * (int64_t{v[1].y} - v[0].y);
  const auto is_before = [&](size_t a, size_t b) {
    return v[a].y < v[b].y || (v[a].y == v[b].y && v[a].x < v[b].x);
  };
  size_t first = 0;
  for (size_t i = 1; i < 3; ++i) first = is_before(i, first) ? i : first;
  const size_t second = (first + (area2 > 0 ? 1 : 2)) % 3;
  order = {first, second, 3 - first - second};
  std::tie(x_low, x_high) = std::minmax({v[0].x, v[1].x, v[2].x});
  std::tie(y_low, y_high) = std::minmax({v[0].y, v[1].y, v[2].y});
}

int64_t SeenTriangle::edge(size_t i, int64_t x, int64_t y) const {
  const spec::Vertex &from = vertex(i), &to = vertex(i + 1);
  return (int64_t{to.x} - from.x) * (y - from.y) - (int64_t{to.y} - from.y) * (x - from.x);
}

namespace {

int span(const Contract& c) { return c.width.coord; }
bool has_planes(const Contract& c) {
  return spec::plane_count(c.design) > 0 &&
         c.design.reciprocal_scheme != spec::ReciprocalScheme::kNone;
}
bool has_depth_plane(const Contract& c) { return has_planes(c) && c.design.depth_test; }
bool has_attribute_planes(const Contract& c) {
  return has_planes(c) && !c.design.perspective && c.design.attributes > 0;
}

// Directions of edges, clockwise from east; y points down.
constexpr const char* kDirections[] = {"east", "southeast", "south", "southwest",
                                       "west", "northwest", "north", "northeast"};
int direction(int64_t dx, int64_t dy) {
  static constexpr int kByS[3][3] = {{5, 6, 7}, {4, -1, 0}, {3, 2, 1}};
  return kByS[sign_bin(dy)][sign_bin(dx)];
}
int edge_bin(const SeenTriangle& s, size_t i) {
  const spec::Vertex &from = s.vertex(i), &to = s.vertex(i + 1);
  return static_cast<int>(i) * 8 + direction(int64_t{to.x} - from.x, int64_t{to.y} - from.y);
}
Bins edges() {
  Bins bins = product(numbered(0, 2, "edge"), named({"east", "southeast", "south", "southwest",
                                                     "west", "northwest", "north", "northeast"}));
  const auto exclude = [&](size_t edge, std::initializer_list<const char*> directions,
                           const char* why) {
    for (size_t i = 0; i < 8; ++i) {
      const std::string name = kDirections[i];
      if (std::find(directions.begin(), directions.end(), name) != directions.end()) {
        bins[edge * 8 + i].unreachable = why;
      }
    }
  };
  exclude(0, {"north", "northeast", "northwest", "west"},
          "edge 0 leaves the topmost vertex, of two the left one");
  exclude(1, {"east"}, "edge 1 cannot be the top, and the bottom runs west");
  exclude(2, {"south", "southeast", "southwest", "east", "west"},
          "edge 2 comes to the topmost vertex, and a level top is edge 0");
  return bins;
}

Bins samples_on_edges(const Contract&) {
  Bins bins = edges();
  for (Bin& bin : bins) {
    for (const char* border : {"0 edge, south", "1 edge, south", "1 edge, west"}) {
      if (bin.name == border) bin.unreachable = "the box leaves out its right and bottom border";
    }
  }
  return bins;
}

// In subpixels, of the pixel with that column or row.
int64_t center(const Contract& c, int pixel) {
  return (int64_t{2} * pixel + 1) << (c.design.subpixel_bits - 1);
}

void see_ties(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int64_t low = (int64_t{1} << s.contract.design.subpixel_bits) - 1;
  for (size_t i = 0; i < 3; ++i) {
    const int64_t e = s.edge(i, center(s.contract, s.prim.x0), center(s.contract, s.prim.y0));
    if ((e & low) == 0) hits->add(edge_bin(s, i));
  }
}

// Calls visit(x, y), in subpixels, for the samples of a box that is not large.
template <class Visitor>
void for_each_sample(const SeenTriangle& s, Visitor&& visit) {
  constexpr int kMost = 64;  // px
  if (!s.kept() || s.prim.x1 - s.prim.x0 >= kMost || s.prim.y1 - s.prim.y0 >= kMost) return;
  for (int y = s.prim.y0; y <= s.prim.y1; ++y) {
    for (int x = s.prim.x0; x <= s.prim.x1; ++x)
      visit(center(s.contract, x), center(s.contract, y));
  }
}

void see_samples_on_edges(const SeenTriangle& s, Hits* hits) {
  for_each_sample(s, [&](int64_t x, int64_t y) {
    const std::array<int64_t, 3> e{s.edge(0, x, y), s.edge(1, x, y), s.edge(2, x, y)};
    if (e[0] < 0 || e[1] < 0 || e[2] < 0) return;
    for (size_t i = 0; i < 3; ++i) {
      if (e[i] == 0 && e[(i + 1) % 3] != 0 && e[(i + 2) % 3] != 0) hits->add(edge_bin(s, i));
    }
  });
}

void see_samples_on_vertices(const SeenTriangle& s, Hits* hits) {
  for_each_sample(s, [&](int64_t x, int64_t y) {
    for (size_t i = 0; i < 3; ++i) {
      if (s.vertex(i).x == x && s.vertex(i).y == y) hits->add(i);
    }
  });
}

enum Side { kLeft, kRight, kTop, kBottom };
Bins sides() { return named({"left", "right", "top", "bottom"}); }

// By what each side of the box is: the triangle, the frame or the scissor.
int cut_by(const SeenTriangle& s, Side side) {
  const Contract& c = s.contract;
  const spec::FrameState& f = s.frame;
  const int bits = c.design.subpixel_bits;
  const int half = 1 << (bits - 1);
  const auto cut = [](bool by_frame, bool by_scissor) { return by_scissor ? 2 : by_frame ? 1 : 0; };
  switch (side) {
    case kLeft: {
      const int own = (s.x_low + half - 1) >> bits;
      return cut(own < 0, own < f.scissor_x0 && f.scissor_x0 > 0);
    }
    case kTop: {
      const int own = (s.y_low + half - 1) >> bits;
      return cut(own < 0, own < f.scissor_y0 && f.scissor_y0 > 0);
    }
    case kRight: {
      const int own = (s.x_high - half - 1) >> bits;
      return cut(own >= f.width, own >= f.scissor_x1 && f.scissor_x1 < f.width);
    }
    case kBottom:
      break;
  }
  const int own = (s.y_high - half - 1) >> bits;
  return cut(own >= f.height, own >= f.scissor_y1 && f.scissor_y1 < f.height);
}

void see_box_sides(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  for (const Side side : {kLeft, kRight, kTop, kBottom}) hits->add(side * 3 + cut_by(s, side));
}

void see_box_in_tiles(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int last = (1 << s.contract.design.tile_log2) - 1;
  const std::array<int, 4> sides{s.prim.x0, s.prim.x1, s.prim.y0, s.prim.y1};
  for (size_t i = 0; i < 4; ++i) {
    const int place = sides[i] & last;
    hits->add(i * 3 + (place == 0 ? 0 : place == last ? 1 : 2));
  }
}
Bins box_in_tiles(const Contract& c) {
  Bins places = named({"first of its tile", "last", "between"});
  if (c.design.tile_log2 < 2) places[2].unreachable = "a tile has no more";
  return product(sides(), places);
}

void see_corners_on_centers(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int64_t one = int64_t{1} << s.contract.design.subpixel_bits;
  const std::array<int, 4> sides{s.x_low, s.x_high, s.y_low, s.y_high};
  for (size_t i = 0; i < 4; ++i) {
    if ((sides[i] & (one - 1)) == one / 2) hits->add(i);
  }
}

// Lengths in bits of what cuts the box, from `first` on.
void see_frame_size(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int lengths = s.contract.design.guard_bits + 1;
  if (cut_by(s, kRight) == 1) hits->add(length_of(s.frame.width) - 1);
  if (cut_by(s, kBottom) == 1) hits->add(lengths + length_of(s.frame.height) - 1);
}
Bins frame_sizes(const Contract& c) {
  Bins lengths = numbered(1, c.design.guard_bits + 1, "bits");
  lengths.back().unreachable = "nothing reaches beyond the greatest frame";
  return product(named({"width", "height"}), lengths);
}

void see_scissor(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const std::array<int, 4> values{s.frame.scissor_x0, s.frame.scissor_x1, s.frame.scissor_y0,
                                  s.frame.scissor_y1};
  for (const Side side : {kLeft, kRight, kTop, kBottom}) {
    if (cut_by(s, side) != 2) continue;
    hits->add(side * s.contract.design.guard_bits + length_of(values[static_cast<size_t>(side)]) -
              1);
  }
}
Bins scissors(const Contract& c) {
  return product(sides(), numbered(1, c.design.guard_bits, "bits"));
}

void see_gradients(const spec::Plane& plane, Hits* hits) {
  hits->add(sign_bin(plane.dx) * 3 + sign_bin(plane.dy));
}

// The plane's gradients and reference before they wrap, as far as a double tells; dx, dy and ref.
std::array<bool, 3> wraps(const SeenTriangle& s, const std::array<int64_t, 3>& value,
                          int fraction_bits, int bits) {
  const auto d = [](int64_t v) { return static_cast<double>(v); };
  const spec::Vertex &a = s.vertex(0), &b = s.vertex(1), &c = s.vertex(2);
  const double d1 = d(value[1] - value[0]), d2 = d(value[2] - value[0]);
  const double area = d(s.area2 < 0 ? -s.area2 : s.area2);
  const spec::Design& design = s.contract.design;
  const double scale = std::ldexp(1., design.gradient_fraction_bits - fraction_bits);
  const double per_px = std::ldexp(scale, design.subpixel_bits) / area;
  const double dx = (d1 * d(c.y - a.y) - d2 * d(b.y - a.y)) * per_px;
  const double dy = (d2 * d(b.x - a.x) - d1 * d(c.x - a.x)) * per_px;
  const auto from = [&](int pixel, int vertex) {
    const int first = pixel >> design.tile_log2 << design.tile_log2;
    return std::ldexp(d(center(s.contract, first) - vertex), -design.subpixel_bits);
  };
  const double ref = d(value[0]) * scale + dx * from(s.prim.x0, a.x) + dy * from(s.prim.y0, a.y);
  const double limit = std::ldexp(1., bits - 1) * (1 + 0x1p-10);  // beyond any rounding
  return {std::fabs(dx) > limit, std::fabs(dy) > limit, std::fabs(ref) > limit};
}
void see_wraps(const std::array<bool, 3>& wraps, Hits* hits) {
  for (size_t i = 0; i < 3; ++i) {
    if (wraps[i]) hits->add(i);
  }
}

std::array<int64_t, 3> depths(const SeenTriangle& s) {
  return {s.vertex(0).z, s.vertex(1).z, s.vertex(2).z};
}

void see_depth_gradients(const SeenTriangle& s, Hits* hits) {
  if (s.kept()) see_gradients(s.prim.planes.z, hits);
}
void see_depth_wraps(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  see_wraps(wraps(s, depths(s), spec::kDepthInputFractionBits, s.contract.width.depth_plane), hits);
}
void see_attribute_gradients(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  for (size_t a = 0; a < static_cast<size_t>(s.contract.design.attributes); ++a) {
    see_gradients(s.prim.planes.attr[a], hits);
  }
}
void see_attribute_wraps(const SeenTriangle& s, Hits* hits) {
  if (!s.kept() || s.frame.shade == spec::Shade::kFlat) return;
  for (size_t a = 0; a < static_cast<size_t>(s.contract.design.attributes); ++a) {
    see_wraps(wraps(s, {s.vertex(0).attr[a], s.vertex(1).attr[a], s.vertex(2).attr[a]}, 0,
                    s.contract.width.attr_plane),
              hits);
  }
}

void see_bias(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int64_t bias = s.prim.planes.z_bias;
  const int64_t limit = int64_t{1} << (s.contract.width.depth_bias - 1);
  hits->add(bias == -limit ? 3 : bias == limit - 1 ? 4 : sign_bin(bias));
}
void see_bias_state(const SeenTriangle& s, Hits* hits) {
  if (s.kept()) hits->add(sign_bin(s.frame.bias_constant) * 3 + sign_bin(s.frame.bias_slope));
}

// The gradients' magnitudes that the slope factor is multiplied by, that of dz/dx and the greater one.
struct Magnitudes {
  int64_t x, greatest;
};
Magnitudes magnitudes(const SeenTriangle& s) {
  const spec::Vertex& anchor = s.vertex(0);
  const auto offset = [&](size_t i, auto member) {
    return int64_t{s.vertex(i).*member} - anchor.*member;
  };
  const int64_t area2 = s.area2 < 0 ? -s.area2 : s.area2;
  core::PlaneSetup planes{core::reciprocal(s.contract, area2),
                          {offset(1, &spec::Vertex::x), offset(2, &spec::Vertex::x)},
                          {offset(1, &spec::Vertex::y), offset(2, &spec::Vertex::y)},
                          0,
                          0};
  const int64_t greatest = core::depth_magnitude(s.contract, planes, depths(s));
  planes.dx = {0, 0};  // leaves dz/dx
  return {core::depth_magnitude(s.contract, planes, depths(s)), greatest};
}

void see_bias_magnitude(const SeenTriangle& s, Hits* hits) {
  if (!s.kept() || s.frame.bias_slope == 0) return;
  const Magnitudes of = magnitudes(s);
  const int64_t limit = int64_t{1} << (s.contract.width.bias_magnitude - 1);
  if (of.greatest >= limit - 1) {
    hits->add(2);
    const int64_t most = (int64_t{1} << (s.contract.width.depth_bias - 1)) - 1;
    const int64_t bias = core::depth_bias(s.contract, s.frame, of.greatest);
    if (-most <= bias && bias < most) hits->add(of.greatest < limit ? 4 : 5);
    return;
  }
  hits->add(of.x == of.greatest ? 0 : 1);
  // From gradients that are rounded already.
  const int shift = s.contract.design.gradient_fraction_bits - spec::kBiasFactorFractionBits;
  const auto wrapped =
      wraps(s, depths(s), spec::kDepthInputFractionBits, s.contract.width.depth_plane);
  if (shift <= 0 || wrapped[0] || wrapped[1]) return;
  const spec::Plane& z = s.prim.planes.z;
  const auto again = [&](int64_t g) {
    return std::abs(static_cast<int64_t>(spec::round_half_up(g, shift)));
  };
  if (std::max(again(z.dx), again(z.dy)) != of.greatest) hits->add(3);
}
Bins bias_magnitudes(const Contract& c) {
  Bins bins =
      named({"dz/dx", "dz/dy", "saturated", "other if rounded twice",
             "saturated by a rise, the bias is not", "saturated by a fall, the bias is not"});
  if (c.design.gradient_fraction_bits <= spec::kBiasFactorFractionBits) {
    bins[3].unreachable = "gradients have no more fraction bits";
  }
  return bins;
}

void see_entry(const SeenTriangle& s, Hits* hits) {
  if (s.kept()) hits->add(reciprocal_entry(s.contract, s.area2 < 0 ? -s.area2 : s.area2));
}
void see_power_of_two(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  const int64_t area2 = s.area2 < 0 ? -s.area2 : s.area2;
  hits->add((area2 & (area2 - 1)) == 0 ? 0 : 1);
}

void see_extremes(const SeenTriangle& s, Hits* hits) {
  const Contract& c = s.contract;
  const int32_t greatest = static_cast<int32_t>((int64_t{1} << (c.width.coord - 1)) - 1);
  const int64_t far = ((int64_t{1} << c.design.depth_bits) - 1) << spec::kDepthInputFractionBits;
  const int32_t full = (1 << c.design.attribute_bits) - 1;
  for (const spec::Vertex& v : s.triangle.v) {
    if (v.x == -greatest - 1) hits->add(0);
    if (v.x == greatest) hits->add(1);
    if (v.y == -greatest - 1) hits->add(2);
    if (v.y == greatest) hits->add(3);
    if (c.design.depth_test && v.z == 0) hits->add(4);
    if (c.design.depth_test && v.z == far) hits->add(5);
    for (size_t a = 0; a < static_cast<size_t>(spec::channels(c.design)); ++a) {
      if (v.attr[a] == 0) hits->add(6);
      if (v.attr[a] == full) hits->add(7);
    }
  }
}
Bins extremes(const Contract& c) {
  Bins bins = named({"x least", "x greatest", "y least", "y greatest", "depth 0", "depth greatest",
                     "attribute 0", "attribute greatest"});
  if (!c.design.depth_test) bins[4].unreachable = bins[5].unreachable = "the design has no depth";
  if (spec::channels(c.design) == 0) {
    bins[6].unreachable = bins[7].unreachable = "the design has no attributes";
  }
  return bins;
}

void see_inverse_w(const SeenTriangle& s, Hits* hits) {
  if (!s.kept()) return;
  for (size_t i = 0; i < 3; ++i) {
    hits->add(static_cast<int>(i) * (spec::kInverseWShiftBits + 1) +
              length_of(s.vertex(i).inverse_w_shift));
  }
}

constexpr Point<SeenTriangle> kTrianglePoints[] = {
    {"drop", "why setup drops a triangle",
     [](const Contract&) {
       Bins bins;
       for (const auto& row : core::kDropNames) bins.push_back({row.word, ""});
       return bins;
     },
     [](const SeenTriangle& s, Hits* hits) { hits->add(static_cast<size_t>(s.drop)); }},
    {"cull_facing", "cull state by facing",
     [](const Contract&) {
       return product(named({"cull none", "cull back", "cull front"}),
                      named({"clockwise", "counter-clockwise"}));
     },
     [](const SeenTriangle& s, Hits* hits) {
       if (s.area2 != 0) hits->add(static_cast<int>(s.frame.cull) * 2 + (s.area2 > 0 ? 0 : 1));
     }},
    {"order", "which vertex of the scene is the anchor, by facing",
     [](const Contract&) {
       return product(named({"clockwise", "counter-clockwise"}), numbered(0, 2, "is the anchor"));
     },
     [](const SeenTriangle& s, Hits* hits) {
       if (s.kept()) hits->add((s.area2 > 0 ? 0 : 3) + static_cast<int>(s.order[0]));
     }},
    {"anchor", "how the anchor is found",
     [](const Contract&) {
       return named({"one vertex is topmost", "two are, the left one"});
     },
     [](const SeenTriangle& s, Hits* hits) {
       if (s.kept()) hits->add(s.vertex(0).y == s.vertex(1).y ? 1 : 0);
     }},
    {"area", "length in bits of the doubled area",
     [](const Contract& c) { return numbered(1, 2 * span(c), "bits"); },
     [](const SeenTriangle& s, Hits* hits) {
       if (s.kept()) hits->add(length_of(s.area2 < 0 ? -s.area2 : s.area2) - 1);
     }},
    {"extent", "length in bits of width and height, in subpixels",
     [](const Contract& c) {
       return product(named({"width", "height"}), numbered(1, span(c), "bits"));
     },
     [](const SeenTriangle& s, Hits* hits) {
       if (!s.kept()) return;
       hits->add(length_of(int64_t{s.x_high} - s.x_low) - 1);
       hits->add(span(s.contract) + length_of(int64_t{s.y_high} - s.y_low) - 1);
     }},
    {"lone_bit", "two vertices that differ in one bit alone, which moves the box", lone_bits,
     see_lone_bits},
    {"power_of_two", "edges as long as one bit, where their direction hangs on it", powers_of_two,
     see_powers_of_two},
    {"far_sample", "sides of the box at a vertex on samples, by the bits of their column or row",
     far_samples, see_far_samples},
    {"edge_direction", "direction of each edge", [](const Contract&) { return edges(); },
     [](const SeenTriangle& s, Hits* hits) {
       for (size_t i = 0; s.kept() && i < 3; ++i) hits->add(edge_bin(s, i));
     }},
    {"tie",
     "direction of an edge whose E at samples is a whole number of pixel steps, so that the "
     "top-left bias changes E'",
     [](const Contract&) { return edges(); }, see_ties},
    {"sample_on_edge",
     "direction of an edge that a sample of the box lies on, inside the other two",
     samples_on_edges, see_samples_on_edges},
    {"sample_on_vertex", "canonical vertex that lies on a sample",
     [](const Contract&) {
       Bins bins = numbered(0, 2, "is on a sample");
       return bins;
     },
     see_samples_on_vertices},
    {"box_side", "what each side of the box is cut by",
     [](const Contract&) {
       return product(sides(), named({"by nothing", "by the frame", "by the scissor"}));
     },
     see_box_sides},
    {"box_in_tile", "where each side of the box lies in its tile", box_in_tiles, see_box_in_tiles},
    {"corner_on_center", "an extreme coordinate that is a sample's",
     [](const Contract&) { return sides(); }, see_corners_on_centers},
    {"frame_size", "length in bits of a frame's size that cuts a box", frame_sizes, see_frame_size},
    {"scissor", "length in bits of a scissor's side that cuts a box", scissors, see_scissor},
    {"reciprocal_entry", "entry of the reciprocal's table",
     [](const Contract& c) { return where(has_planes(c), reciprocal_entries(c)); }, see_entry},
    {"reciprocal_end", "reciprocals that saturate",
     [](const Contract& c) {
       return where(has_planes(c), named({"a power of two", "no power of two"}));
     },
     see_power_of_two},
    {"depth_gradient", "signs of dz/dx and dz/dy",
     [](const Contract& c) { return where(has_depth_plane(c), product(signs(), signs())); },
     see_depth_gradients},
    {"attribute_gradient", "signs of an attribute's gradients",
     [](const Contract& c) { return where(has_attribute_planes(c), product(signs(), signs())); },
     see_attribute_gradients},
    {"depth_wrap", "what of a depth plane wraps",
     [](const Contract& c) {
       return where(has_depth_plane(c), named({"dx", "dy", "ref"}));
     },
     see_depth_wraps},
    {"attribute_wrap", "what of an attribute's plane wraps",
     [](const Contract& c) {
       return where(has_attribute_planes(c), named({"dx", "dy", "ref"}));
     },
     see_attribute_wraps},
    {"bias", "depth bias of a triangle",
     [](const Contract& c) {
       return where(has_depth_plane(c), signs() + named({"saturated low", "saturated high"}));
     },
     see_bias},
    {"bias_state", "signs of the constant and of the slope factor",
     [](const Contract& c) {
       return where(has_depth_plane(c),
                    product(named({"constant negative", "constant zero", "constant positive"}),
                            named({"slope negative", "slope zero", "slope positive"})));
     },
     see_bias_state},
    {"bias_magnitude", "what the slope factor is multiplied by",
     [](const Contract& c) { return where(has_depth_plane(c), bias_magnitudes(c)); },
     see_bias_magnitude},
    {"steep", "hierarchical z: whether a plane may wrap in a tile",
     [](const Contract& c) {
       return where(c.design.hierarchical_z, named({"flat enough", "steep"}));
     },
     [](const SeenTriangle& s, Hits* hits) {
       if (s.kept()) hits->add(s.prim.planes.z_steep ? 1 : 0);
     }},
    {"shade", "where the attributes come from",
     [](const Contract& c) {
       return where(c.design.attributes > 0,
                    named({"smooth"}) + numbered(0, 2, "in canonical order gives flat ones"));
     },
     [](const SeenTriangle& s, Hits* hits) {
       if (!s.kept()) return;
       const auto place = std::find(s.order.begin(), s.order.end(), size_t{0}) - s.order.begin();
       hits->add(s.frame.shade == spec::Shade::kFlat ? 1 + place : 0);
     }},
    {"extreme", "vertices at the ends of their formats", extremes, see_extremes},
    {"inverse_w", "length in bits of each canonical vertex' exponent of 1/w",
     [](const Contract& c) {
       return where(c.design.perspective, product(numbered(0, 2, "vertex"),
                                                  numbered(0, spec::kInverseWShiftBits, "bits")));
     },
     see_inverse_w},
    {"id", "number of the triangle",
     [](const Contract&) {
       return named({"small", "with its top bit"});
     },
     [](const SeenTriangle& s, Hits* hits) { hits->add(s.triangle.id >> 31); }},
};

}  // namespace

template <>
const std::vector<Point<SeenTriangle>>& points<SeenTriangle>() {
  static const std::vector<Point<SeenTriangle>> kPoints(std::begin(kTrianglePoints),
                                                        std::end(kTrianglePoints));
  return kPoints;
}

}  // namespace pineda::vectors
