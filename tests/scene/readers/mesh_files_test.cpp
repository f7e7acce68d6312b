// One mesh in every format of a mesh gives the same triangles.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "model/scene/builtin/builtin.h"
#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

struct Bytes {
  const char* name;
  std::string bytes;
};

// Coordinates rounded so that float and text are the same.
Mesh rounded(Mesh mesh) {
  for (Vec3& p : mesh.position) {
    for (double& x : p) x = static_cast<float>(x);
  }
  return mesh;
}

std::string obj(const Mesh& mesh) {
  std::string text;
  for (size_t i = 0; i < mesh.position.size(); ++i) {
    const Vec3& p = mesh.position[i];
    text += fmt::format("v {:.9g} {:.9g} {:.9g}", p[0], p[1], p[2]);
    if (!mesh.color.empty()) {
      const Rgba& c = mesh.color[i];
      text += fmt::format(" {} {} {}", c[0] / 255, c[1] / 255, c[2] / 255);
    }
    text += "\n";
  }
  for (const auto& t : mesh.triangle)
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string ply(const Mesh& mesh, bool ascii) {
  std::string file = fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\n{}element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      ascii ? "ascii" : "binary_little_endian", mesh.position.size(),
      mesh.color.empty() ? "" : "property uchar red\nproperty uchar green\nproperty uchar blue\n",
      mesh.triangle.size());
  const auto put = [&](auto value) {
    file += ascii ? fmt::format("{:.9g} ", static_cast<double>(value))
                  : packed<decltype(value)>({value});
  };
  const auto end_line = [&] {
    if (ascii) file += "\n";
  };
  for (size_t i = 0; i < mesh.position.size(); ++i) {
    for (const double x : mesh.position[i]) put(static_cast<float>(x));
    for (size_t k = 0; k < 3 && !mesh.color.empty(); ++k) put(mesh.color[i][k]);
    end_line();
  }
  for (const auto& t : mesh.triangle) {
    put(uint8_t{3});
    for (const uint32_t i : t) put(i);
    end_line();
  }
  return file;
}

GltfFile gltf(const Mesh& mesh) {
  GltfFile file;
  std::vector<float> positions;
  std::vector<uint8_t> colors;
  std::vector<uint32_t> indices;
  for (const Vec3& p : mesh.position) {
    for (const double x : p) positions.push_back(static_cast<float>(x));
  }
  for (const Rgba& c : mesh.color) colors.insert(colors.end(), c.begin(), c.end());
  for (const auto& t : mesh.triangle) indices.insert(indices.end(), t.begin(), t.end());
  Json& primitive = file.mesh({{"POSITION", file.vectors(positions)}});
  primitive["indices"] = file.accessor(kU32, "SCALAR", indices.size(), packed(indices));
  if (!colors.empty()) {
    primitive["attributes"]["COLOR_0"] =
        file.accessor(kU8, "VEC4", mesh.color.size(), packed(colors), true);
  }
  return file;
}

void expect_same(const Mesh& mesh) {
  const Scratch scratch;
  const std::vector<Bytes> files = {{"a.obj", obj(mesh)},
                                    {"ascii.ply", ply(mesh, true)},
                                    {"binary.ply", ply(mesh, false)},
                                    {"a.gltf", gltf(mesh).text()},
                                    {"a.glb", gltf(mesh).glb()}};
  const auto triangles = [&](const Bytes& file) {
    const auto scene = open_scene(kContract, scratch.write(file.name, file.bytes), {});
    EXPECT_TRUE(scene.warnings.empty()) << file.name;
    return all_triangles(scene.source.get());
  };
  const auto expected = triangles(files[0]);
  ASSERT_EQ(expected.size(), mesh.triangle.size());
  for (const Bytes& file : files) EXPECT_TRUE(same(expected, triangles(file))) << file.name;

  // The mutant: one triangle turned in one file must not pass.
  Mesh mutant = mesh;
  std::swap(mutant.triangle.back()[0], mutant.triangle.back()[1]);
  EXPECT_FALSE(same(expected, triangles({"mutant.glb", gltf(mutant).glb()})));
}

TEST(MeshFiles, ShadedMeshIsTheSameInEveryFormat) { expect_same(rounded(teapot(2))); }

// Colours of 0 and 255 only, which are the same in linear and sRGB encoding.
TEST(MeshFiles, ColouredMeshIsTheSameInEveryFormat) {
  Mesh mesh = rounded(teapot(2));
  const auto bit = [](size_t i, int k) { return static_cast<uint8_t>(i >> k & 1 ? 255 : 0); };
  for (size_t i = 0; i < mesh.position.size(); ++i) {
    mesh.color.push_back({bit(i, 0), bit(i, 1), bit(i, 2), 255});
  }
  expect_same(mesh);
}

}  // namespace
}  // namespace pineda::scene
