#include "studies/needs/shrink.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/spec/bounds.h"
#include "studies/needs/design_cost.h"

namespace pineda::studies {
namespace {

using spec::Design;
using spec::ReciprocalScheme;
using Designs = std::vector<Design>;

template <int Design::*Member>
std::string number(const Design& design) {
  const spec::Parameter& p = spec::parameter(Member);
  return p.used(design) ? spec::file_value(p, design) : "-";
}

template <int Design::*Member>
std::string number_of_planes(const Design& design) {
  return spec::plane_count(design) > 0 ? std::to_string(design.*Member) : "-";
}

template <int Design::*Member>
Designs less(const Design& design) {
  Designs all;
  for (Design d = design; d.*Member > 0;) {
    --(d.*Member);
    // The fraction inside a tile is no longer than that of the gradient.
    d.tile_fraction_bits = std::min(d.tile_fraction_bits, d.gradient_fraction_bits);
    all.push_back(d);
  }
  return all;
}

template <auto Member>
void copy_one(const Design& from, Design* to) {
  to->*Member = from.*Member;
}

/// A numeric parameter, which shrinks by one at a time.
template <int Design::*Member>
ShrinkableParameter shrinkable_number(std::string (*text)(const Design&) = number<Member>) {
  return {spec::parameter(Member).key, text, less<Member>, copy_one<Member>};
}

// Limits the planes' fraction bits to what the reciprocal's bits allow.
void fit_fractions(Design* d) {
  d->gradient_fraction_bits =
      std::min(d->gradient_fraction_bits, d->reciprocal_bits - d->subpixel_bits);
  d->tile_fraction_bits = std::min(d->tile_fraction_bits, d->gradient_fraction_bits);
}

std::string reciprocal_text(const Design& d) {
  if (!spec::has_reciprocal(d)) return "-";
  const spec::Scheme& scheme = spec::scheme_of(d);
  std::string text = scheme.word;
  if (scheme.has_rom) text += fmt::format(" lut {}", d.reciprocal_lut_bits);
  if (scheme.has_newton_steps) text += fmt::format(" steps {}", d.reciprocal_newton_steps);
  return text + fmt::format(" k {}", d.reciprocal_bits);
}

Designs cheaper_reciprocals(const Design& d) {
  const int64_t now = design_cost(d).total();
  Designs all;
  for (const Design& other : reciprocal_front(d)) {
    if (design_cost(other).total() < now) all.insert(all.begin(), other);
  }
  return all;
}

void copy_reciprocal(const Design& from, Design* to) {
  to->reciprocal_scheme = from.reciprocal_scheme;
  to->reciprocal_lut_bits = from.reciprocal_lut_bits;
  to->reciprocal_newton_steps = from.reciprocal_newton_steps;
  to->reciprocal_bits = from.reciprocal_bits;
}

// Makes the last interpolated attribute flat (the first vertex's value), then the one before it,
// and so on.
Designs more_flat(const Design& design) {
  Designs all;
  for (Design d = design; d.attributes > 0;) {
    --d.attributes;
    ++d.flat_attributes;
    d.perspective = d.perspective && d.attributes > 0;
    all.push_back(d);
  }
  return all;
}

template <bool Design::*Switch>
std::string switched(const Design& design) {
  return design.*Switch ? "true" : "false";
}

template <bool Design::*Switch>
Designs without(const Design& design) {
  if (!(design.*Switch)) return {};
  Design d = design;
  d.*Switch = false;
  d.hierarchical_z = d.hierarchical_z && d.depth_test;
  return {d};
}

/// Each design with each value of a parameter, from the least to the greatest; unchanged where it
/// does not use the parameter.
std::vector<Design> each_value(const std::vector<Design>& designs, int Design::*member) {
  const spec::Parameter& p = spec::parameter(member);
  const auto& number = std::get<spec::Number>(p.member);
  std::vector<Design> all;
  for (Design d : designs) {
    if (!p.used(d)) {
      all.push_back(d);
      continue;
    }
    for (d.*member = number.low(d); d.*member <= number.high(d); ++(d.*member)) all.push_back(d);
  }
  return all;
}

/// The design with every scheme and size of reciprocal.
std::vector<Design> all_reciprocals(const Design& design) {
  std::vector<Design> all;
  for (const spec::Scheme& scheme : spec::kReciprocalSchemes) {
    if (scheme.value == ReciprocalScheme::kNone) continue;
    Design d = design;
    d.reciprocal_scheme = scheme.value;
    all.push_back(d);
  }
  all = each_value(all, &Design::reciprocal_lut_bits);
  all = each_value(all, &Design::reciprocal_newton_steps);
  all = each_value(all, &Design::reciprocal_bits);
  for (Design& d : all) fit_fractions(&d);
  return all;
}

}  // namespace

std::vector<Design> reciprocal_front(const Design& design) {
  struct Point {
    Design design;
    int64_t cost;
    double error;
  };
  std::vector<Point> points;
  const int interval = spec::widths(design).setup_interval_cycles;
  for (const Design& d : all_reciprocals(design)) {
    if (!spec::invalid_reason(d).empty()) continue;
    if (spec::widths(d).setup_interval_cycles > interval) continue;
    points.push_back({d, design_cost(d).total(), spec::reciprocal_error_bound(d)});
  }
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
  });
  std::vector<Design> front;
  double error = 1;
  for (const Point& p : points) {
    if (p.error >= error) continue;
    error = p.error;
    front.push_back(p.design);
  }
  return front;
}

const std::vector<ShrinkableParameter>& shrinkable_parameters() {
  static const std::vector<ShrinkableParameter> all{
      shrinkable_number<&Design::guard_bits>(),
      {"depth_test", switched<&Design::depth_test>, without<&Design::depth_test>,
       copy_one<&Design::depth_test>},
      {"attributes",
       [](const Design& d) { return fmt::format("{} + {} flat", d.attributes, d.flat_attributes); },
       more_flat,
       [](const Design& from, Design* to) {
         to->attributes = from.attributes;
         to->flat_attributes = from.flat_attributes;
       }},
      {"perspective", switched<&Design::perspective>, without<&Design::perspective>,
       copy_one<&Design::perspective>},
      shrinkable_number<&Design::depth_bits>(),
      shrinkable_number<&Design::inverse_w_bits>(),
      {"reciprocal", reciprocal_text, cheaper_reciprocals, copy_reciprocal},
      shrinkable_number<&Design::tile_fraction_bits>(number_of_planes<&Design::tile_fraction_bits>),
      shrinkable_number<&Design::gradient_fraction_bits>(
          number_of_planes<&Design::gradient_fraction_bits>),
  };
  return all;
}

const ShrinkableParameter& shrinkable_parameter(const std::string& name) {
  const auto& all = shrinkable_parameters();
  return *std::find_if(all.begin(), all.end(), [&](const auto& p) { return name == p.name; });
}

}  // namespace pineda::studies
