// Bad input: exit 2, one line that names the file and the line, and nothing written.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

struct BadFile {
  std::string name;
  std::string file;
  std::string bytes;
  std::string says;  // part of the line on standard error
};
std::ostream& operator<<(std::ostream& to, const BadFile& bad) { return to << bad.name; }

const std::string kHead = "pineda-tri 1\nsize 8 8\n";
const std::string kTriangle = "v 0 0 0 1 1 2 3 4\nv 8 0 0 1 1 2 3 4\nv 0 8 0 1 1 2 3 4\n";

BadFile tri(const std::string& name, const std::string& text, int line) {
  return {name, "bad.tri", text, "bad.tri:" + std::to_string(line) + ": expected "};
}

/// A good scene whose last vertex is `v`.
BadFile vertex(const std::string& name, const std::string& v) {
  return tri(name, kHead + kTriangle + "v 0 0 0 1 1 2 3 4\n# a comment\n\n" + v + "\n" + kTriangle,
             9);
}

BadFile obj(const std::string& name, const std::string& face, int line) {
  return {name, "bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + face + "\n",
          "bad.obj:" + std::to_string(line) + ": expected "};
}

BadFile ply(const std::string& name, const std::string& face, int line) {
  return {name, "bad.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
          "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
          "0 0 0\n1 0 0\n0 1 0\n" +
              face,
          "bad.ply:" + std::to_string(line) + ": expected "};
}

BadFile gltf(const std::string& name, const std::string& rest, const std::string& says) {
  return {name, "bad.gltf", "{\"asset\": {\"version\": \"2.0\"}" + rest, "bad.gltf" + says};
}

std::vector<BadFile> text_files() {
  std::string late = kHead;
  for (int i = 0; i < 5000; ++i) late += kTriangle;
  return {
      tri("TriEmpty", "", 1),
      tri("TriOtherVersion", "pineda-tri 2\nsize 8 8\n", 1),
      tri("TriBlankAfterFirstLine", "pineda-tri 1 \nsize 8 8\n", 1),
      tri("TriStateFirst", "# c\nsize 8 8\npineda-tri 1\n", 2),
      tri("TriNoSize", "pineda-tri 1\n" + kTriangle, 2),
      tri("TriNothingElse", "pineda-tri 1\n", 1),
      tri("TriSizeTwice", kHead + "size 8 8\n" + kTriangle, 3),
      tri("TriCullTwice", kHead + "cull none\ncull none\n", 4),
      tri("TriDepthTwice", kHead + "depth off\ndepth off\n", 4),
      tri("TriStateAfterVertex", kHead + kTriangle + "cull none\n" + kTriangle, 6),
      tri("TriStateInsideTriangle", kHead + "v 0 0 0 1 1 2 3 4\ndepth off\n", 4),
      tri("TriSizeZero", "pineda-tri 1\nsize 0 8\n", 2),
      tri("TriSizeNegative", "pineda-tri 1\nsize 8 -8\n", 2),
      tri("TriSizeTooGreat", "pineda-tri 1\nsize 8 16385\n", 2),
      tri("TriSizeNoInteger", "pineda-tri 1\nsize 8.0 8\n", 2),
      tri("TriSizeOfOne", "pineda-tri 1\nsize 8\n", 2),
      tri("TriUnknownCull", kHead + "cull both\n", 3),
      tri("TriUnknownDepth", kHead + "depth nearer\n", 3),
      tri("TriUnknownState", kHead + "fog on\n", 3),
      tri("TriScissorNegative", kHead + "scissor -1 0 -4 4\n", 3),
      tri("TriScissorTwice", kHead + "scissor 0 0 4 4\nscissor 0 0 4 4\n", 4),
      tri("TriUnknownDepthWrite", kHead + "depthwrite 1\n", 3),
      tri("TriBiasNotWhole", kHead + "depthbias 1e3 0\n", 3),
      tri("TriBiasTooFar", kHead + "depthbias 16777216 0\n", 3),
      tri("TriBiasTooSteep", kHead + "depthbias 0 128\n", 3),
      tri("TriBiasAfterVertex", kHead + kTriangle + "depthbias 0 0\n", 6),
      tri("TriClearDepthTooGreat", kHead + "cleardepth 1.1\n", 3),
      tri("TriClearDepthNan", kHead + "cleardepth nan\n", 3),
      tri("TriClearDepthTwice", kHead + "cleardepth 0\ncleardepth 0\n", 4),
      tri("TriUnknownShade", kHead + "shade phong\n", 3),
      tri("TriTwoVertices", kHead + "v 0 0 0 1 1 2 3 4\nv 0 1 0 1 1 2 3 4\n", 4),
      tri("TriLateLine", late + "v 0 0\n", 15003),
      vertex("VertexOfSeven", "v 0 0 0 1 1 2 3"),
      vertex("VertexOfNine", "v 0 0 0 1 1 2 3 4 5"),
      vertex("VertexNoNumber", "v 0 0x 0 1 1 2 3 4"),
      vertex("VertexNoKeyword", "0 0 0 1 1 2 3 4"),
      vertex("VertexUnknown", "w 0 0 0 1 1 2 3 4"),
      vertex("ColorTooGreat", "v 0 0 0 1 256 2 3 4"),
      vertex("ColorNegative", "v 0 0 0 1 -1 2 3 4"),
      vertex("ColorNoInteger", "v 0 0 0 1 1. 2 3 4"),
      vertex("WZero", "v 0 0 0 0 1 2 3 4"),
      vertex("WMinusZero", "v 0 0 0 -0 1 2 3 4"),
      vertex("WNegative", "v 0 0 0 -1 1 2 3 4"),
      vertex("WDenormal", "v 0 0 0 1e-40 1 2 3 4"),
      vertex("WInfinite", "v 0 0 0 inf 1 2 3 4"),
      vertex("WOverflows", "v 0 0 0 1e99 1 2 3 4"),
      ply("PlyIndexTooGreat", "3 0 1 3\n", 13),
      ply("PlyFaceOfTwo", "2 0 1\n", 13),
      ply("PlyFaceMissing", "", 12),
      gltf("GltfNoJson", ",\n", ":2: expected JSON"),
      gltf("GltfEmpty", "}", ": expected triangles, got none"),
      gltf("GltfCycle", ", \"nodes\": [{\"children\": [1]}, {\"children\": [1]}]}",
           ": nodes[1]: expected a tree"),
      gltf("GltfExtension", ", \"extensionsRequired\": [\"KHR_draco_mesh_compression\"]}",
           ": extensionsRequired: expected none that changes what is drawn, got 'KHR_draco_mesh"),
      {"GlbCut", "bad.glb", "glTF", "bad.glb: expected the header of a GLB"},
      obj("ObjIndexTooGreat", "f 1 2 4", 5),
      obj("ObjIndexZero", "f 0 1 2", 5),
      obj("ObjIndexTooNegative", "f -4 -1 -2", 5),
      obj("ObjFaceOfTwo", "f 1 2", 5),
      obj("ObjNoNumber", "v 0 zero 0", 5)};
}

