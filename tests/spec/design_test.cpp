// Designs: what can be built, what is refused and why; the widths that follow.
#include "model/spec/design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "model/spec/fields.h"
#include "model/spec/reciprocal/schemes.h"
#include "model/spec/widths.h"
#include "tests/spec/schemes.h"

namespace pineda::spec {
namespace {

TEST(Designs, EveryNamedOneCanBeBuiltAndIsFoundByItsName) {
  ASSERT_FALSE(designs().empty());
  for (const Design& design : designs()) {
    EXPECT_EQ(invalid_reason(design), "") << design.name;
    ASSERT_NE(find_design(design.name), nullptr);
    EXPECT_EQ(find_design(design.name)->name, design.name);
    EXPECT_NE(std::string(design.summary), "");
  }
  EXPECT_EQ(find_design("no such design"), nullptr);
  EXPECT_NE(find_design("high_tile"), nullptr);
}

struct Refusal {
  const char* what;  // must be named in the reason
  int Design::*parameter;
  int value;
};

TEST(InvalidReason, NamesTheParameterThatIsOutOfRange) {
  const Refusal refusals[] = {
      {"subpixel_bits", &Design::subpixel_bits, 3},
      {"subpixel_bits", &Design::subpixel_bits, 13},
      {"guard_bits", &Design::guard_bits, 15},
      {"depth_bits", &Design::depth_bits, 15},
      {"depth_bits", &Design::depth_bits, 33},
      {"attributes", &Design::attributes, -1},
      {"attributes", &Design::attributes, kMaxAttributes + 1},
      {"flat_attributes", &Design::flat_attributes, kMaxAttributes - 3},  // with four others
      {"attribute_bits", &Design::attribute_bits, 0},
      {"attribute_bits", &Design::attribute_bits, 17},
      {"reciprocal_lut_bits", &Design::reciprocal_lut_bits, 3},
      {"reciprocal_newton_steps", &Design::reciprocal_newton_steps, 3},
      {"reciprocal_newton_steps", &Design::reciprocal_newton_steps, -1},
      {"reciprocal_bits", &Design::reciprocal_bits, 11},
      {"reciprocal_bits", &Design::reciprocal_bits, 33},
      {"gradient_fraction_bits", &Design::gradient_fraction_bits, 21},
      {"tile_fraction_bits", &Design::tile_fraction_bits, 0},
      {"tile_fraction_bits", &Design::tile_fraction_bits, 19},  // more than the gradients'
      {"tile_px is 2, must be 4 to 64", &Design::tile_log2, 1},
      {"tile_px is 128, must be 4 to 64", &Design::tile_log2, 7},
      {"stamp_width_px is 8, must be 1 to 4", &Design::stamp_width_log2, 3},
      {"stamp_height_px is 0.5", &Design::stamp_height_log2, -1},
      {"depth_latency_cycles", &Design::depth_latency_cycles, 0},
      {"depth_latency_cycles", &Design::depth_latency_cycles, 65},
      {"max_depth_latency_cycles is 0", &Design::max_depth_latency_cycles, 0},
      {"max_depth_latency_cycles is 1025", &Design::max_depth_latency_cycles, 1025},
  };
  for (const Refusal& r : refusals) {
    Design design = kHighTile;
    design.*r.parameter = r.value;
    const std::string reason = invalid_reason(design);
    EXPECT_NE(reason.find(r.what), std::string::npos)
        << r.what << " = " << r.value << ": " << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos);
  }
}

TEST(InvalidReason, ReciprocalTooShortForTheGradientIsRefused) {
  Design design = kHighTile;
  design.reciprocal_bits = design.gradient_fraction_bits + design.subpixel_bits - 1;
  EXPECT_NE(invalid_reason(design).find("reciprocal_bits"), std::string::npos);
  ++design.reciprocal_bits;
  EXPECT_EQ(invalid_reason(design), "");
}

TEST(InvalidReason, QuadraticWhoseSquareHasNoBitsIsRefused) {
  Design design = kHighTile;
  design.reciprocal_scheme = ReciprocalScheme::kQuadratic;
  design.reciprocal_lut_bits = 12;
  design.reciprocal_bits = 26;
  EXPECT_EQ(invalid_reason(design), "");
  design.gradient_fraction_bits = design.tile_fraction_bits = 12;
  design.reciprocal_bits = 23;
  EXPECT_NE(invalid_reason(design).find("quadratic"), std::string::npos);
}

// Parameters that a scheme does not have are not checked.
TEST(InvalidReason, ParametersThatASchemeDoesNotUseMayBeZero) {
  Design design = kHighTile;
  design.reciprocal_lut_bits = design.reciprocal_newton_steps = 0;
  EXPECT_NE(invalid_reason(design), "");
  design.reciprocal_scheme = ReciprocalScheme::kRestoring4;
  EXPECT_EQ(invalid_reason(design), "");
  design.reciprocal_bits = 0;
  EXPECT_NE(invalid_reason(design), "");
  design.reciprocal_scheme = ReciprocalScheme::kNone;
  EXPECT_EQ(invalid_reason(design), "");
}

TEST(InvalidReason, HierarchicalZOfTooFewOrTooManyStampsIsRefused) {
  Design design = kHighTile;
  design.hierarchical_z = true;
  EXPECT_EQ(invalid_reason(design), "");
  design.tile_log2 = design.stamp_width_log2 = 2;
  EXPECT_NE(invalid_reason(design).find("smaller than the tile"), std::string::npos);
  design.tile_log2 = 4;
  design.stamp_width_log2 = 0;
  EXPECT_NE(invalid_reason(design).find("at most 64"), std::string::npos);
  design.stamp_width_log2 = 1;
  EXPECT_EQ(invalid_reason(design), "");
  design.depth_test = false;
  EXPECT_NE(invalid_reason(design).find("depth_test"), std::string::npos);
}

TEST(InvalidReason, PartsThatNeedAnotherAreRefusedWithoutIt) {
  Design design = kHighTile;
  design.perspective = true;
  EXPECT_EQ(invalid_reason(design), "");
  design.reciprocal_scheme = ReciprocalScheme::kRestoring2;
  EXPECT_NE(invalid_reason(design).find("newton or quadratic"), std::string::npos);
  design = kHighTile;
  design.perspective = true;
  design.attributes = 0;
  EXPECT_NE(invalid_reason(design).find("attributes"), std::string::npos);
  design.perspective = false;
  design.setup_style = SetupStyle::kPipelined;
  design.reciprocal_scheme = ReciprocalScheme::kRestoring4;
  EXPECT_NE(invalid_reason(design).find("pipelined"), std::string::npos);
  design.depth_test = false;  // no planes, so no reciprocal
  EXPECT_EQ(invalid_reason(design), "");
}

TEST(NoRtlReason, SaysWhatOnlyTheFunctionalModelHas) {
  EXPECT_EQ(no_rtl_reason(kHighTile), "");
  for (const Design& design : kSchemes) {
    EXPECT_EQ(invalid_reason(design), "") << design.name;
    EXPECT_EQ(no_rtl_reason(design), "") << design.name;
  }
  EXPECT_EQ(no_cycles_reason(*find_design("div28")), "");
  EXPECT_EQ(no_rtl_reason(*find_design("div28")), "");
  EXPECT_NE(no_cycles_reason(*find_design("exact")), "");
  EXPECT_EQ(no_rtl_reason(*find_design("exact")), no_cycles_reason(*find_design("exact")));
}

struct WidthRow {
  int subpixel_bits, coord, edge_coeff, area2, edge, tile_edge, z_numerator, attr_numerator;
};

// The documented table, row by row; 8x8 tiles, z24.8 and u8.
TEST(Widths, TableOfTheDocumentation) {
  const WidthRow rows[] = {{4, 19, 20, 39, 35, 24, 52, 28},
                           {8, 23, 24, 47, 39, 28, 56, 32},
                           {12, 27, 28, 55, 43, 32, 60, 36}};
  for (const WidthRow& row : rows) {
    Design design = kHighTile;
    design.subpixel_bits = row.subpixel_bits;
    const Widths w = widths(design);
    EXPECT_EQ(w.coord, row.coord);
    EXPECT_EQ(w.edge_coeff, row.edge_coeff);
    EXPECT_EQ(w.area2, row.area2);
    EXPECT_EQ(w.edge, row.edge);
    EXPECT_EQ(w.tile_edge, row.tile_edge);
    EXPECT_EQ(w.depth_numerator, row.z_numerator);
    EXPECT_EQ(w.attr_numerator, row.attr_numerator);
    design.tile_log2 = 6;  // 64x64
    EXPECT_EQ(widths(design).tile_edge, row.tile_edge + 3);
  }
}

TEST(Widths, DefaultPlanesAre26AndTenIntegerBits) {
  const Widths w = widths(kHighTile);
  EXPECT_EQ(w.depth_plane, 26 + 18);
  EXPECT_EQ(w.depth_tile_plane, 26 + 8);
  EXPECT_EQ(w.attr_plane, 10 + 18);
  EXPECT_EQ(w.attr_tile_plane, 10 + 8);
  EXPECT_EQ(w.area2_length, 6);
  EXPECT_EQ(w.lanes, 4);
  EXPECT_EQ(w.pixel, 14);
  EXPECT_EQ(w.frame_size, 15);
}

TEST(Widths, FieldsOfTheTablesCarryThem) {
  const Contract c = contract(kHighTile);
  const auto format = [](const auto& table, const std::string& name) {
    for (const auto& f : table) {
      if (name == f.name) return format_name(f.is_signed, f.bits, f.fraction_bits, f.unit);
    }
    return std::string("no such field");
  };
  EXPECT_EQ(format(fields<Triangle>(c), "x"), "sQ14.8 px");
  EXPECT_EQ(format(fields<Triangle>(c), "z"), "uQ24.8 code");
  EXPECT_EQ(format(fields<SetupPrim>(c), "a"), "sQ15.8 px");
  EXPECT_EQ(format(fields<SetupPrim>(c), "e"), "sQ30.8 px^2");
  EXPECT_EQ(format(fields<SetupPrim>(c), "z_dx"), "sQ25.18 code/px");
  EXPECT_EQ(format(fields<Stamp>(c), "z_ref"), "sQ25.8 code");
  EXPECT_EQ(format(fields<Stamp>(c), "mask"), "u4 lane");
}

class ReciprocalRom : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(LutBits, ReciprocalRom, testing::Values(4, 7, 8, 10, 12));

// Each entry fits its bits, the table falls, and the first guess is as good as stated at both ends
// of its cell: (2^bits + entry)/2^(bits+1) against 1/(2m).
TEST_P(ReciprocalRom, EntriesFitTheirBitsAndMeetTheirBound) {
  Design design = kHighTile;
  design.reciprocal_lut_bits = GetParam();
  const int bits = reciprocal_rom_bits(design);
  const int entries = 1 << GetParam();
  int64_t last = int64_t{1} << bits;
  double worst = 0;
  for (int i = 0; i < entries; ++i) {
    const int64_t entry = reciprocal_rom(design, i);
    ASSERT_GE(entry, 0) << i;
    ASSERT_LT(entry, int64_t{1} << bits) << i;
    ASSERT_LE(entry, last) << i;
    last = entry;
    const double value = static_cast<double>((int64_t{1} << bits) + entry) / (2 << bits);
    for (const int end : {i, i + 1}) {
      const double m = static_cast<double>(entries + end) / (2 * entries);
      worst = std::max(worst, std::abs(2 * m * value - 1));
    }
  }
  // Half a cell and half a unit of the entry: (2^-1 + 2^-3) * 2^-lut_bits.
  EXPECT_LE(worst, .625 / entries);
  EXPECT_GT(worst, 1.0 / (4.0 * entries));  // no table of this length can do much better
}

class ParabolaRom : public testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(LutBitsAndK, ParabolaRom,
                         testing::Values(std::pair(4, 12), std::pair(4, 32), std::pair(7, 26),
                                         std::pair(12, 24), std::pair(12, 32)));

TEST_P(ParabolaRom, CoefficientsFitTheirBits) {
  Design design = kHighTile;
  design.reciprocal_scheme = ReciprocalScheme::kQuadratic;
  std::tie(design.reciprocal_lut_bits, design.reciprocal_bits) = GetParam();
  int64_t greatest_c1 = 0;
  int64_t greatest_c2 = 0;
  for (int i = 0; i < 1 << design.reciprocal_lut_bits; ++i) {
    const Parabola c = reciprocal_parabola(design, i);
    ASSERT_EQ(c.c0 >> parabola_c0_bits(design), 1) << i;  // the leading 1 that the ROM leaves out
    greatest_c1 = std::max(greatest_c1, c.c1);
    greatest_c2 = std::max(greatest_c2, c.c2);
    ASSERT_GE(std::min(c.c1, c.c2), 0) << i;
  }
  EXPECT_EQ(bit_length(static_cast<uint64_t>(greatest_c1)), parabola_c1_bits(design));
  EXPECT_EQ(bit_length(static_cast<uint64_t>(greatest_c2)), parabola_c2_bits(design));
  // As derived, plus one bit where the greatest coefficient rounds up to a power of two.
  const int derived = design.reciprocal_bits + 2 - design.reciprocal_lut_bits;
  EXPECT_EQ(parabola_c1_bits(design), derived + (design.reciprocal_lut_bits == 12 ? 1 : 0));
}

TEST(ReciprocalCycles, OneToAlignAndTheSchemesOwn) {
  const auto cycles = [](const std::string& name) {
    for (const Design& design : kSchemes) {
      if (name == design.name) return reciprocal_cycles(design);
    }
    return reciprocal_cycles(*find_design(name));
  };
  EXPECT_EQ(cycles("rom"), 2);
  EXPECT_EQ(cycles("low"), 4);
  EXPECT_EQ(cycles("high_tile"), 6);
  EXPECT_EQ(cycles("quadratic"), 4);
  EXPECT_EQ(cycles("div28"), 30);
  EXPECT_EQ(cycles("restoring4"), 16);
  EXPECT_EQ(cycles("restoring4_odd"), 17);
}

// Six products of one multiplier, the slots of the planes, or the reciprocal.
TEST(SetupCycles, IntervalIsThatOfTheBusiest) {
  EXPECT_EQ(widths(kHighTile).setup_interval_cycles, 6);
  EXPECT_EQ(widths(kHighTile).setup_planes_step, 12);
  EXPECT_EQ(widths(kSchemes[0]).setup_interval_cycles, 6);
  EXPECT_EQ(widths(*find_design("div28")).setup_interval_cycles, 30);
  EXPECT_EQ(widths(*find_design("div28")).setup_planes_step, 36);
  Design many = kHighTile;
  many.attributes = 16;  // and two slots of depth
  EXPECT_EQ(widths(many).setup_interval_cycles, 18);
  many.depth_test = false;
  EXPECT_EQ(widths(many).setup_interval_cycles, 16);
  many.attributes = 0;
  EXPECT_EQ(widths(many).setup_interval_cycles, 6);
}

}  // namespace
}  // namespace pineda::spec
