// Meshes from files as a user sees them: what is drawn, judged and said.
#include <algorithm>
#include <array>
#include <set>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

/// A small mesh of the fuzzers' first inputs.
std::string mesh(const std::string& name) {
  return std::string(PINEDA_CORPUS) + "/" + name.substr(name.rfind('.') + 1) + "/" + name;
}

struct Drawn {
  std::vector<uint16_t> hits;
  std::vector<std::array<uint8_t, 3>> color;
  std::string depth;  // the bytes of the file
  std::string said;   // on both outputs
  int exit_code = 0;

  uint64_t hit_samples() const {
    return static_cast<uint64_t>(
        std::count_if(hits.begin(), hits.end(), [](int n) { return n > 0; }));
  }
  uint64_t all_hits() const {
    uint64_t sum = 0;
    for (const uint16_t n : hits) sum += n;
    return sum;
  }
  /// Of the samples that are hit.
  std::set<std::array<uint8_t, 3>> colors() const {
    std::set<std::array<uint8_t, 3>> all;
    for (size_t i = 0; i < hits.size(); ++i) {
      if (hits[i] > 0) all.insert(color[i]);
    }
    return all;
  }
  bool operator==(const Drawn& other) const {
    return hits == other.hits && color == other.color && depth == other.depth;
  }
};

