// Skipping in every kind of reader: the triangles after it are those that reading on would give.
#include <gtest/gtest.h>

#include "model/scene/resnap.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

void put(std::string* bytes, uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes->push_back(static_cast<char>(value >> 8 * i));
}

// Number i has its first corner at i/8 px. More than the reader's buffer.
constexpr uint32_t kTriangles = 5000;

std::string ptrb_bytes() {
  std::string bytes = "PTRB";
  for (const uint32_t word : {1u, 64u, 64u, 0u}) put(&bytes, word, 4);
  put(&bytes, kTriangles, 8);
  for (uint32_t i = 0; i < kTriangles; ++i) {
    for (uint32_t v = 0; v < 3; ++v) {
      for (const float value : {static_cast<float>(i + 40 * v) / 8, v == 2 ? 40.f : 0.f, .5f}) {
        uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        put(&bytes, bits, 4);
      }
      put(&bytes, 0, 4);
    }
  }
  return bytes;
}

std::string tri_text() {
  std::string text = "pineda-tri 1\nsize 64 64\n";
  for (int i = 0; i < 50; ++i) {
    const std::string x = std::to_string(i);
    for (const char* y : {"0", "9", "20"}) text += "v " + x + " " + y + " .5 1 0 0 0 255\n";
  }
  return text;
}

// Even steps read and odd ones skip.
void expect_same_as_reading(SnappedSource* source, const std::vector<uint64_t>& steps) {
  source->rewind();
  const auto all = all_triangles(source);
  source->rewind();
  uint64_t number = 0;  // the least that may come next
  size_t at = 0;
  for (size_t step = 0; step < steps.size(); ++step) {
    if (step % 2 == 1) {
      number = (at == 0 ? 0 : all[at - 1].id + 1) + steps[step];
      EXPECT_EQ(source->skip(steps[step]), steps[step]);
      while (at < all.size() && all[at].id < number) ++at;
      continue;
    }
    for (uint64_t i = 0; i < steps[step] && at < all.size(); ++i, ++at) {
      spec::Triangle got;
      ASSERT_TRUE(source->next(&got)) << step;
      ASSERT_EQ(got.id, all[at].id) << step;
      for (size_t v = 0; v < 3; ++v) ASSERT_EQ(got.v[v].x, all[at].v[v].x) << got.id;
    }
  }
  EXPECT_LT(at, all.size());
  EXPECT_LT(source->skip(uint64_t{1} << 40), uint64_t{1} << 40);
  spec::Triangle none;
  EXPECT_FALSE(source->next(&none));
}

TEST(Skip, OfAFileIsReadingOn) {
  const Scratch scratch;
  const Scene scene = open_scene(kContract, scratch.write("a.ptrb", ptrb_bytes()), {});
  EXPECT_EQ(scene.source->size(), kTriangles);
  // Within the buffer, to its end, beyond it, none.
  expect_same_as_reading(scene.source.get(), {3, 10, 1, 1010, 2, 1500, 7, 0, 5});
}

TEST(Skip, OfAPipeIsReadingOn) {
  std::istringstream pipe(ptrb_bytes());
  Options options;
  options.input = &pipe;
  const Scene scene = open_scene(kContract, "-", options);
  spec::Triangle triangle;
  ASSERT_TRUE(scene.source->next(&triangle));
  EXPECT_EQ(scene.source->skip(2998), 2998u);
  ASSERT_TRUE(scene.source->next(&triangle));
  EXPECT_EQ(triangle.id, 2999u);
  EXPECT_EQ(triangle.v[0].x, 2999 * 32);
}

TEST(Skip, OfAPipeThatEndsTooEarlyIsRefused) {
  std::istringstream pipe(ptrb_bytes().substr(0, 48 * 2000));
  Options options;
  options.input = &pipe;
  const Scene scene = open_scene(kContract, "-", options);
  scene.source->skip(3000);
  spec::Triangle triangle;
  EXPECT_THROW(scene.source->next(&triangle), InputError);
}

TEST(Skip, OfTextIsReadingOn) {
  const Scratch scratch;
  const Scene scene = open_scene(kContract, scratch.write("a.tri", tri_text()), {});
  EXPECT_EQ(scene.source->size(), std::nullopt);
  expect_same_as_reading(scene.source.get(), {3, 10, 1, 0, 2, 20, 1});
}

TEST(Skip, OfAListIsReadingOn) {
  const Scene scene = open_scene(kContract, "layers", {});
  EXPECT_EQ(scene.source->size(), all_triangles(scene.source.get()).size());
  expect_same_as_reading(scene.source.get(), {3, 10, 1, 0, 2, 100, 1});
}

// After one piece of a clipped triangle: its other pieces are skipped, too.
TEST(Skip, OfACutMeshLeavesOutPieces) {
  Options options;
  Camera camera;
  camera.eye = {0, 1, 2};
  options.camera = camera;
  options.tessellate = 6;
  const Scene scene = open_scene(kContract, "teapot", options);
  const auto all = all_triangles(scene.source.get());
  size_t piece = 1;
  while (piece < all.size() && all[piece].id != all[piece - 1].id) ++piece;
  ASSERT_LT(piece, all.size());
  expect_same_as_reading(scene.source.get(), {piece, 0, 5, 100, 5});
  Unsnapped unsnapped(scene.source.get());
  EXPECT_EQ(unsnapped.size(), scene.source->size());
  unsnapped.rewind();
  EXPECT_EQ(unsnapped.skip(7), 7u);
}

}  // namespace
}  // namespace pineda::scene
