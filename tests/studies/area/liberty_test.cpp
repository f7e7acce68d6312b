#include "studies/area/liberty.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "studies/area/area_error.h"
#include "tests/scene/scratch.h"

namespace pineda::studies {
namespace {

using scene::Scratch;

constexpr const char* kLibrary = R"(/* a library
 { with braces } in a comment */
library ("small") {
  time_unit : "100ps";  // another comment
  capacitive_load_unit (2, ff);
  lu_table_template (t) { index_1 ("1, 2"); }
  power_lut_template (p) { index_1 ("1"); }
  cell (INV) {
    area : 1.5;
    leakage_power () { value : 3; }
    pin (Y) {
      function : "(!A) /* not a comment { */";
      internal_power () { rise_power (p) { values ("1"); } }
      timing () { cell_rise (t) { values ("1, 2"); } }
    }
  }
  cell ("DFF") {
    area : 7
    ff (IQ, IQN) { next_state : "D"; clocked_on : "C"; }
  }
  cell (DFF4) { area : 20; ff_bank (IQ, IQN, 4) { next_state : "D"; } }
  cell (LATCH) { area : 5; latch (IQ, IQN) { enable : "E"; } }
  cell (ICG) { area : 6; statetable ("CK E", "IQ") { table : "L L : - : L"; } }
}
)";

std::string error_of(const std::string& file) {
  try {
    Liberty::read(file);
  } catch (const AreaError& error) {
    return error.what();
  }
  return "read";
}

TEST(Liberty, KnowsCellsAndUnits) {
  const Scratch scratch;
  const Liberty library = Liberty::read(scratch.write("small.lib", kLibrary));
  EXPECT_EQ(library.time_unit_ps(), 100);
  EXPECT_EQ(library.capacitance_unit_ff(), 2);
  ASSERT_EQ(library.cells().size(), 5u);
  EXPECT_EQ(library.cells().at("INV").area_um2, 1.5);
  EXPECT_EQ(library.cells().at("INV").flip_flops, 0);
  EXPECT_EQ(library.cells().at("DFF").area_um2, 7);
  EXPECT_EQ(library.cells().at("DFF").flip_flops, 1);
  EXPECT_EQ(library.cells().at("DFF4").flip_flops, 4);
  EXPECT_TRUE(library.cells().at("LATCH").is_latch);
  EXPECT_TRUE(library.cells().at("ICG").is_latch);
  EXPECT_FALSE(library.cells().at("DFF").is_latch);
}

TEST(Liberty, LeavesOutPowerAndCells) {
  const Scratch scratch;
  const Liberty library = Liberty::read(scratch.write("small.lib", kLibrary));
  const std::string text = library.text([](const std::string& cell) { return cell != "DFF4"; });
  EXPECT_EQ(text.find("power"), std::string::npos) << text;
  EXPECT_EQ(text.find("DFF4"), std::string::npos) << text;
  EXPECT_NE(text.find("cell_rise"), std::string::npos) << text;
  // What is left is a library, with all else unchanged.
  const Liberty again = Liberty::read(scratch.write("again.lib", text));
  EXPECT_EQ(again.cells().size(), 4u);
  EXPECT_EQ(again.text([](const std::string&) { return true; }), text);
}

TEST(Liberty, ReadsGzip) {
  const Scratch scratch;
  const std::string file = scratch.path("small.lib.gz");
  gzFile stream = gzopen(file.c_str(), "wb");
  ASSERT_GT(gzputs(stream, kLibrary), 0);
  gzclose(stream);
  EXPECT_EQ(Liberty::read(file).cells().size(), 5u);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 20);
  EXPECT_EQ(error_of(file), file + ": expected a Liberty file, its compressed data are damaged");
}

TEST(Liberty, RefusesWhatIsNone) {
  const Scratch scratch;
  const auto refused = [&](const std::string& text) {
    return error_of(scratch.write("bad.lib", text)).substr(scratch.path("bad.lib").size());
  };
  EXPECT_EQ(refused("module m; endmodule"), ":1: expected library (NAME) {");
  EXPECT_EQ(refused(""), ":1: expected the name of a group or of an attribute");
  EXPECT_EQ(refused("library (x) {\n cell (A) {\n area : 1;\n}\n"), ":5: expected }");
  EXPECT_EQ(refused("library (x) {\n cell (A) {\n area : big;\n}}\n"),
            ":3: expected an area in um^2");
  EXPECT_EQ(refused("library (x) {\n/* cell"), ":2: expected the end of the comment");
  EXPECT_EQ(refused("library (x) {\n a : \"b"), ":2: expected the end of the string");
  EXPECT_EQ(refused("library (x) {\n time_unit : \"1 parsec\";\n}"), ":2: expected a unit of time");
  EXPECT_EQ(refused("library (x) {\n cell (A) {}\n cell (A) {}\n}"),
            ":3: expected one cell A, this is another");
  EXPECT_EQ(refused("library (x) { cell (A) {} }"), ": expected a cell with an area");
  EXPECT_EQ(refused("library (x) { cell (A) { area : 1; } }"),
            ": expected time_unit and capacitive_load_unit");
  const std::string missing = scratch.path("none.lib");
  EXPECT_EQ(error_of(missing), missing + ": expected a Liberty file, cannot read it");
  EXPECT_EQ(error_of(scratch.path("")).substr(scratch.path("").size()),
            ": expected a Liberty file, cannot read it");
}

}  // namespace
}  // namespace pineda::studies
