// The table of reciprocal schemes: each row is consistent with itself and with the package.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "model/spec/package.h"
#include "model/spec/reciprocal/schemes.h"
#include "tests/spec/names.h"

namespace pineda::spec {
namespace {

Design of(const Scheme& scheme) {
  Design d;
  d.reciprocal_scheme = scheme.value;
  return d;
}

/// How an entry of the table contradicts itself; empty if it does not.
std::string rom_fault(const ReciprocalRom& rom, const Design& d) {
  for (int i = 0; i < 1 << d.reciprocal_lut_bits; ++i) {
    int bits = 0;
    for (const RomPart& part : rom.entry(d, i)) {
      bits += part.bits;
      if (part.value < 0 || part.value >> part.bits != 0) return "a part beyond its bits";
    }
    if (bits != rom.entry_bits(d)) return "other bits than the entry has";
  }
  return rom.meaning(d).empty() ? "no meaning" : "";
}

TEST(ReciprocalSchemes, EntriesOfEachRomFitTheirBits) {
  int roms = 0;
  for (const Scheme& scheme : kReciprocalSchemes) {
    const Design d = of(scheme);
    EXPECT_EQ(reciprocal_rom_size_bits(d) > 0, scheme.has_rom) << scheme.word;
    if (!scheme.has_rom) continue;
    ++roms;
    EXPECT_EQ(rom_fault(scheme.rom, d), "") << scheme.word;
    EXPECT_EQ(reciprocal_rom_size_bits(d), 128 * scheme.rom.entry_bits(d)) << scheme.word;
  }
  EXPECT_EQ(roms, 2);
}

TEST(ReciprocalSchemes, MutantRomWhoseEntriesLackABitIsSeen) {
  ReciprocalRom mutant = newton::kScheme.rom;
  mutant.entry_bits = [](const Design& d) { return reciprocal_rom_bits(d) - 1; };
  EXPECT_EQ(rom_fault(mutant, kHighTile), "other bits than the entry has");
  mutant = newton::kScheme.rom;
  mutant.entry = [](const Design& d, int) {
    return std::vector<RomPart>{{reciprocal_rom_bits(d), 1 << reciprocal_rom_bits(d)}};
  };
  EXPECT_EQ(rom_fault(mutant, kHighTile), "a part beyond its bits");
}

// Each scheme states its cycles and error bound, and the package names its parts and no others.
TEST(ReciprocalSchemes, EachSaysItsCyclesErrorAndWhatThePackageNames) {
  for (const Scheme& scheme : kReciprocalSchemes) {
    const Design d = of(scheme);
    const bool is_none = scheme.value == ReciprocalScheme::kNone;
    EXPECT_EQ(has_reciprocal(d), !is_none) << scheme.word;
    EXPECT_EQ(scheme.cycles(d, 1) >= 2, !is_none) << scheme.word;
    EXPECT_EQ(scheme.constants(d).empty(), is_none) << scheme.word;
    EXPECT_EQ(scheme.logic_bits(d, 47) > 0, !is_none) << scheme.word;
    // The last rounding alone moves a mantissa by half a unit, of 2^-k: a relative 2^-k.
    EXPECT_EQ(scheme.error_bound(d) >= std::exp2(-d.reciprocal_bits), !is_none) << scheme.word;
    EXPECT_LT(scheme.error_bound(d), std::exp2(-16)) << scheme.word;
    if (is_none) continue;
    const std::string package = package_text(contract(d));
    EXPECT_NE(package.find(std::string("`define PINEDA_RECIPROCAL_") + scheme.macro + "\n"),
              std::string::npos);
    for (const Constant& constant : scheme.constants(d)) {
      EXPECT_NE(package.find(std::string(" ") + constant.name + " "), std::string::npos);
    }
    EXPECT_EQ(package.find("reciprocal_rom(") != std::string::npos, scheme.has_rom);
  }
}

// A quadratic needs a minimum of bits, but only in designs that have a reciprocal.
TEST(ReciprocalSchemes, WhatASchemeRefusesIsAskedOfDesignsThatHaveIt) {
  Design d = of(quadratic::kScheme);
  d.reciprocal_lut_bits = 12;
  d.reciprocal_bits = 23;
  d.gradient_fraction_bits = d.tile_fraction_bits = 12;
  EXPECT_EQ(invalid_reason(d),
            "reciprocal_bits must be at least 2*reciprocal_lut_bits in a quadratic reciprocal");
  d.depth_test = false;
  d.attributes = 0;
  EXPECT_EQ(invalid_reason(d), "");
}

TEST(ReciprocalSchemes, ThoseThatTakeANumberACycleAreNamed) {
  Design d = of(restoring::kScheme2);
  d.perspective = true;
  EXPECT_EQ(
      invalid_reason(d),
      "perspective needs reciprocal_scheme newton or quadratic: restoring2 takes many cycles");
  d.perspective = false;
  d.setup_style = SetupStyle::kPipelined;
  EXPECT_EQ(invalid_reason(d),
            "setup_style pipelined needs reciprocal_scheme newton or quadratic: restoring2 takes "
            "many cycles");
}

}  // namespace
}  // namespace pineda::spec
