#include "studies/area/rtlil.h"

#include <gtest/gtest.h>

namespace pineda::studies {
namespace {

constexpr const char* kText = R"(# Generated
autoidx 12
attribute \top 1
module \top
  wire width 4 input 1 \a
  wire $auto$x.cc:1:run$11
  wire width 2 output 2 \y
  cell $mem_v2 \mem
    parameter \SIZE 16
    parameter signed \OFFSET 0
    parameter \INIT 4'0001
    connect \A $auto$x.cc:1:run$11
  end
  cell $paramod$0123456789\part \u_part
    connect \A $add$b.sv:2$7
  end
  connect \y $auto$x.cc:1:run$11
end
module $paramod$0123456789\part
  wire input 1 \A
end
)";

TEST(Rtlil, ModulesCellsAndPorts) {
  const auto modules = parse_rtlil(kText);
  ASSERT_EQ(modules.size(), 2u);
  EXPECT_EQ(modules[0].name, "\\top");
  ASSERT_EQ(modules[0].cells.size(), 2u);
  EXPECT_EQ(modules[0].cells[0].type, "$mem_v2");
  EXPECT_EQ(modules[0].cells[0].name, "\\mem");
  EXPECT_EQ(modules[0].cells[0].parameter.at("SIZE"), 16);
  EXPECT_EQ(modules[0].cells[0].parameter.at("OFFSET"), 0);
  EXPECT_EQ(modules[0].cells[0].parameter.count("INIT"), 0u);
  EXPECT_EQ(modules[0].cells[1].type, modules[1].name);
  EXPECT_EQ(modules[0].ports.size(), 2u);
  EXPECT_EQ(black_box(modules[1]),
            "attribute \\blackbox 1\nmodule $paramod$0123456789\\part\n  wire input 1 \\A\nend\n");
}

TEST(Rtlil, RenumberedTextDoesNotKnowWhatWasElaboratedBeside) {
  const std::string text = parse_rtlil(kText)[0].text;
  std::string other = text;
  for (size_t at = 0; (at = other.find("run$11", at)) != std::string::npos; ++at) {
    other.replace(at, 6, "run$99");
  }
  ASSERT_NE(other, text);
  EXPECT_EQ(renumbered(other), renumbered(text));
  // Types and modules keep their names, and different wires stay different.
  EXPECT_NE(renumbered(text).find("cell $mem_v2 \\mem"), std::string::npos);
  EXPECT_NE(renumbered(text).find("$paramod$0123456789\\part"), std::string::npos);
  EXPECT_NE(renumbered(text).find("$n$1"), std::string::npos);
  EXPECT_NE(renumbered(text).find("$n$2"), std::string::npos);
}

}  // namespace
}  // namespace pineda::studies
