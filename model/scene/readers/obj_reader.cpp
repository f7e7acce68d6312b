#include "model/scene/readers/obj_reader.h"

#include <fmt/format.h>

#include <unordered_map>

#include "model/scene/polygons/triangulate.h"
#include "model/scene/readers/normals.h"
#include "model/scene/readers/obj_file.h"

namespace pineda::scene {
namespace {

// Mean normals of the file's vertices, from the mesh's triangles. vertex[i] is the file's vertex
// that mesh vertex i comes from.
std::vector<Vec3> mean_normals_of(const Mesh& mesh, const std::vector<uint32_t>& vertex,
                                  const std::vector<Vec3>& position) {
  std::vector<std::array<uint32_t, 3>> triangle = mesh.triangle;
  for (auto& t : triangle) {
    for (uint32_t& k : t) k = vertex[k];
  }
  return mean_normals(position, triangle);
}

// Builds a mesh with one vertex for each pair of position and normal that occurs, in the order of
// the corners.
class Builder {
 public:
  explicit Builder(const ObjStatements& file)
      : file_(file), is_colored_(file.color.size() == file.position.size()) {}

  Mesh build(const std::string& name, std::vector<std::string>* warnings) {
    first_.resize(file_.position.size());
    PolygonCutter cutter(&mesh_);
    mesh_.triangle.reserve(file_.corner.size() - 2 * file_.corners.size());
    std::vector<uint32_t> polygon;
    const ObjCorner* corner = file_.corner.data();
    for (const uint32_t count : file_.corners) {
      polygon.clear();
      for (uint32_t i = 0; i < count; ++i) polygon.push_back(vertex_at(*corner++));
      cutter.add(polygon.data(), count);
    }
    set_normals();
    cutter.warn(name, warnings);
    return std::move(mesh_);
  }

  uint64_t unusable_normals() const { return unusable_normals_; }

 private:
  struct Known {
    uint32_t vertex = UINT32_MAX;  // of the mesh; UINT32_MAX: none yet
    uint32_t normal = 0;
  };

  uint32_t vertex_at(ObjCorner corner) {
    if (corner.normal != ObjCorner::kNoNormal && !is_direction(file_.normal[corner.normal])) {
      corner.normal = ObjCorner::kNoNormal;
      ++unusable_normals_;
    }
    Known& first = first_[corner.vertex];
    if (first.vertex == UINT32_MAX) return (first = {add(corner), corner.normal}).vertex;
    if (first.normal == corner.normal) return first.vertex;
    const auto [at, is_new] =
        others_.try_emplace(uint64_t{corner.vertex} << 32 | corner.normal, uint32_t{0});
    if (is_new) at->second = add(corner);
    return at->second;
  }

  uint32_t add(const ObjCorner& corner) {
    mesh_.position.push_back(file_.position[corner.vertex]);
    if (is_colored_) mesh_.color.push_back(file_.color[corner.vertex]);
    origin_.push_back(corner);
    return static_cast<uint32_t>(origin_.size() - 1);
  }

  void set_normals() {
    std::vector<uint32_t> vertex;
    bool needs_mean = false;
    for (const ObjCorner& corner : origin_) {
      vertex.push_back(corner.vertex);
      needs_mean = needs_mean || corner.normal == ObjCorner::kNoNormal;
    }
    std::vector<Vec3> mean;
    if (needs_mean) mean = mean_normals_of(mesh_, vertex, file_.position);
    mesh_.normal.reserve(origin_.size());
    for (const ObjCorner& corner : origin_) {
      mesh_.normal.push_back(corner.normal == ObjCorner::kNoNormal
                                 ? mean[corner.vertex]
                                 : normalized(file_.normal[corner.normal]));
    }
  }

  const ObjStatements& file_;
  bool is_colored_;
  Mesh mesh_;
  std::vector<ObjCorner> origin_;  // the file's vertex and normal of each mesh vertex
  std::vector<Known> first_;       // the first mesh vertex of each position
  std::unordered_map<uint64_t, uint32_t> others_;
  uint64_t unusable_normals_ = 0;
};

// Adds warnings for parts of the file that the mesh does not have.
void warn(const std::string& name, const ObjStatements& file, uint64_t unusable_normals,
          std::vector<std::string>* warnings) {
  const auto say = [&](uint64_t count, const std::string& text) {
    if (count > 0) warnings->push_back(fmt::format("{}: {}", name, text));
  };
  if (file.color.size() != file.position.size()) {
    say(file.color.size(), fmt::format("colours not used: only {} of {} vertices have one",
                                       file.color.size(), file.position.size()));
  }
  say(file.missing_normals,
      fmt::format("{} corners name a normal that there is not: theirs is the mean of the faces",
                  file.missing_normals));
  say(unusable_normals,
      fmt::format(
          "{} corners name a normal that is zero or not finite: theirs is the mean of the faces",
          unusable_normals));
  say(file.points, fmt::format("left out {} points (lines 'p ...')", file.points));
  say(file.lines, fmt::format("left out {} polylines (lines 'l ...')", file.lines));
  say(file.surfaces, fmt::format("left out {} curves and surfaces", file.surfaces));
  say(file.materials, fmt::format("materials not used ({} lines 'usemtl ...')", file.materials));
  say(file.unknown, fmt::format("left out {} lines of unknown meaning, first {} in line {}",
                                file.unknown, quoted(file.first_unknown), file.first_unknown_line));
}

}  // namespace

Mesh read_obj(const std::string& file, std::vector<std::string>* warnings) {
  const ObjStatements statements = ObjFile(file).read();
  Builder builder(statements);
  Mesh mesh = builder.build(file, warnings);
  warn(file, statements, builder.unusable_normals(), warnings);
  return mesh;
}

}  // namespace pineda::scene
