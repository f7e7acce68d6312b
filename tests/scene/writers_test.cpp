#include "model/scene/writers.h"

#include <gtest/gtest.h>
#include <png.h>

#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

// 3 x 2 samples; the second is cleared.
Frame small_frame() {
  Frame frame;
  frame.width = 3;
  frame.height = 2;
  frame.depth = {100, 0xffffff, 200, 300, 0x123456, 100};
  frame.hits = {1, 0, 2, 65535, 1, 1};
  for (uint16_t i = 0; i < 24; ++i) {
    frame.color.push_back(i / 4 == 1 ? uint16_t{0} : static_cast<uint16_t>(i * 10));
  }
  return frame;
}

std::vector<uint8_t> pixels_of(const std::string& path, uint32_t format) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.height, 2u);
  EXPECT_EQ(image.format, format);
  std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  return pixels;
}

TEST(Writers, ColorPictureHoldsRedGreenAndBlueOnBlack) {
  const Scratch scratch;
  write_color_png(scratch.path("color.png"), small_frame());
  EXPECT_EQ(pixels_of(scratch.path("color.png"), PNG_FORMAT_RGB),
            (std::vector<uint8_t>{0, 10, 20, 0, 0, 0, 80, 90, 100, 120, 130, 140, 160, 170, 180,
                                  200, 210, 220}));
}

TEST(Writers, PlainPictureHoldsItsBytesAndRefusesAnotherSize) {
  const Scratch scratch;
  std::vector<uint8_t> rgb;
  for (uint8_t i = 0; i < 18; ++i) rgb.push_back(static_cast<uint8_t>(i * 14));
  write_rgb_png(scratch.path("map.png"), 3, 2, rgb);
  EXPECT_EQ(pixels_of(scratch.path("map.png"), PNG_FORMAT_RGB), rgb);
  EXPECT_EQ(scratch.names(), std::vector<std::string>{"map.png"});
  rgb.pop_back();
  EXPECT_THROW(write_rgb_png(scratch.path("short.png"), 3, 2, rgb), std::invalid_argument);
  EXPECT_EQ(scratch.names(), std::vector<std::string>{"map.png"});
}

TEST(Writers, DepthPictureIsBrightWhereNearAndBlackWhereCleared) {
  const Scratch scratch;
  auto frame = small_frame();
  frame.depth = {100, 0xffffff, 200, 300, 200, 100};
  write_depth_png(scratch.path("depth.png"), frame);
  EXPECT_EQ(pixels_of(scratch.path("depth.png"), PNG_FORMAT_GRAY),
            (std::vector<uint8_t>{255, 0, 148, 40, 148, 255}));
}

TEST(Writers, DepthPictureOfReversedZIsBrightWhereTheCodeIsGreat) {
  const Scratch scratch;
  auto frame = small_frame();
  frame.clear_depth = 0;
  frame.depth = {100, 0, 200, 300, 200, 100};
  write_depth_png(scratch.path("reversed.png"), frame);
  EXPECT_EQ(pixels_of(scratch.path("reversed.png"), PNG_FORMAT_GRAY),
            (std::vector<uint8_t>{40, 0, 148, 255, 148, 40}));
  frame.clear_depth = 200;  // on both sides of it
  write_depth_png(scratch.path("middle.png"), frame);
  EXPECT_EQ(pixels_of(scratch.path("middle.png"), PNG_FORMAT_GRAY),
            (std::vector<uint8_t>{184, 255, 0, 40, 0, 184}));
  frame.depth.assign(6, 200);
  write_depth_png(scratch.path("none.png"), frame);
  EXPECT_EQ(pixels_of(scratch.path("none.png"), PNG_FORMAT_GRAY), std::vector<uint8_t>(6));
}

TEST(Writers, DepthPictureOfOneDepthOrNoneIsWhiteOrBlack) {
  const Scratch scratch;
  auto frame = small_frame();
  frame.depth = {7, 0xffffff, 7, 7, 7, 7};
  write_depth_png(scratch.path("one.png"), frame);
  EXPECT_EQ(pixels_of(scratch.path("one.png"), PNG_FORMAT_GRAY),
            (std::vector<uint8_t>{255, 0, 255, 255, 255, 255}));
  frame.depth.assign(6, 0xffffff);
  write_depth_png(scratch.path("none.png"), frame);
  EXPECT_EQ(pixels_of(scratch.path("none.png"), PNG_FORMAT_GRAY), std::vector<uint8_t>(6));
}

TEST(Writers, DumpIsLittleEndianRowMajor) {
  const Scratch scratch;
  const auto folder = scratch.path("deep/dump");
  write_dump(folder, small_frame());
  EXPECT_EQ(read_all(folder + "/hits.u16"), std::string("\1\0\0\0\2\0\xff\xff\1\0\1\0", 12));
  const auto depth = read_all(folder + "/depth.u32");
  ASSERT_EQ(depth.size(), 24u);
  EXPECT_EQ(depth.substr(4, 4), std::string("\xff\xff\xff\0", 4));
  EXPECT_EQ(depth.substr(16, 4), std::string("\x56\x34\x12\0", 4));
  const auto color = read_all(folder + "/color.rgba");
  ASSERT_EQ(color.size(), 24u);
  EXPECT_EQ(color.substr(0, 8), std::string("\0\x0a\x14\x1e\0\0\0\0", 8));
}

TEST(Writers, MissingChannelsAndOtherWidthsBecomeFourBytes) {
  const Scratch scratch;
  auto frame = small_frame();
  frame.attributes = 1;
  frame.attribute_bits = 16;
  frame.color = {0, 65535, 32896, 257, 128, 129};
  write_dump(scratch.path("dump"), frame);
  EXPECT_EQ(read_all(scratch.path("dump") + "/color.rgba"),
            std::string("\0\0\0\xff\xff\0\0\xff\x80\0\0\xff\1\0\0\xff\0\0\0\xff\1\0\0\xff", 24));
}

TEST(Writers, UnknownHitsRemoveAnOlderFile) {
  const Scratch scratch;
  auto frame = small_frame();
  write_dump(scratch.path("dump"), frame);
  frame.hits.clear();
  write_dump(scratch.path("dump"), frame);
  EXPECT_FALSE(std::filesystem::exists(scratch.path("dump") + "/hits.u16"));
  EXPECT_TRUE(std::filesystem::exists(scratch.path("dump") + "/depth.u32"));
}

TEST(Writers, FailureLeavesNothingBehindAndSaysWhy) {
  const Scratch scratch;
  // A folder with something in it stands where the file should go.
  std::filesystem::create_directories(scratch.path("color.png/inside"));
  try {
    write_color_png(scratch.path("color.png"), small_frame());
    FAIL() << "wrote over a folder";
  } catch (const InputError& error) {
    EXPECT_TRUE(is_one_line_with(error.what(), scratch.path("color.png") + ": expected to write"));
  }
  EXPECT_EQ(scratch.names(), std::vector<std::string>{"color.png"});

  scratch.write("file", "old");
  EXPECT_THROW(write_dump(scratch.path("file"), small_frame()), InputError);
  EXPECT_EQ(read_all(scratch.path("file")), "old");
}

TEST(Writers, AnOlderFileIsReplaced) {
  const Scratch scratch;
  scratch.write("file", "a longer older text");
  write_file(scratch.path("file"), "new");
  EXPECT_EQ(read_all(scratch.path("file")), "new");
  EXPECT_EQ(scratch.names(), std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace pineda::scene
