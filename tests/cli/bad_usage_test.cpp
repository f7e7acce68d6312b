// Bad usage: exit 2, and one line on standard error that says what was expected.
#include <gtest/gtest.h>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

struct BadUsage {
  std::string name;
  Arguments arguments;
  std::string says;  // part of the line
};
std::ostream& operator<<(std::ostream& to, const BadUsage& bad) { return to << bad.name; }

class BadUsageTest : public testing::TestWithParam<BadUsage> {};

TEST_P(BadUsageTest, IsRefusedInOneLine) {
  const Scratch scratch;
  scratch.write("scene.tri", tri_text(frame("TileBorders")));
  scratch.write("scene.ptrb", ptrb_bytes(frame("TileBorders")));
  const Outcome run = pineda(GetParam().arguments, inside(scratch.path(".")));
  EXPECT_TRUE(is_refused(run, GetParam().says));
  EXPECT_EQ(run.out, "");
}

INSTANTIATE_TEST_SUITE_P(
    Cli, BadUsageTest,
    testing::Values(
        BadUsage{"NoCommand", {}, "command"}, BadUsage{"UnknownCommand", {"draw"}, "'draw'"},
        BadUsage{"NoScene", {"check"}, "scene"},
        BadUsage{"UnknownOption", {"render", "triangle", "--fast"}, "--fast"},
        BadUsage{"TwoScenes", {"render", "triangle", "grid"}, "grid"},
        BadUsage{"UnknownScene", {"render", "teapots"}, "teapots"},
        BadUsage{"UnknownHardCase", {"check", "hard/slivers"}, "sliver,"},
        BadUsage{"SizeWithHardCase", {"check", "hard/sliver", "--size", "8x8"}, "states its own"},
        BadUsage{"UnknownEnding", {"render", "scene.stl"}, "scene.stl"},
        BadUsage{"UnknownDesign", {"check", "triangle", "--design", "nope"}, "'nope'"},
        BadUsage{"MissingDesignFile", {"check", "triangle", "--design", "no.toml"}, "no.toml"},
        BadUsage{"SizeOfOneNumber", {"render", "teapot", "--size", "64"}, "WxH"},
        BadUsage{"SizeOfThree", {"render", "teapot", "--size", "64x48x2"}, "WxH"},
        BadUsage{"SizeWithBlank", {"render", "teapot", "--size", "64x 48"}, "WxH"},
        BadUsage{"SizeBeyondInt", {"render", "teapot", "--size", "99999999999x8"}, "WxH"},
        BadUsage{"SizeZero", {"render", "teapot", "--size", "0x48"}, "0x48"},
        BadUsage{"SizeNegative", {"render", "teapot", "--size", "64x-1"}, "64x-1"},
        BadUsage{"SizeTooWide", {"render", "teapot", "--size", "16385x1"}, "16385x1"},
        BadUsage{"SizeTooHigh", {"time", "teapot", "--size", "1x16385"}, "1x16385"},
        BadUsage{"SizeWithTri", {"render", "scene.tri", "--size", "64x48"}, "scene.tri"},
        BadUsage{"SizeWithPtrb", {"rtl", "scene.ptrb", "--size", "64x48"}, "scene.ptrb"},
        BadUsage{"CullWithTri", {"time", "scene.tri", "--cull", "back"}, "scene.tri"},
        BadUsage{"DepthWithPtrb", {"check", "scene.ptrb", "--depth", "off"}, "scene.ptrb"},
        BadUsage{"CameraWithTri", {"render", "scene.tri", "--eye", "1,2,3"}, "scene.tri"},
        BadUsage{
            "FileCameraOfTeapot", {"render", "teapot", "--camera", "0"}, "only .gltf and .glb"},
        BadUsage{"FileCameraNoNumber", {"render", "a.gltf", "--camera", "front"}, "--camera"},
        BadUsage{"FileCameraAndEye",
                 {"render", "a.gltf", "--camera", "0", "--eye", "1,2,3"},
                 "--camera"},
        BadUsage{
            "FileCameraAndAngle", {"render", "a.gltf", "--camera", "0", "--fov", "30"}, "--fov"},
        BadUsage{"TessellateWithGrid", {"render", "grid", "--tessellate", "4"}, "grid"},
        BadUsage{"TessellateZero", {"render", "teapot", "--tessellate", "0"}, "1 to"},
        BadUsage{"EyeOfTwo", {"render", "teapot", "--eye", "1,2"}, "--eye"},
        BadUsage{"UnknownCull", {"render", "teapot", "--cull", "both"}, "--cull"},
        BadUsage{"UnknownDepth", {"render", "teapot", "--depth", "more"}, "--depth"},
        BadUsage{"ScissorWithTri", {"time", "scene.tri", "--scissor", "0,0,8,8"}, "scene.tri"},
        BadUsage{"ScissorOfThree", {"render", "teapot", "--scissor", "0,0,8"}, "--scissor"},
        BadUsage{"ScissorOfFive", {"render", "teapot", "--scissor", "0,0,8,8,8"}, "X,Y,W,H"},
        BadUsage{"ScissorNegative", {"render", "grid", "--scissor=-1,0,-8,8"}, "X,Y,W,H"},
        BadUsage{"ScissorNoInteger", {"render", "grid", "--scissor", "0,0,8.5,8"}, "X,Y,W,H"},
        BadUsage{"DepthWriteWithPtrb", {"rtl", "scene.ptrb", "--depth-write", "on"}, "scene.ptrb"},
        BadUsage{"UnknownDepthWrite", {"render", "grid", "--depth-write", "no"}, "--depth-write"},
        BadUsage{"BiasWithHardCase", {"render", "hard/fan", "--depth-bias", "1,1"}, "its own"},
        BadUsage{"BiasOfOne", {"render", "grid", "--depth-bias", "1"}, "C,S"},
        BadUsage{"BiasNotWhole", {"render", "grid", "--depth-bias", ".5,0"}, "whole depth codes"},
        BadUsage{"BiasTooFar", {"render", "grid", "--depth-bias", "16777216,0"}, "16777215"},
        BadUsage{"BiasBeyondTheDesign",
                 {"render", "grid", "--depth-bias", "65536,0", "--design", "tiny", "--size", "9x9"},
                 "-65535 to 65535"},
        BadUsage{"BiasTooSteep", {"render", "grid", "--depth-bias", "0,128"}, "less than 128"},
        BadUsage{"ClearDepthWithTri", {"rtl", "scene.tri", "--clear-depth", "0"}, "scene.tri"},
        BadUsage{"ClearDepthTooGreat", {"render", "grid", "--clear-depth", "1.5"}, "from 0 to 1"},
        BadUsage{"ClearDepthNegative", {"render", "grid", "--clear-depth=-.5"}, "--clear-depth"},
        BadUsage{"ClearDepthNan", {"render", "grid", "--clear-depth", "nan"}, "'nan'"},
        BadUsage{"ClearDepthNoNumber", {"render", "grid", "--clear-depth", "far"}, "'far'"},
        BadUsage{"ShadeWithTri", {"check", "scene.tri", "--shade", "flat"}, "scene.tri"},
        BadUsage{"UnknownShade", {"render", "grid", "--shade", "phong"}, "--shade"},
        BadUsage{"RtlTraceOfAnotherFormat",
                 {"rtl", "triangle", "--trace", "a.vcd"},
                 "--trace: expected a file .fst, got 'a.vcd'"},
        BadUsage{"RtlTraceWithoutAnEnding", {"rtl", "triangle", "--trace", "a"}, "got 'a'"},
        BadUsage{"LatencyZero", {"check", "triangle", "--latency", "0"}, "1 to 1024"},
        BadUsage{"LatencyTooLong", {"time", "triangle", "--latency", "1025"}, "1 to 1024"},
        BadUsage{"LatencyNoNumber", {"rtl", "triangle", "--latency", "x"}, "--latency"},
        BadUsage{"LatencyOfDram",
                 {"rtl", "triangle", "--memory", "dram", "--latency", "8"},
                 "only an ideal memory"},
        BadUsage{"UnknownMemory", {"time", "triangle", "--memory", "sram"}, "--memory"},
        BadUsage{"UnknownStall", {"rtl", "triangle", "--stall", "often"}, "--stall"},
        BadUsage{"SeedNoNumber", {"rtl", "triangle", "--seed", "x"}, "--seed"},
        BadUsage{"BenchZero", {"render", "triangle", "--bench", "0"}, "--bench"},
        BadUsage{"BenchNoNumber", {"time", "triangle", "--bench", "many"}, "--bench"},
        BadUsage{"ThreadsZero", {"render", "triangle", "--threads", "0"}, "--threads"},
        BadUsage{"JsonWithoutFile", {"render", "triangle", "--json"}, "--json"},
        BadUsage{"NeedsOfNoScene", {"needs"}, "scene"},
        BadUsage{"NeedsIntoNoDesignFile", {"needs", "triangle", "-o", "a.json"}, ".toml"},
        BadUsage{"NeedsWithinNoDepth", {"needs", "triangle", "--depth-ulp", "0"}, "--depth-ulp"},
        BadUsage{"NeedsWithinNoColour", {"needs", "triangle", "--color-lsb", "x"}, "--color-lsb"},
        BadUsage{"NeedsOfExactPlanes", {"needs", "triangle", "--design", "exact"}, "exact"},
        BadUsage{"NeedsOfNeeds", {"needs", "triangle", "--design", "auto"}, "'auto'"},
        BadUsage{"WalkOfNeeds", {"walk", "triangle", "--design", "auto"}, "'auto'"},
        BadUsage{"AutoOfNoScene", {"render", "none.tri", "--design", "auto"}, "none.tri"},
        BadUsage{"WalkBeyondTheEnd", {"walk", "triangle", "--triangle", "1"}, "--triangle"},
        BadUsage{"NameTooLong", {"render", std::string(5000, 'a') + ".tri"}, "aaa"}),
    [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace pineda::test
