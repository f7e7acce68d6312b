// pineda time --sample: figures, refusals, short scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/program.h"
#include "tests/cli/scene_file.h"

namespace pineda::test {
namespace {

// Long enough to be sampled; the triangles grow along it.
Scene long_scene() {
  Random random(1);
  Scene scene;
  for (int i = 0; i < 20'000; ++i) {
    const float side = 2 + static_cast<float>(i) / 4000;
    const float x = random.uniform(0.f, 50.f);
    const float y = random.uniform(0.f, 40.f);
    Triangle triangle;
    triangle[0] = random.vertex(x, y);
    triangle[1] = random.vertex(x + side, y);
    triangle[2] = random.vertex(x, y + side);
    scene.triangles.push_back(triangle);
  }
  return scene;
}

// The same where every sample is written: what passes a depth test depends on triangles that a sample
// leaves out.
Scene long_scene_all_written() {
  Scene scene = long_scene();
  scene.depth = Depth::kLequal;
  for (Triangle& triangle : scene.triangles) {
    for (Vertex& vertex : triangle) vertex.z = .5f;
  }
  return scene;
}

// `more`: what else the command line says.
void expect_near_the_full_run(const Scene& scene, const std::string& option,
                              const Arguments& more) {
  const Scratch scratch;
  Arguments whole{"time", scratch.write("long.ptrb", ptrb_bytes(scene))};
  whole.insert(whole.end(), more.begin(), more.end());
  Arguments sample = whole;
  sample.push_back(option);
  const Json full = figures(whole);
  const Json sampled = figures(sample);
  const auto cycles = full.at("drained").get<double>();
  EXPECT_NEAR(sampled.at("drained").get<double>(), cycles, .03 * cycles);
  EXPECT_LE(sampled.at("drained_low"), full.at("drained"));
  EXPECT_GE(sampled.at("drained_high"), full.at("drained"));
  EXPECT_LT(sampled.at("drained_low"), sampled.at("drained_high"));
  EXPECT_LE(sampled.at("windows_wanted"), sampled.at("windows"));
  for (const char* same : {"triangles", "memory", "depth_latency_cycles"}) {
    EXPECT_EQ(sampled.at(same), full.at(same)) << same;
  }
  EXPECT_GE(sampled.at("windows"), 30);
  for (const char* partial : {"cycles", "counters", "units", "fifos", "input", "dram"}) {
    EXPECT_FALSE(sampled.contains(partial)) << partial;
  }
}

TEST(Sample, SaysWhatTheFullRunTakes) {
  expect_near_the_full_run(long_scene(), "--sample", {"--bench", "2"});
}

TEST(Sample, SaysWhatTheFullRunTakesBehindDram) {
  expect_near_the_full_run(long_scene_all_written(), "--sample=.45", {"--memory", "dram"});
}

TEST(Sample, SaysWhatTheFullRunTakesWithStalls) {
  expect_near_the_full_run(long_scene_all_written(), "--sample=.45",
                           {"--stall", "both", "--latency", "20", "--seed", "1"});
}

TEST(Sample, ShareAndSeedCount) {
  const Scratch scratch;
  const auto path = scratch.write("long.ptrb", ptrb_bytes(long_scene()));
  const Json once = figures({"time", path, "--sample=.4"});
  EXPECT_NEAR(once.at("simulated_triangles").get<double>(), 8000, 400);
  EXPECT_NE(figures({"time", path, "--sample=.4", "--seed", "1"}).at("drained"),
            once.at("drained"));
  EXPECT_EQ(figures({"time", path, "--sample=.4"}).at("drained"), once.at("drained"));
}

TEST(Sample, PipeAndTextAreTheFile) {
  const Scratch scratch;
  const Scene scene = long_scene();
  const auto expected =
      figures({"time", scratch.write("long.ptrb", ptrb_bytes(scene)), "--sample"}).at("drained");
  Surroundings pipe;
  pipe.input = ptrb_bytes(scene);
  EXPECT_EQ(figures({"time", "-", "--sample"}, pipe).at("drained"), expected);
  const auto text = scratch.write("long.tri", tri_text(scene));
  EXPECT_EQ(figures({"time", text, "--sample"}).at("drained"), expected);
}

TEST(Sample, PrintsTheInterval) {
  const Scratch scratch;
  const auto run =
      pineda({"time", scratch.write("long.ptrb", ptrb_bytes(long_scene())), "--sample"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("(95 %, 30 windows of 64 triangles, 9.6 % of the stream)"),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("left out"), std::string::npos);
}

TEST(Sample, ShortSceneIsRunWhole) {
  const auto run = pineda({"time", "triangle", "--sample", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("so all are run"), std::string::npos) << run.err;
  const Json sampled = Json::parse(run.out);
  const Json full = figures({"time", "triangle"});
  EXPECT_EQ(sampled.at("cycles"), full.at("cycles"));
  EXPECT_EQ(sampled.at("drained_low"), full.at("drained"));
  EXPECT_EQ(sampled.at("drained_high"), full.at("drained"));
  EXPECT_EQ(sampled.at("sampled_triangles"), 1);
  EXPECT_EQ(sampled.at("windows"), 1);
}

TEST(Sample, WhatWantsEveryTriangleIsRefused) {
  const Scratch scratch;
  const std::vector<Arguments> wants = {{"--bits"},
                                        {"--timeline", scratch.path("a.json")},
                                        {"--trace", scratch.path("a.vcd")},
                                        {"--heat-map", scratch.path("a.png")}};
  for (const auto& more : wants) {
    Arguments arguments{"time", "triangle", "--sample"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_TRUE(is_refused(pineda(arguments), "--sample"));
  }
}

TEST(Sample, ShareThatIsNoneIsRefused) {
  for (const char* share : {"0", "2", "-1", "nan", "half"}) {
    const std::string option = std::string("--sample=") + share;
    EXPECT_TRUE(is_refused(pineda({"time", "triangle", option}), "--sample")) << share;
  }
}

TEST(Sample, FewLargeTrianglesAreSaidToBeTooFew) {
  const Arguments from_within{"time", "teapot", "--tessellate", "40", "--eye", "0,1,2"};
  Arguments sample = from_within;
  sample.emplace_back("--sample");
  const auto run = pineda(sample);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("for the interval to hold"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find(" or more (too few: 30 windows of 64"), std::string::npos) << run.out;
  const Json json = figures(sample);
  EXPECT_GT(json.at("windows_wanted"), json.at("windows"));
}

TEST(Sample, HierarchicalZIsRefused) {
  const Scratch scratch;
  const auto design = scratch.write("hz.toml", "hierarchical_z = true\n");
  EXPECT_TRUE(
      is_refused(pineda({"time", "triangle", "--sample", "--design", design}), "hierarchical z"));
}

}  // namespace
}  // namespace pineda::test