Drawn draw_with(const Surroundings& surroundings, const std::string& path,
                const Arguments& options) {
  const Scratch scratch;
  Arguments arguments{"render", path, "--dump", scratch.path("d")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = pineda(arguments, surroundings);
  Drawn drawn;
  drawn.said = run.out + run.err;
  drawn.exit_code = run.exit_code;
  if (run.exit_code != 0) return drawn;
  const std::string hits = read_bytes(scratch.path("d/hits.u16"));
  const std::string color = read_bytes(scratch.path("d/color.rgba"));
  drawn.depth = read_bytes(scratch.path("d/depth.u32"));
  const auto byte = [](char c) { return static_cast<uint8_t>(c); };
  for (size_t i = 0; i + 1 < hits.size(); i += 2) {
    drawn.hits.push_back(static_cast<uint16_t>(byte(hits[i]) | byte(hits[i + 1]) << 8));
  }
  for (size_t i = 0; i + 3 < color.size(); i += 4) {
    drawn.color.push_back({byte(color[i]), byte(color[i + 1]), byte(color[i + 2])});
  }
  return drawn;
}

Drawn draw(const std::string& path, const Arguments& options) {
  Drawn drawn = draw_with({}, path, options);
  EXPECT_EQ(drawn.exit_code, 0) << drawn.said;
  return drawn;
}

void expect_check_holds(const std::string& path, Arguments options, uint64_t least_samples) {
  Arguments arguments{"check", path};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Json found = figures(arguments);
  EXPECT_EQ(found["holds"], true) << path;
  EXPECT_EQ(found["mesh"]["wrong"], 0);
  EXPECT_GE(found["mesh"]["samples"], least_samples);
}

using Colors = std::set<std::array<uint8_t, 3>>;

TEST(Mesh, FlatColourIsTheFirstVertexsAlsoBehindTheNearPlane) {
  const Arguments options{"--size", "64x64", "--eye", "0,0,5", "--shade", "flat"};
  EXPECT_EQ(draw(mesh("flat_near_v0out.ply"), options).colors(), (Colors{{255, 0, 0}}));
  expect_check_holds(mesh("flat_near_v0out.ply"), options, 500);
}

TEST(Mesh, FrameOfTheGuardBandsSizeIsFilled) {
  EXPECT_EQ(draw(mesh("wall.ply"), {"--size", "16384x4", "--eye", "0,0,5"}).all_hits(), 65536u);
}

// A quad that ends between the last samples and the borders of a frame of 2^8 px.
TEST(Mesh, DesignThatIsNeededForAFrameDrawsAllOfIt) {
  const Scratch scratch;
  const std::string quad = scratch.write(
      "quad.obj",
      "v -1.4805 -1.4805 0\nv 1.4805 -1.4805 0\nv 1.4805 1.4805 0\nv -1.4805 1.4805 0\n"
      "f 1 2 3 4\n");
  const std::string design = scratch.path("small.toml");
  const Outcome run = pineda({"needs", quad, "-o", design, "--size", "256x256", "--eye", "0,0,5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_NE(read_bytes(design).find("guard_bits = 8"), std::string::npos) << read_bytes(design);
  const Drawn drawn = draw(quad, {"--size", "256x256", "--eye", "0,0,5", "--design", design});
  EXPECT_EQ(drawn.all_hits(), 65536u);
}

TEST(Mesh, FanHasTheColoursOfItsListOfTriangles) {
  const Arguments options{"--eye", "0,0,5", "--shade", "flat", "--size", "64x48"};
  const Drawn fan = draw(mesh("fan.gltf"), options);
  EXPECT_EQ(fan.colors().size(), 3u);
  EXPECT_TRUE(fan == draw(mesh("fan_list.gltf"), options));
  expect_check_holds(mesh("fan.gltf"), options, 100);
}

TEST(Mesh, NoSampleOfATriangleIsHitTwiceWhereSnappingTurnsAPieceOver) {
  const Arguments options{
      "--size",  "96x72", "--eye=.9999,.5,.5", "--look-at=-.45,-.572,-.172", "--fov=178",
      "--depth", "off"};
  const Drawn drawn = draw(mesh("dbl_min.ply"), options);
  EXPECT_EQ(*std::max_element(drawn.hits.begin(), drawn.hits.end()), 1);
  expect_check_holds(mesh("dbl_min.ply"), options, 30);
}

TEST(Mesh, ConcavePolygonsAreTheirInsideOnce) {
  for (const char* name : {"p_arrow_r.ply", "p_u.obj"}) {
    const Arguments options{"--size", "64x48", "--eye", "0,0,5", "--depth", "off"};
    const Drawn drawn = draw(mesh(name), options);
    EXPECT_EQ(drawn.all_hits(), drawn.hit_samples()) << name;
    expect_check_holds(mesh(name), options, 200);
  }
}

TEST(Mesh, OnePolygonHasOneFlatColourWhateverItsFormat) {
  const Arguments options{"--size", "64x48", "--eye", "0,0,5", "--shade", "flat"};
  const Drawn obj = draw(mesh("quad.obj"), options);
  EXPECT_EQ(obj.colors(), (Colors{{255, 0, 0}}));
  EXPECT_TRUE(obj == draw(mesh("quad.ply"), options));
  EXPECT_EQ(draw(mesh("p_dart.obj"), options).colors(), (Colors{{255, 0, 0}}));
}

TEST(Mesh, SameMeshIsTheSamePictureWhateverItsFileHoldsBesides) {
  const Drawn wanted = draw(mesh("canon.obj"), {"--size", "64x48"});
  EXPECT_GT(wanted.hit_samples(), 300u);
  for (const char* name : {"canon.ply", "canon.gltf", "b01_cont.obj", "b06_comment.obj",
                           "b08_nonormals.obj", "b10_bom_more.obj", "q01_comment_first.ply",
                           "g01_req_KHR_materials_unlit.gltf", "g03_sparse.gltf"}) {
    EXPECT_TRUE(wanted == draw(mesh(name), {"--size", "64x48"})) << name;
  }
}

TEST(Mesh, ReversedZIsTheSamePictureWithReversedDepths) {
  const Drawn usual = draw("teapot", {"--size", "160x120"});
  const Drawn reversed = draw("teapot", {"--size", "160x120", "--reverse-z"});
  EXPECT_EQ(usual.hits, reversed.hits);
  size_t other = 0;
  for (size_t i = 0; i < usual.color.size(); ++i)
    other += usual.color[i] != reversed.color[i] ? 1 : 0;
  EXPECT_LT(other, 5u);  // where depths are equal to a rounding
  EXPECT_NE(usual.depth, reversed.depth);
  expect_check_holds("teapot", {"--size", "160x120", "--reverse-z"}, 5000);
  // What is given wins.
  const std::string said = draw("teapot", {"--reverse-z", "--clear-depth", "1"}).said;
  EXPECT_NE(said.find("depth greater"), std::string::npos) << said;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

bool is_as_without_its_carriage_return(const Surroundings& with) {
  const Scratch scratch;
  const auto is_same = [&](const std::string& text) {  // it begins with "# x" and a CR
    const std::string without = scratch.write("without.obj", "# x" + text.substr(4));
    const Drawn wanted = draw(without, {});
    return wanted.hit_samples() > 0 &&
           draw_with(with, scratch.write("with.obj", text), {}) == wanted;
  };
  return is_same(read_bytes(mesh("crash_min.obj"))) &&
         is_same("# x\rv 0 0 0\nv -1 -1 0\nv 1 -1 .25\nv 1 1 0\nf 1 2 3\n");
}

bool is_as_without_its_byte_order_mark(const Surroundings& with) {
  const Arguments options{"--size", "64x48"};
  return draw_with(with, mesh("b10_bom_more.obj"), options) == draw(mesh("canon.obj"), options);
}

bool is_coloured_by_short_names(const Surroundings& with) {
  const Arguments options{"--size", "64x48", "--shade", "flat"};
  return draw_with(with, mesh("q04_rgb_short.ply"), options).colors() ==
         Colors{{200, 30, 30}, {200, 200, 30}};
}

bool says_that_colours_are_affine(const Surroundings& with) {
  const auto says = [&](const std::string& path, const char* design) {
    return has(draw_with(with, path, {"--design", design}).said, "interpolates colours affinely");
  };
  return says(mesh("floor1.ply"), "high_tile") && !says(mesh("floor1.ply"), "persp") &&
         !says("teapot", "high_tile");
}

bool says_that_nothing_is_greater(const Surroundings& with) {
  const auto says = [&](const Arguments& options) {
    return has(draw_with(with, "teapot", options).said, "depth greater: nothing");
  };
  return says({"--depth", "greater"}) && !says({"--depth", "greater", "--clear-depth", "0"}) &&
         !says({"--depth", "less"});
}

/// What a mesh's file gives or a user is told, and the program that once had it wrong.
struct Reading {
  const char* name;
  bool (*is_right)(const Surroundings&);
};

std::ostream& operator<<(std::ostream& to, const Reading& reading) { return to << reading.name; }

class OldReading : public testing::TestWithParam<Reading> {};

TEST_P(OldReading, IsRightAndItsMutantIsNot) {
  EXPECT_TRUE(GetParam().is_right({}));
  Surroundings with_fault;
  with_fault.program = std::string(PINEDA_MUTANTS) + GetParam().name;
  // It works but for its fault, so that the fault is what is seen.
  ASSERT_GT(draw_with(with_fault, "triangle", {}).hit_samples(), 0u);
  EXPECT_FALSE(GetParam().is_right(with_fault));
}

INSTANTIATE_TEST_SUITE_P(Mesh, OldReading,
                         testing::Values(Reading{"cr", is_as_without_its_carriage_return},
                                         Reading{"bom", is_as_without_its_byte_order_mark},
                                         Reading{"rgb", is_coloured_by_short_names},
                                         Reading{"affine", says_that_colours_are_affine},
                                         Reading{"greater", says_that_nothing_is_greater}),
                         [](const auto& row) { return std::string(row.param.name); });

/// The program with an old fault, and a mesh that shows it.
struct Mutant {
  const char* name;
  const char* file;
  Arguments options;
};
std::ostream& operator<<(std::ostream& to, const Mutant& mutant) { return to << mutant.name; }

class OldFault : public testing::TestWithParam<Mutant> {};

TEST_P(OldFault, IsSeenByCheckOnTheMesh) {
  const Mutant& mutant = GetParam();
  Arguments arguments{"check", mesh(mutant.file)};
  arguments.insert(arguments.end(), mutant.options.begin(), mutant.options.end());
  Surroundings with_fault;
  with_fault.program = std::string(PINEDA_MUTANTS) + mutant.name;
  const Outcome run = pineda(arguments, with_fault);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find(" WRONG, first ("), std::string::npos) << run.out;
  EXPECT_EQ(pineda(arguments).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Mesh, OldFault,
    testing::Values(
        Mutant{"flat", "flat_near_v0out.ply", {"--size=64x64", "--eye=0,0,5", "--shade=flat"}},
        Mutant{"guard", "wall.ply", {"--size=16384x4", "--eye=0,0,5"}},
        Mutant{"fan", "fan.gltf", {"--size=64x48", "--eye=0,0,5", "--shade=flat"}},
        Mutant{"pieces",
               "dbl_min.ply",
               {"--size=96x72", "--eye=.9999,.5,.5", "--look-at=-.45,-.572,-.172", "--fov=178",
                "--depth=off"}},
        Mutant{"polygon", "p_arrow_r.ply", {"--size=64x48", "--eye=0,0,5"}},
        Mutant{"provoking", "p_dart.obj", {"--size=64x48", "--eye=0,0,5", "--shade=flat"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Mesh, ReversedZIsForMeshes) {
  EXPECT_TRUE(is_refused(pineda({"render", "grid", "--reverse-z"}), "expected no reversed z"));
}

}  // namespace
}  // namespace pineda::test
