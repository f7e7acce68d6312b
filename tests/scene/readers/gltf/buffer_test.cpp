// Where the bytes of a glTF file's buffers come from.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "model/scene/readers/gltf/data_uri.h"
#include "model/scene/readers/gltf/reader.h"
#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

std::vector<Vec3> positions_of(const std::string& path) {
  std::vector<std::string> warnings;
  return read_gltf(path, &warnings).position;
}

const std::vector<Vec3> kExpected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(DataUri, Base64OfEveryLengthAndEveryByteIsReadWithPaddingAndWithout) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) {
    const std::string text = base64(bytes);
    std::optional<std::string> read;
    ASSERT_TRUE(read_data_uri("data:;base64," + text, &read));
    ASSERT_EQ(read, bytes) << i;
    ASSERT_TRUE(read_data_uri("data:;base64," + text.substr(0, text.find('=')), &read));
    ASSERT_EQ(read, bytes) << i;
    bytes.insert(bytes.begin(), static_cast<char>(i));
  }
}

TEST(DataUri, WhatIsNoBase64HasNoValue) {
  for (const char* text :
       {"A", "AAAAA", "AA*A", "AA A", "A=AA", "====", "AAAA\n", "\xff\xff\xff\xff"}) {
    std::optional<std::string> read = "something";
    EXPECT_TRUE(read_data_uri(std::string("data:;base64,") + text, &read));
    EXPECT_FALSE(read.has_value()) << text;
  }
  std::optional<std::string> read;
  EXPECT_TRUE(read_data_uri("data:;base64", &read));  // no comma
  EXPECT_FALSE(read.has_value());
  EXPECT_FALSE(read_data_uri("data.bin", &read));
  EXPECT_FALSE(read_data_uri("dat", &read));
}

TEST(DataUri, PercentsAreDecodedAndStrayOnesStay) {
  EXPECT_EQ(percent_decoded("a%20b%2Fc%2f"), "a b/c/");
  EXPECT_EQ(percent_decoded("100%"), "100%");
  EXPECT_EQ(percent_decoded("%4"), "%4");
  EXPECT_EQ(percent_decoded("%g0%0g%41"), "%g0%0gA");
  EXPECT_EQ(percent_decoded("a+b"), "a+b");
  std::optional<std::string> read;
  EXPECT_TRUE(read_data_uri("data:,a%00b", &read));
  EXPECT_EQ(read, std::string("a\0b", 3));
  EXPECT_TRUE(read_data_uri("data:;base64,QQ%3D%3D", &read));
  EXPECT_EQ(read, "A");
}

TEST(GltfBuffer, AnyMediaTypeIsTaken) {
  const Scratch scratch;
  const GltfFile file = one_triangle();
  for (const char* type :
       {"data:application/octet-stream;base64,", "data:application/gltf-buffer;base64,",
        "data:image/png;base64,", "data:;base64,", "data:text/plain;a=b;base64,",
        "data:model/vnd.unheard-of;base64,", "DATA:application/x;BASE64,"}) {
    EXPECT_EQ(positions_of(scratch.write("a.gltf", file.text(type + base64(file.bytes)))),
              kExpected)
        << type;
  }
}

TEST(GltfBuffer, WrongBase64IsRefusedWithoutShowingIt) {
  const Scratch scratch;
  const GltfFile file = one_triangle();
  const std::string text = base64(file.bytes);
  const auto message = [&](const std::string& data) {
    const auto path = scratch.write("a.gltf", file.text("data:application/unknown;base64," + data));
    const std::string error = error_of(path);
    EXPECT_EQ(error.find("AAAA"), std::string::npos) << error;
    return error;
  };
  EXPECT_EQ(message(text), "");
  EXPECT_TRUE(is_one_line_with(message(text + "*AAA"), "buffers[0].uri: expected base64 data"));
  EXPECT_TRUE(is_one_line_with(message(text.substr(0, 24)),
                               "buffers[0]: expected 36 bytes, as byteLength says, got 18"));
}

TEST(GltfBuffer, FilesStandBesideTheSceneByDecodedNames) {
  const Scratch scratch;
  const GltfFile file = one_triangle();
  std::filesystem::create_directory(scratch.path("some folder"));
  scratch.write("a.bin", file.bytes + "more than byteLength says");
  scratch.write("some folder/100% b.bin", file.bytes);
  for (const char* uri : {"a.bin", "./a.bin", "some%20folder/100%25%20b.bin",
                          "some folder/100% b.bin", "some%20folder/../a.bin"}) {
    EXPECT_EQ(positions_of(scratch.write("a.gltf", file.text(uri))), kExpected) << uri;
  }
}

TEST(GltfBuffer, APipeOfManyBlocksIsReadToItsEnd) {
  const Scratch scratch;
  GltfFile file = one_triangle();
  file.bytes += std::string(3 << 20, '\0');
  const auto pipe = scratch.path("pipe.glb");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << file.glb(); });
  EXPECT_EQ(positions_of(pipe), kExpected);
  writer.join();
}

TEST(GltfBuffer, WhatIsNoFileBesideTheSceneIsRefused) {
  const Scratch scratch;
  const GltfFile file = one_triangle();
  std::filesystem::create_directory(scratch.path("folder"));
  ASSERT_EQ(mkfifo(scratch.path("pipe").c_str(), 0600), 0);  // reading it would wait for ever
  scratch.write("a.bin", file.bytes);
  const auto message = [&](const std::string& uri) {
    return error_of(scratch.write("a.gltf", file.text(uri)));
  };
  for (const char* uri : {"none.bin", "folder", "pipe", "http://a/b.bin", "a.bin/", "~"}) {
    EXPECT_TRUE(is_one_line_with(message(uri), "buffers[0].uri: expected a file to read, got '"))
        << uri;
  }
  for (const auto& uri :
       {scratch.path("a.bin"), std::string("a.bin%00"), std::string("/dev/zero")}) {
    EXPECT_TRUE(is_one_line_with(message(uri), "buffers[0].uri: expected a path relative to"));
  }
}

TEST(GltfBuffer, ABufferThatNoTriangleNeedsMayBeMissing) {
  const Scratch scratch;
  GltfFile file = one_triangle();
  Json json = Json::parse(file.text());
  json["buffers"].push_back({{"byteLength", 2147483647}, {"uri", "none.bin"}});
  EXPECT_EQ(positions_of(scratch.write("a.gltf", json.dump())), kExpected);
  json["bufferViews"][0]["buffer"] = 1;
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("b.gltf", json.dump())), "buffers[1].uri"));
}

TEST(GltfBuffer, WithoutUriOnlyTheFirstOneIsTheChunk) {
  const Scratch scratch;
  GltfFile file = one_triangle();
  EXPECT_EQ(positions_of(scratch.write("a.glb", file.glb())), kExpected);
  Json json = Json::parse(file.text());
  json["buffers"][0].erase("uri");
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("a.gltf", json.dump())),
                               "buffers[0].uri: expected a URI, or a first buffer in the GLB's"));
  // A chunk of another type is no BIN.
  std::string glb = file.glb();
  glb.replace(glb.find(std::string("BIN\0", 4)), 4, "BIX");
  EXPECT_NE(error_of(scratch.write("b.glb", glb)), "");
}

TEST(GltfBuffer, AByteOrderMarkBeforeTheJsonIsNoTrouble) {
  const Scratch scratch;
  EXPECT_EQ(positions_of(scratch.write("a.gltf", "\xEF\xBB\xBF" + one_triangle().text())),
            kExpected);
}

}  // namespace
}  // namespace pineda::scene
