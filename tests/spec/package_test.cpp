// The generated SystemVerilog package: the committed file is what the contract says.
#include "model/spec/package.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "tests/spec/schemes.h"

namespace pineda::spec {
namespace {

std::string committed_package() {
  std::ifstream file(PINEDA_SOURCE_DIR "/rtl/pineda_pkg.sv", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Package, CommittedFileIsGeneratedByteForByte) {
  EXPECT_EQ(committed_package(), package_text(contract(kHighTile)))
      << "run: cmake --build build --target package";
}

using Parameter = int Design::*;
constexpr Parameter kFormats[] = {&Design::subpixel_bits,
                                  &Design::guard_bits,
                                  &Design::depth_bits,
                                  &Design::attributes,
                                  &Design::attribute_bits,
                                  &Design::reciprocal_lut_bits,
                                  &Design::reciprocal_newton_steps,
                                  &Design::reciprocal_bits,
                                  &Design::gradient_fraction_bits,
                                  &Design::tile_fraction_bits,
                                  &Design::tile_log2,
                                  &Design::stamp_width_log2,
                                  &Design::stamp_height_log2};
constexpr Parameter kBuffers[] = {&Design::prim_fifo_depth, &Design::tile_fifo_depth,
                                  &Design::stamp_fifo_depth, &Design::max_depth_latency_cycles};

Contract one_less(Parameter parameter) {
  Design design = kHighTile;
  --(design.*parameter);
  return contract(design);
}

// A changed width changes the text, so that a stale file is noticed, and both hashes.
TEST(Package, ChangedFormatChangesTheTextAndBothHashes) {
  const std::string committed = committed_package();
  std::set<uint64_t> packages{package_hash(contract(kHighTile))};
  std::set<uint64_t> formats{formats_hash(contract(kHighTile))};
  for (const Parameter parameter : kFormats) {
    const Contract changed = one_less(parameter);
    EXPECT_NE(package_text(changed), committed);
    EXPECT_TRUE(packages.insert(package_hash(changed)).second);
    EXPECT_TRUE(formats.insert(formats_hash(changed)).second);
  }
}

// The size of a buffer affects no bit: plug-ins become stale, vectors do not.
TEST(Package, ChangedBufferLeavesTheFormatsHashAlone) {
  for (const Parameter parameter : kBuffers) {
    EXPECT_NE(package_hash(one_less(parameter)), package_hash(contract(kHighTile)));
    EXPECT_EQ(formats_hash(one_less(parameter)), formats_hash(contract(kHighTile)));
  }
}

// The package has a ROM only if the scheme does.
TEST(Package, RomStandsWhereTheSchemeHasOne) {
  const auto holds = [](const Design& design, const std::string& text) {
    return package_text(contract(design)).find(text) != std::string::npos;
  };
  for (const Design& design : kSchemes) {
    const bool newton = design.reciprocal_scheme == ReciprocalScheme::kNewton;
    const bool quadratic = design.reciprocal_scheme == ReciprocalScheme::kQuadratic;
    EXPECT_EQ(holds(design, "`define PINEDA_RECIPROCAL_NEWTON\n"), newton) << design.name;
    EXPECT_EQ(holds(design, "`define PINEDA_RECIPROCAL_QUADRATIC\n"), quadratic) << design.name;
    EXPECT_EQ(holds(design, "`define PINEDA_RECIPROCAL_RESTORING\n"), !newton && !quadratic)
        << design.name;
    EXPECT_EQ(holds(design, "reciprocal_rom("), newton || quadratic) << design.name;
    EXPECT_EQ(holds(design, "RECIPROCAL_LUT_BITS"), newton || quadratic) << design.name;
    EXPECT_EQ(holds(design, "RECIPROCAL_RADIX_BITS"), !newton && !quadratic) << design.name;
  }
}

TEST(Package, SameTextAndHashOnEveryCall) {
  EXPECT_EQ(package_text(contract(kHighTile)), package_text(contract(kHighTile)));
  EXPECT_EQ(package_hash(contract(kHighTile)), package_hash(contract(kHighTile)));
  EXPECT_EQ(formats_hash(contract(kHighTile)), formats_hash(contract(kHighTile)));
}

// FNV-1a of "" and "a" as published.
TEST(TextHash, PublishedValues) {
  EXPECT_EQ(text_hash(""), 0xcbf29ce484222325u);
  EXPECT_EQ(text_hash("a"), 0xaf63dc4c8601ec8cu);
}

}  // namespace
}  // namespace pineda::spec
