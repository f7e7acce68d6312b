// Files and streams for the tests of scenes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace pineda::scene {

inline const spec::Contract kContract = spec::contract(spec::kHighTile);

/// A folder of its own for each test, removed with all it holds.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "scene_test-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) folder_ = name;
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      all.push_back(entry.path().filename().string());
    }
    return all;
  }

 private:
  std::filesystem::path folder_;
};

inline std::string read_all(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline std::vector<spec::Triangle> all_triangles(TriangleSource* source) {
  std::vector<spec::Triangle> all;
  for (spec::Triangle t; source->next(&t);) all.push_back(t);
  return all;
}

/// The message of the InputError that opening and reading the scene gives; "" if none.
inline std::string error_of(const std::string& name, const Options& options = {}) {
  try {
    const Scene scene = open_scene(kContract, name, options);
    all_triangles(scene.source.get());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Is `message` one line that holds `part`?
inline testing::AssertionResult is_one_line_with(const std::string& message,
                                                 const std::string& part) {
  if (message.find('\n') != std::string::npos) {
    return testing::AssertionFailure() << "more than one line: " << message;
  }
  if (part.empty() || message.find(part) == std::string::npos) {
    return testing::AssertionFailure() << "'" << message << "' does not hold '" << part << "'";
  }
  return testing::AssertionSuccess();
}

inline bool same(const spec::Triangle& a, const spec::Triangle& b) {
  for (size_t i = 0; i < 3; ++i) {
    if (a.v[i].x != b.v[i].x || a.v[i].y != b.v[i].y || a.v[i].z != b.v[i].z ||
        a.v[i].attr != b.v[i].attr) {
      return false;
    }
  }
  return a.id == b.id;
}

inline bool same(const std::vector<spec::Triangle>& a, const std::vector<spec::Triangle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return same(x, y); });
}

}  // namespace pineda::scene
