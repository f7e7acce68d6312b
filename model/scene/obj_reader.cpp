#include "model/scene/obj_reader.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <unordered_map>

#include "model/scene/error.h"
#include "model/scene/lines.h"
#include "model/scene/normals.h"

namespace pineda::scene {
namespace {

// The numbers of the file, and its faces checked. tinyobjloader then only builds the triangles: its
// own number reader takes a word that is no number, and nan too, for 0, and its errors about
// indices name no line.
struct Scan {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<Rgba> color;  // of the vertices that have one
  size_t triangles = 0;     // that the polygons should give
};

// The greatest index that a face names, and where.
struct Greatest {
  int64_t index = 0;
  uint64_t line = 0;
};

class Scanner {
 public:
  explicit Scanner(const std::string& file) : file_(file), lines_(file, open_file(file)) {}

  Scan scan() {
    while (lines_.next()) {
      if (lines_.is("v")) vertex();
      if (lines_.is("vn")) normal();
      if (lines_.is("f")) face();
    }
    check(greatest_vertex_, scan_.position.size(), "vertices");
    check(greatest_normal_, scan_.normal.size(), "normals");
    if (scan_.triangles == 0) lines_.fail("faces (lines 'f ...')", "none");
    return std::move(scan_);
  }

 private:
  void vertex() {
    const size_t words = lines_.words().size();
    if (words != 4 && words != 5 && words != 7) lines_.expect_words(4, "v X Y Z");
    scan_.position.push_back({lines_.number(1), lines_.number(2), lines_.number(3)});
    if (words == 5 && lines_.number(4) != 1) lines_.fail("W = 1", lines_.words()[4]);
    if (words == 7) scan_.color.push_back({channel(4), channel(5), channel(6), 255});
  }

  uint8_t channel(size_t i) const {
    const float value = lines_.number(i);
    if (!(value >= 0 && value <= 1)) lines_.fail("a colour from 0 to 1", lines_.words()[i]);
    return static_cast<uint8_t>(std::lround(value * 255.0));
  }

  void normal() {
    lines_.expect_words(4, "vn X Y Z");
    const Vec3 n = {lines_.number(1), lines_.number(2), lines_.number(3)};
    if (!is_finite(n)) lines_.fail("a finite normal", lines_.raw());
    scan_.normal.push_back(normalized(n));
  }

  void face() {
    const size_t corners = lines_.words().size() - 1;
    if (corners < 3) lines_.fail("a face of three or more corners", lines_.raw());
    for (size_t i = 1; i <= corners; ++i) corner(lines_.words()[i]);
    scan_.triangles += corners - 2;
  }

  // V, V/VT, V//VN or V/VT/VN
  void corner(const char* word) {
    const char* end = word + std::strlen(word);
    const char* at = index(word, word, end, scan_.position.size(), &greatest_vertex_);
    if (at == end) return;
    if (*at == '/' && at + 1 != end && at[1] != '/') {
      Greatest unused;  // nothing here uses texture coordinates
      at = index(word, at + 1, end, SIZE_MAX / 2, &unused);
      if (at == end) return;
    } else if (*at == '/') {
      ++at;
    }
    if (at == end || *at != '/') bad_corner(word);
    if (index(word, at + 1, end, scan_.normal.size(), &greatest_normal_) != end) bad_corner(word);
  }

  const char* index(const char* word, const char* from, const char* end, size_t count,
                    Greatest* greatest) {
    int value = 0;
    const auto result = std::from_chars(from, end, value);
    if (result.ec != std::errc()) bad_corner(word);
    if (value == 0 || (value < 0 && static_cast<size_t>(-static_cast<int64_t>(value)) > count)) {
      lines_.fail(fmt::format("an index from 1 on, or from -{} to -1", count), word);
    }
    if (value > greatest->index) *greatest = {value, lines_.line()};
    return result.ptr;
  }

  [[noreturn]] void bad_corner(const char* word) const {
    lines_.fail("a corner V, V/VT, V//VN or V/VT/VN", word);
  }

  // A face may name a vertex that follows later, so the end of the file decides.
  void check(const Greatest& greatest, size_t count, const char* what) const {
    if (greatest.index > static_cast<int64_t>(count)) {
      throw InputError(
          file_, greatest.line,
          fmt::format("expected an index of {} {}, got {}", count, what, greatest.index));
    }
  }

  std::string file_;
  LineReader lines_;
  Scan scan_;
  Greatest greatest_vertex_;
  Greatest greatest_normal_;
};

std::vector<tinyobj::index_t> corners(const std::string& file) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  const auto stream = open_file(file);
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, stream.get())) {
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw InputError(file, "expected a Wavefront mesh, got: " + error);
  }
  std::vector<tinyobj::index_t> all;
  for (const auto& shape : shapes) {
    all.insert(all.end(), shape.mesh.indices.begin(), shape.mesh.indices.end());
  }
  return all;
}

// The faces by their positions alone, whatever their normals.
std::vector<std::array<uint32_t, 3>> faces(const std::vector<tinyobj::index_t>& corner) {
  std::vector<std::array<uint32_t, 3>> all(corner.size() / 3);
  for (size_t i = 0; i < 3 * all.size(); ++i) {
    all[i / 3][i % 3] = static_cast<uint32_t>(corner[i].vertex_index);
  }
  return all;
}

// A mesh vertex for each pair of position and normal that occurs.
Mesh build(const Scan& scan, const std::vector<tinyobj::index_t>& corner) {
  const auto mean = mean_normals(scan.position, faces(corner));
  const bool colored = scan.color.size() == scan.position.size();
  Mesh mesh;
  std::unordered_map<uint64_t, uint32_t> known;
  for (size_t i = 0; i < corner.size(); ++i) {
    const auto v = static_cast<uint32_t>(corner[i].vertex_index);
    const auto n = static_cast<uint32_t>(corner[i].normal_index);  // -1: none
    const auto [at, is_new] = known.try_emplace(static_cast<uint64_t>(v) << 32 | n,
                                                static_cast<uint32_t>(mesh.position.size()));
    if (is_new) {
      mesh.position.push_back(scan.position[v]);
      mesh.normal.push_back(corner[i].normal_index < 0 ? mean[v] : scan.normal[n]);
      if (colored) mesh.color.push_back(scan.color[v]);
    }
    if (i % 3 == 0) mesh.triangle.emplace_back();
    mesh.triangle.back()[i % 3] = at->second;
  }
  return mesh;
}

}  // namespace

Mesh read_obj(const std::string& file, std::vector<std::string>* warnings) {
  const Scan scan = Scanner(file).scan();
  const auto corner = corners(file);
  if (corner.size() != 3 * scan.triangles) {
    warnings->push_back(fmt::format("{}: left out {} triangles that its polygons should give", file,
                                    scan.triangles - corner.size() / 3));
  }
  if (!scan.color.empty() && scan.color.size() != scan.position.size()) {
    warnings->push_back(fmt::format("{}: colours not used: only {} of {} vertices have one", file,
                                    scan.color.size(), scan.position.size()));
  }
  return build(scan, corner);
}

}  // namespace pineda::scene
