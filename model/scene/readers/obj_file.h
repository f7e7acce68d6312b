// Parses the statements of a Wavefront .obj file; obj_reader makes the mesh from them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/readers/lines.h"

namespace pineda::scene {

struct ObjCorner {
  static constexpr uint32_t kNoNormal = UINT32_MAX;
  uint32_t vertex = 0;
  uint32_t normal = kNoNormal;
};

/// The contents of a file. Indices are checked and count from 0.
struct ObjStatements {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;  // as stated, so of any length, or not finite
  std::vector<Rgba> color;   // of the vertices that have one
  std::vector<ObjCorner> corner;
  std::vector<uint32_t> corners;  // number of corners of each face, in order

  uint64_t missing_normals = 0;  // corners with an invalid normal index
  uint64_t points = 0, lines = 0, surfaces = 0, materials = 0;
  uint64_t unknown = 0;  // lines
  uint64_t first_unknown_line = 0;
  std::string first_unknown;  // its keyword
};

/// Reads a file, once. For errors see read_obj().
class ObjFile {
 public:
  explicit ObjFile(const std::string& file);
  ObjStatements read();

 private:
  // The greatest index used by a face, and its line.
  struct Greatest {
    int64_t index = 0;
    uint64_t line = 0;
  };

  void statement();
  void other_statement(std::string_view keyword);
  void vertex();
  void normal();
  uint8_t channel(size_t i) const;
  void face();
  ObjCorner corner(size_t i);
  uint32_t vertex_index(const char* word, int value);
  uint32_t normal_index(int value) const;
  [[noreturn]] void bad_corner(const char* word) const;
  void check_indices();

  std::string file_;
  LineReader lines_;
  ObjStatements is_;
  Greatest greatest_vertex_;
};

}  // namespace pineda::scene