std::string put(std::string bytes, size_t at, uint32_t value) {
  for (size_t i = 0; i < 4; ++i) bytes.at(at + i) = static_cast<char>(value >> 8 * i & 0xff);
  return bytes;
}

uint32_t bits_of(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

std::vector<BadFile> binary_files() {
  const Scene scene = pile(8, 8, 3000, 61);
  const std::string good = ptrb_bytes(scene);
  const std::string with_w = ptrb_bytes(scene, true);
  const size_t late_w = 28 + 2500 * 60 + 20 + 12;  // of the second vertex of triangle 2500
  std::vector<BadFile> files;
  const auto add = [&](const std::string& name, const std::string& bytes,
                       const std::string& says = "expected ") {
    files.push_back({"Ptrb" + name, "bad.ptrb", bytes, says});
  };
  add("Empty", "");
  add("ShortHeader", good.substr(0, 27));
  add("OtherMagic", "BTRP" + good.substr(4));
  add("OtherVersion", put(good, 4, 2), "version 1");
  add("WidthZero", put(good, 8, 0), "0x8");
  add("WidthTooGreat", put(good, 8, 16385), "16385x8");
  add("HeightNegative", put(good, 12, 0xffffffff));
  add("CullThree", put(good, 16, 3 << 1), "flags");
  add("DepthThree", put(good, 16, 3 << 3), "flags");
  add("UnknownFlag", put(good, 16, 1 << 5), "flags");
  add("OneTriangleMissing", put(good, 20, 3001), "3001 triangles");
  add("OneTriangleMore", put(good, 20, 2999), "2999 triangles");
  add("OneByteMissing", good.substr(0, good.size() - 1), "3000 triangles");
  add("OneByteMore", good + "x", "3000 triangles");
  add("CountOverflows", put(put(good, 20, 0xffffffff), 24, 0xffffffff), "triangles");
  add("WZero", put(with_w, late_w, bits_of(0)), "triangle 2500 vertex 1");
  add("WNegative", put(with_w, late_w, bits_of(-1)), "triangle 2500 vertex 1");
  add("WDenormal", put(with_w, late_w, 1), "triangle 2500 vertex 1");
  add("WInfinite", put(with_w, late_w, bits_of(std::numeric_limits<float>::infinity())),
      "triangle 2500 vertex 1");
  return files;
}

/// Everything a command may write, into folders that hold something older.
Arguments with_outputs(const std::string& command, const std::string& scene) {
  Arguments arguments{command, scene, "--json", "figures.json"};
  if (command != "time") arguments.insert(arguments.end(), {"-o", "out"});
  if (command == "render" || command == "rtl") {
    arguments.insert(arguments.end(), {"--dump", "dump"});
  }
  if (command == "rtl") arguments.insert(arguments.end(), {"--trace", "wave.fst"});
  return arguments;
}

class BadInput : public testing::TestWithParam<BadFile> {
 protected:
  void make_older_files() const {
    for (const char* name : {"figures.json", "out/color.png", "dump/depth.u32", "wave.fst"}) {
      scratch_.write(name, "older");
    }
  }
  void expect_older_files_only(const std::string& command) {
    EXPECT_EQ(scratch_.files(), (Arguments{"dump/depth.u32", "figures.json", "out/color.png",
                                           "scene/" + GetParam().file, "wave.fst"}))
        << command;
    for (const char* name : {"figures.json", "out/color.png", "dump/depth.u32", "wave.fst"}) {
      EXPECT_EQ(read_bytes(scratch_.path(name)), "older") << command << " " << name;
    }
  }

  Scratch scratch_;
};

TEST_P(BadInput, IsRefusedInOneLineAndNothingIsWritten) {
  const std::string file = "scene/" + GetParam().file;
  scratch_.write(file, GetParam().bytes);
  make_older_files();
  for (const auto& command : kSceneCommands) {
    const Outcome run = pineda(with_outputs(command, file), inside(scratch_.path(".")));
    EXPECT_TRUE(is_refused(run, file)) << command;
    EXPECT_TRUE(is_refused(run, GetParam().says)) << command;
    expect_older_files_only(command);
  }
}

TEST_P(BadInput, LeavesNoNewFolder) {
  const std::string file = scratch_.write(GetParam().file, GetParam().bytes);
  for (const auto& command : kSceneCommands) {
    EXPECT_EQ(pineda(with_outputs(command, file), inside(scratch_.path("."))).exit_code, 2);
    EXPECT_EQ(scratch_.files(), Arguments{GetParam().file}) << command;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path("out"))) << command;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path("dump"))) << command;
  }
}

