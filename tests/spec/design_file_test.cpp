// Designs from TOML: what is read, what is left to the base, what is refused and how.
#include "model/spec/design_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "model/spec/package.h"
#include "model/spec/parameters.h"

namespace pineda::spec {
namespace {

TEST(DesignFile, StatesWhatDiffersFromItsBase) {
  const Design d = parse_design(
      "base = \"med\"\nname = \"small\"\nsummary = \"for a test\"\ndepth_bits = 16\ntile_px = 16\n"
      "stamp_width_px = 4\nstamp_height_px = 1\nreciprocal_scheme = \"restoring4\"\n",
      "any.toml");
  const Design& med = *find_design("med");
  EXPECT_STREQ(d.name, "small");
  EXPECT_STREQ(d.summary, "for a test");
  EXPECT_EQ(d.depth_bits, 16);
  EXPECT_EQ(d.tile_log2, 4);
  EXPECT_EQ(d.stamp_width_log2, 2);
  EXPECT_EQ(d.stamp_height_log2, 0);
  EXPECT_EQ(d.reciprocal_scheme, ReciprocalScheme::kRestoring4);
  EXPECT_EQ(d.reciprocal_bits, med.reciprocal_bits);
  EXPECT_EQ(d.gradient_fraction_bits, med.gradient_fraction_bits);
}

TEST(DesignFile, EmptyOneIsTheDefaultUnderItsOwnName) {
  const Design d = parse_design("", "folder/mine.toml");
  EXPECT_STREQ(d.name, "mine");
  EXPECT_EQ(formats_hash(contract(d)), formats_hash(contract(kHighTile)));
}

TEST(DesignFile, RoundTripOfEveryNamedDesign) {
  for (const Design& design : designs()) {
    const std::string text = design_toml(design);
    const Design again = parse_design(text, "again.toml");
    EXPECT_EQ(design_toml(again), text);
    EXPECT_EQ(formats_hash(contract(again)), formats_hash(contract(design))) << design.name;
    EXPECT_STREQ(again.name, design.name);
  }
}

TEST(DesignFile, TwoFilesKeepTheirNames) {
  const Design a = parse_design("name = \"first\"", "x.toml");
  const Design b = parse_design("name = \"second\"", "x.toml");
  EXPECT_STREQ(a.name, "first");
  EXPECT_STREQ(b.name, "second");
}

struct Bad {
  const char* text;
  const char* says;
};

TEST(DesignFile, RefusesWithFileLineAndWhatWasExpected) {
  const Bad all[] = {
      {"depth_bits = 24\nfog = 1\n", "d.toml:2: expected a parameter"},
      {"depth_bits = \"24\"\n", "d.toml:1: expected depth_bits to be a whole number"},
      {"depth_bits = 24.5\n", "d.toml:1: expected depth_bits"},
      {"\ndepth_bits = 99999999999\n", "d.toml:2: expected depth_bits"},
      {"\n\ndepth_bits = 15\n", "d.toml:3: expected a design that can be built: depth_bits is 15"},
      {"tile_px = 12\n", "d.toml:1: expected tile_px to be a power of two, got 12"},
      {"name = \"a\"\ntile_px = 128\n",
       "d.toml:2: expected a design that can be built: tile_px is 128, must be 4 to 64"},
      {"tile_px = 0\n", "power of two"},
      {"base = \"best\"\n", "d.toml:1: expected base to be a named design, got best"},
      {"name = 7\n", "d.toml:1: expected name to be a text"},
      {"name = \"\"\n", "d.toml:1: expected name to be a text"},
      {"reciprocal_scheme = \"table\"\n",
       "d.toml:1: expected reciprocal_scheme to be one of newton, quadratic, restoring2, "
       "restoring4, none, got table"},
      {"setup_style = \"fast\"\n",
       "d.toml:1: expected setup_style to be one of stepped, pipelined, serial, got fast"},
      {"depth_test = 1\n", "d.toml:1: expected depth_test to be true or false"},
      {"depth_bits = 24\ndepth_bits = 24\n", "d.toml:2: expected TOML"},
      {"depth_bits\n", "d.toml:1: expected TOML"},
      {"depth_test = tru\n", "d.toml:1: expected TOML"},  // the parser's message has a line break
      {"\"fog\\nbank\" = 1\n", "d.toml:1: expected a parameter"},
      {"[depth]\nbits = 24\n", "d.toml:1: expected a parameter"},
      {"reciprocal_bits = 20\n", "reciprocal_bits must be at least"},
  };
  for (const Bad& bad : all) {
    try {
      parse_design(bad.text, "d.toml");
      ADD_FAILURE() << bad.text;
    } catch (const DesignFileError& error) {
      const std::string says = error.what();
      EXPECT_NE(says.find(bad.says), std::string::npos) << says << "\nwanted: " << bad.says;
      EXPECT_EQ(says.find('\n'), std::string::npos) << says;
    }
  }
  EXPECT_THROW(read_design("no/such/file.toml"), DesignFileError);
}

// The error is in px where the key is in px, and names the key's line.
TEST(DesignFile, ValueBeyondTheRangeIsNamedByItsKeyAsItWasWritten) {
  const std::string every_part = "perspective = true\nhierarchical_z = true\n";
  int numbers = 0;
  for (const Parameter& p : kParameters) {
    if (!std::holds_alternative<Number>(p.member)) continue;
    ++numbers;
    try {
      parse_design(every_part + p.key + " = 524288\n", "d.toml");
      // A frame may have this many tiles.
      EXPECT_EQ(p.key, std::string("hierarchical_z_tiles"));
    } catch (const DesignFileError& error) {
      const std::string says = error.what();
      EXPECT_NE(says.find(std::string("d.toml:3: expected a design that can be built: ") + p.key +
                          " is 524288, must be "),
                std::string::npos)
          << says;
    }
  }
  EXPECT_GT(numbers, 20);
}

// The differences from a named design are enough to read the design back.
TEST(DesignFile, DifferencesFromANamedDesignAreReadBack) {
  for (const Design& d : designs()) {
    for (const Design& base : designs()) {
      EXPECT_EQ(design_toml(parse_design(design_toml(d, base), "d.toml")), design_toml(d));
    }
    const std::string text = design_toml(d, d);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;  // base, name, summary
  }
}

}  // namespace
}  // namespace pineda::spec
