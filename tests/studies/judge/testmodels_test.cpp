// Debian's assimp-testmodels, which are hard to read: each is drawn right or refused in one line,
// and has as many triangles as assimp finds in it, or the table says why not.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "model/scene/error.h"
#include "studies/judge/front_end.h"
#include "studies/judge/scene_truth.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = "/usr/share/assimp/models";
constexpr const char* kRefused = "refused";

/// A line of testmodels.tsv.
struct Row {
  std::string ours;               // triangles, or "refused"
  std::set<std::string> assimps;  // the same, one for each version of assimp that differs
  std::string why;                // why they differ
};

std::map<std::string, Row> table() {
  std::map<std::string, Row> rows;
  std::ifstream file(PINEDA_TESTMODELS);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string path, assimps;
    Row row;
    std::getline(words, path, '\t');
    std::getline(words, row.ours, '\t');
    std::getline(words, assimps, '\t');
    std::getline(words, row.why, '\t');
    std::istringstream versions(assimps);
    for (std::string one; std::getline(versions, one, '|');) row.assimps.insert(one);
    rows[path] = row;
  }
  return rows;
}

/// All files in a format that we read, by their paths from kModels.
std::vector<std::string> models() {
  std::vector<std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(kModels)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".obj" || ending == ".ply" || ending == ".gltf" || ending == ".glb") {
      all.push_back(fs::relative(entry.path(), kModels).string());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// The number of triangles, or "refused"; the picture is judged.
std::string drawn(const std::string& path) {
  const auto contract = spec::contract(spec::kHighTile);
  scene::Options options;
  options.size = scene::Size{96, 72};
  try {
    const scene::Scene scene = scene::open_scene(contract, path, options);
    std::vector<SceneTriangle> pieces;
    for (SceneTriangle t; scene.source->next(&t.snapped); pieces.push_back(t)) {
      t.screen = stated(scene.source->screen());
    }
    const auto found = judge_front_end(*scene.mesh, scene.frame, pieces, contract.design);
    EXPECT_TRUE(found.holds()) << path << ": " << found.first->what;
    return std::to_string(scene.mesh->triangle.size());
  } catch (const scene::InputError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    EXPECT_EQ(line.find(path), 0u) << line;
    return kRefused;
  }
}

/// What `assimp info` counts after cutting polygons into triangles.
std::string counted_by_assimp(const std::string& path) {
  const std::string command = "assimp info '" + path + "' 2>/dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string faces = kRefused;
  std::array<char, 512> line{};
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
    std::istringstream words(line.data());
    std::string name, value;
    words >> name >> value;
    if (name == "Faces:") faces = value;
  }
  pclose(pipe);
  return faces;
}

TEST(TestModels, EachIsDrawnRightOrRefusedInOneLine) {
  if (!fs::exists(kModels)) GTEST_SKIP() << "Debian's assimp-testmodels is not here";
  const auto rows = table();
  const auto all = models();
  EXPECT_GT(all.size(), 80u);
  for (const std::string& model : all) {
    const std::string found = drawn((kModels / model).string());
    const auto row = rows.find(model);
    ASSERT_NE(row, rows.end()) << "testmodels.tsv has no line for\n" << model << "\t" << found;
    EXPECT_EQ(found, row->second.ours) << model;
  }
}

TEST(TestModels, AssimpCountsTheSameTrianglesOrTheTableSaysWhyNot) {
  if (!fs::exists(kModels)) GTEST_SKIP() << "Debian's assimp-testmodels is not here";
  if (std::system("command -v assimp >/dev/null") != 0) GTEST_SKIP() << "no assimp here";
  const auto rows = table();
  for (const std::string& model : models()) {
    const auto row = rows.find(model);
    ASSERT_NE(row, rows.end()) << model;
    const std::string counted = counted_by_assimp((kModels / model).string());
    EXPECT_EQ(row->second.assimps.count(counted), 1u) << model << ": " << counted;
    EXPECT_TRUE(counted == row->second.ours || !row->second.why.empty())
        << model << ": " << counted << ", not " << row->second.ours << ", and no word about it";
  }
}

}  // namespace
}  // namespace pineda::studies
