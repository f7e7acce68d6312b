// The table of parameters: it holds all of Design; ranges and their errors; unused parameters; the
// table of docs/designs.md.
#include "model/spec/parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "model/spec/bounds.h"
#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "tests/spec/schemes.h"

namespace pineda::spec {
namespace {

/// A design that has every part, so that each parameter is used.
constexpr Design whole() {
  Design d;
  d.perspective = d.hierarchical_z = true;
  return d;
}

/// Every number that a design does not use is `value`.
constexpr Design unused_are(Design d, int value) {
  for (const Parameter& p : kParameters) {
    if (!std::holds_alternative<Number>(p.member) || p.used(d)) continue;
    d.*std::get<Number>(p.member).member = value;
  }
  return d;
}

constexpr Design of_scheme(ReciprocalScheme scheme) {
  Design d;
  d.reciprocal_scheme = scheme;
  return d;
}

/// Flat colour only: no depth, no planes, no reciprocal.
constexpr Design bare() {
  Design d;
  d.depth_test = false;
  d.attributes = 0;
  d.flat_attributes = 4;
  return d;
}

// Evaluated at compile time: the compiler refuses a constant with undefined behaviour, such as an
// overflow or a shift by too much.
constexpr int kAnything[] = {INT_MIN, -1, 0, 1000000, INT_MAX};
constexpr bool widths_are_defined(const Design& design) {
  for (const int value : kAnything) {
    const Contract c = contract(unused_are(design, value));
    if (c.width.coord != 23 || c.width.edge_coeff != 24 || c.width.lanes != 4) return false;
  }
  return true;
}
static_assert(widths_are_defined(bare()));
static_assert(widths_are_defined(whole()));
static_assert(widths_are_defined(of_scheme(ReciprocalScheme::kNewton)));
static_assert(widths_are_defined(of_scheme(ReciprocalScheme::kQuadratic)));
static_assert(widths_are_defined(of_scheme(ReciprocalScheme::kRestoring2)));
static_assert(widths_are_defined(of_scheme(ReciprocalScheme::kRestoring4)));
static_assert(widths_are_defined(of_scheme(ReciprocalScheme::kNone)));

/// Stands for a value of any type.
struct Any {
  template <class T>
  operator T() const;
};
template <size_t>
using AnyOf = Any;

/// Can a Design be initialised with this many values? Only if it has that many members.
template <size_t... I, class = decltype(Design{AnyOf<I>()...})>
constexpr bool has_members(std::index_sequence<I...>) {
  return true;
}
constexpr bool has_members(...) { return false; }

TEST(Parameters, EveryKeyAndMemberStandsOnce) {
  std::set<std::string> keys;
  for (const Parameter& p : kParameters) {
    EXPECT_TRUE(keys.insert(p.key).second) << p.key;
    EXPECT_EQ(&parameter(p.key), &p);
    EXPECT_STRNE(p.meaning, "") << p.key;
    if (const auto* number = std::get_if<Number>(&p.member)) {
      EXPECT_EQ(&parameter(number->member), &p) << p.key;
    }
  }
  // Besides the parameters a design has a name and a summary, and nothing else.
  EXPECT_TRUE(has_members(std::make_index_sequence<std::size(kParameters) + 2>()));
  EXPECT_FALSE(has_members(std::make_index_sequence<std::size(kParameters) + 3>()));
  EXPECT_THROW(parameter("fog"), std::out_of_range);
  EXPECT_THROW(parameter(nullptr), std::out_of_range);
}

// The ends of a range are allowed; a value beyond them is refused under its key, in the key's unit.
TEST(Parameters, BeyondEachEndOfEachRangeIsRefusedByTheKeysOwnValue) {
  size_t numbers = 0;
  for (const Parameter& p : kParameters) {
    const auto* number = std::get_if<Number>(&p.member);
    if (number == nullptr) continue;
    ++numbers;
    const int low = number->low(whole());
    const int high = number->high(whole());
    const auto written = [&](int value) {
      char text[32];
      std::snprintf(text, sizeof text, "%.15g", number->is_log2 ? std::exp2(value) : value);
      return std::string(text);
    };
    for (const int value : {low - 1, low, high, high + 1}) {
      Design d = whole();
      d.*number->member = value;
      const std::string reason = range_reason(d);
      const bool inside = value >= low && value <= high;
      const std::string refusal = std::string(p.key) + " is " + written(value) + ", must be " +
                                  written(low) + " to " + written(high);
      const bool says_so = reason == refusal;
      EXPECT_EQ(says_so, !inside) << reason << ", wanted: " << refusal;
    }
  }
  EXPECT_GT(numbers, 20u);
}

// With two errors the first in the table is reported, those of earlier rounds before others, whatever
// the order in the file.
TEST(Parameters, RangesAreLookedAtInAFixedOrder) {
  Design d = whole();
  for (const Parameter& p : kParameters) {
    if (const auto* number = std::get_if<Number>(&p.member)) d.*number->member = -1;
  }
  std::vector<Parameter> order;
  for (const Parameter& p : kParameters) {
    if (std::holds_alternative<Number>(p.member)) order.push_back(p);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Parameter& a, const Parameter& b) { return a.round < b.round; });
  EXPECT_GT(order.size(), 20u);
  for (const Parameter& p : order) {
    const std::string reason = range_reason(d);
    EXPECT_EQ(reason.rfind(std::string(p.key) + " is ", 0), 0u) << p.key << ": " << reason;
    const auto& number = std::get<Number>(p.member);
    d.*number.member = kHighTile.*number.member;
  }
  EXPECT_EQ(range_reason(d), "");
}

// As in a file: the words of enumerations in quotes, what is a logarithm in px.
TEST(Parameters, ValuesAreThoseOfAFile) {
  Design d = whole();
  d.tile_log2 = 5;
  EXPECT_EQ(file_value(parameter("tile_px"), d), "32");
  EXPECT_EQ(std::get<int>(value_of(parameter("tile_px"), d)), 32);
  EXPECT_EQ(file_value(parameter("setup_style"), d), "'stepped'");
  EXPECT_EQ(std::get<std::string>(value_of(parameter("setup_style"), d)), "stepped");
  EXPECT_EQ(file_value(parameter("perspective"), d), "true");
  EXPECT_TRUE(std::get<bool>(value_of(parameter("perspective"), d)));
}

TEST(Parameters, DifferencesAreInTheOrderOfAFile) {
  Design d;
  d.max_depth_latency_cycles = 32;
  d.tile_log2 = 4;
  d.setup_style = SetupStyle::kSerial;
  std::string text;
  for (const Setting& s : differences(d, kHighTile)) text += std::string(s.key) + s.value + " ";
  EXPECT_EQ(text, "setup_style'serial' tile_px16 max_depth_latency_cycles32 ");
  EXPECT_TRUE(differences(d, d).empty());
}

/// Unused parameters with any value change nothing and overflow nowhere.
TEST(UnusedParameters, MayHoldAnything) {
  Design all[] = {bare(),
                  of_scheme(ReciprocalScheme::kNone),
                  *find_design("exact"),
                  *find_design("flat"),
                  *find_design("div28"),
                  of_scheme(ReciprocalScheme::kRestoring4),
                  kHighTile};
  for (const Design& design : all) {
    const std::string reason = invalid_reason(design);
    for (const int value : kAnything) {
      const Design d = unused_are(design, value);
      EXPECT_EQ(invalid_reason(d), reason) << design.name << " " << value;
      if (no_rtl_reason(design).empty()) {
        EXPECT_TRUE(package_text(contract(d)) == package_text(contract(design))) << design.name;
      }
      EXPECT_EQ(error_bounds(d).depth_ulp, error_bounds(design).depth_ulp);
      EXPECT_EQ(error_bounds(d).attribute_lsb, error_bounds(design).attribute_lsb);
      EXPECT_FALSE(design_toml(d).empty());
    }
  }
}

TEST(UnusedParameters, OfAFileMayHoldAnything) {
  const Design d = parse_design(
      "reciprocal_scheme = \"none\"\nreciprocal_lut_bits = 1000000\nreciprocal_bits = 1000000\n"
      "reciprocal_newton_steps = -1\ninverse_w_bits = 1000000\ngradient_fraction_bits = 1000000\n"
      "tile_fraction_bits = -1\nhierarchical_z_tiles = -1\n",
      "d.toml");
  EXPECT_EQ(d.reciprocal_lut_bits, 1000000);
  EXPECT_EQ(contract(d).design.reciprocal_lut_bits, 12);
  EXPECT_EQ(contract(d).design.reciprocal_newton_steps, 0);
  EXPECT_EQ(contract(d).design.tile_fraction_bits, 0);
  EXPECT_THROW(parse_design("reciprocal_lut_bits = 1000000\n", "d.toml"), DesignFileError);
}

// Replacing unused values changes no named design, so no package or hash of one.
TEST(UnusedParameters, OfNamedDesignsStayAsTheyAre) {
  for (const Design& d : designs()) EXPECT_EQ(design_toml(tamed(d)), design_toml(d));
  for (const Design& d : kSchemes) EXPECT_EQ(design_toml(tamed(d)), design_toml(d));
  for (const Design& d : kSetups) EXPECT_EQ(design_toml(tamed(d)), design_toml(d));
}

/// The table of docs/designs.md.
std::string documentation() {
  std::string text = "| parameter | values | unit | what it is |\n|---|---|---|---|\n";
  for (const Parameter& p : kParameters) {
    text += "| `" + std::string(p.key) + "` | " + range_text(p) + " | " + p.unit + " | " +
            p.meaning + " |\n";
  }
  return text;
}

TEST(Parameters, DocumentationHasTheTable) {
  std::ifstream file(PINEDA_SOURCE_DIR "/docs/designs.md", std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_NE(page.find("\n" + documentation() + "\n"), std::string::npos)
      << "docs/designs.md should hold:\n\n"
      << documentation();
  EXPECT_EQ(page.find("\n" + documentation() + "| "), std::string::npos);
}

}  // namespace
}  // namespace pineda::spec