INSTANTIATE_TEST_SUITE_P(Text, BadInput, testing::ValuesIn(text_files()),
                         [](const auto& param) { return param.param.name; });
INSTANTIATE_TEST_SUITE_P(Binary, BadInput, testing::ValuesIn(binary_files()),
                         [](const auto& param) { return param.param.name; });

class BadStream : public testing::TestWithParam<BadFile> {};

TEST_P(BadStream, IsRefusedInOneLineAndNothingIsWritten) {
  for (const auto& command : kSceneCommands) {
    const Scratch scratch;
    Surroundings piped = inside(scratch.path("."));
    piped.input = GetParam().bytes;
    const Outcome run = pineda(with_outputs(command, "-"), piped);
    EXPECT_TRUE(is_refused(run, "standard input")) << command;
    EXPECT_EQ(scratch.files(), Arguments{}) << command;
    // A refused stream must be refused for its content, not for being a pipe.
    EXPECT_EQ(run.err.find("pipe"), std::string::npos) << command << ": " << run.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Binary, BadStream, testing::ValuesIn(binary_files()),
                         [](const auto& param) { return param.param.name; });

TEST(MissingFile, IsNamedInOneLine) {
  const Scratch scratch;
  for (const auto& command : kSceneCommands) {
    for (const char* name :
         {"none.tri", "none.ptrb", "none.obj", "none.ply", "none.glb", "no/such/folder.tri"}) {
      const Outcome run = pineda(with_outputs(command, name), inside(scratch.path(".")));
      EXPECT_TRUE(is_refused(run, name)) << command;
      EXPECT_EQ(scratch.files(), Arguments{}) << command;
    }
  }
}

TEST(FolderAsScene, IsRefused) {
  const Scratch scratch;
  for (const char* name :
       {"folder.tri", "folder.ptrb", "folder.obj", "folder.ply", "folder.gltf"}) {
    std::filesystem::create_directory(scratch.path(name));
    EXPECT_TRUE(is_refused(pineda({"render", scratch.path(name)}), name));
  }
}

/// NaN, infinities, denormals and depths out of range are input like any other: counted.
TEST(OddNumbers, AreCountedAndSaid) {
  const Scratch scratch;
  const std::string v = " 1 1 2 3 4\n";
  const std::string rest = "v 8 0 0" + v + "v 0 8 0" + v;
  const std::string file =
      scratch.write("odd.tri", kHead + "v nan 0 0" + v + rest + "v 0 nan 0" + v + rest +
                                   "v 0 0 nan" + v + rest + "v 0 0 0 nan 1 2 3 4\n" + rest +
                                   "v inf -inf 0" + v + rest + "v 0 1e-40 -1e-41" + v + rest +
                                   "v 0 0 1.5" + v + "v 8 0 -inf" + v + "v 0 8 1" + v);
  for (const auto& command : kSceneCommands) {
    const Outcome run = pineda({command, file, "--json", "-", "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find("4 triangles dropped"), std::string::npos) << run.err;
    const Json json = run.json();
    EXPECT_EQ(json.at("triangles"), 7) << command;
    const Json& input = json.at("input");
    EXPECT_EQ(input.at("nan_dropped"), 4) << command;
    EXPECT_EQ(input.at("saturated"), 2) << command;
    EXPECT_EQ(input.at("denormals"), 2) << command;
    EXPECT_EQ(input.at("z_clamped"), 2) << command;
  }
}

}  // namespace
}  // namespace pineda::test
