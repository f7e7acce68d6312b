#include "model/scene/readers/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "model/scene/error.h"
#include "model/scene/polygons/triangulate.h"
#include "model/scene/readers/normals.h"
#include "model/scene/readers/ply_colors.h"
#include "model/scene/readers/ply_file.h"
#include "model/scene/readers/topology.h"

namespace pineda::scene {
namespace {

// The properties of a vertex beside its colour, in the order in which they are stored.
constexpr const char* kSlots[] = {"x", "y", "z", "nx", "ny", "nz"};
constexpr size_t kNormal = 3, kSlotCount = 6;
constexpr double kRestart = -1;  // begins a new strip in a list of tristrips

ptrdiff_t count_slots(const PlyElement& vertex, size_t first, size_t end) {
  return std::count_if(kSlots + first, kSlots + end, [&](const char* name) {
    const auto& all = vertex.properties;
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& p) { return p.name == name && !p.count; });
  });
}

bool is_corners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// The file's faces: polygons, and triangles of strips.
struct Faces {
  std::vector<uint32_t> corner;
  std::vector<uint32_t> corners;  // number of corners of each face
  std::vector<Rgba> color;        // of each face, or empty
};

class Reader {
 public:
  Reader(const std::string& file, std::vector<std::string>* warnings)
      : name_(file), file_(file), warnings_(warnings) {}

  Mesh read() {
    check();
    for (const PlyElement& element : file_.elements()) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        read_faces(element, element.name == "face" ? Topology::kFan : Topology::kStrip);
      } else {
        skip(element);
      }
    }
    if (faces_.corners.empty()) throw InputError(name_, "expected faces, got none");
    if (file_.has_more()) warn("left out what follows the last element");
    if (!faces_.color.empty()) separate_faces();
    cut_faces();
    set_normals();
    return std::move(mesh_);
  }

 private:
  void warn(const std::string& text) const { warnings_->push_back(name_ + ": " + text); }

  const PlyElement* find(const char* name) const {
    for (const PlyElement& element : file_.elements()) {
      if (element.name == name) return &element;
    }
    return nullptr;
  }

  // Checks by the header alone, before any value is read, that the file can be used.
  void check() {
    const PlyElement* vertex = find("vertex");
    if (vertex == nullptr || count_slots(*vertex, 0, kNormal) != 3) {
      throw InputError(name_, "expected an element vertex with x, y and z");
    }
    if (vertex->count >= std::numeric_limits<uint32_t>::max()) {
      throw InputError(name_,
                       fmt::format("expected less than 2^32 - 1 vertices, got {}", vertex->count));
    }
    vertices_ = vertex->count;
    std::vector<const PlyElement*> faces;
    for (const char* name : {"face", "tristrips"}) {
      const PlyElement* element = find(name);
      if (element == nullptr) continue;
      const auto& all = element->properties;
      if (std::count_if(all.begin(), all.end(), is_corners) != 1) {
        throw InputError(name_, fmt::format("expected one list vertex_indices in {}", name));
      }
      if (element->count > 0) faces.push_back(element);
      has_faces_ = true;
    }
    if (!has_faces_) throw InputError(name_, "expected an element face or tristrips");
    if (file_.unknown_lines() > 0) {
      warn(fmt::format("left out {} lines of the header of unknown meaning, first {}",
                       file_.unknown_lines(), quoted(file_.first_unknown_line())));
    }
    const auto normals = count_slots(*vertex, kNormal, kSlotCount);
    has_normals_ = normals == 3;
    if (normals % 3 != 0) warn("normals not used: not all of nx, ny and nz are there");
    check_colors(*vertex, faces);
  }

  void check_colors(const PlyElement& vertex, const std::vector<const PlyElement*>& faces) {
    const auto colors = [&](const PlyElement& element) {
      PlyColors found(element);
      if (!found.note().empty()) warn(found.note());
      return found;
    };
    has_colors_ = colors(vertex).are_there();
    ptrdiff_t colored = 0;
    for (const PlyElement* element : faces) colored += colors(*element).are_there() ? 1 : 0;
    if (colored > 0 && has_colors_) warn("colours of faces not used: the vertices have colours");
    if (colored > 0 && !has_colors_ && colored < static_cast<ptrdiff_t>(faces.size())) {
      warn("colours of faces not used: faces or tristrips have none");
    }
    has_face_colors_ =
        colored > 0 && !has_colors_ && colored == static_cast<ptrdiff_t>(faces.size());
  }

  void read_vertices(const PlyElement& element) {
    const PlyColors colors(element);
    std::vector<size_t> slot;
    for (const auto& property : element.properties) {
      const auto* found = std::find(kSlots, kSlots + kSlotCount, property.name);
      slot.push_back(static_cast<size_t>(found - kSlots));
    }
    for (uint64_t i = 0; i < element.count; ++i) {
      file_.begin(element, i);
      std::array<double, kSlotCount> value{};
      Rgba color{0, 0, 0, 255};
      for (size_t k = 0; k < slot.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (colors.channel(k) >= 0) {
          colors.set(k, file_.number(property.type), file_, &color);
        } else if (property.count || slot[k] == kSlotCount) {
          skip(property);
        } else {
          value[slot[k]] = file_.number(property.type);
        }
      }
      file_.end();
      mesh_.position.push_back({value[0], value[1], value[2]});
      if (has_normals_) mesh_.normal.push_back({value[3], value[4], value[5]});
      if (has_colors_) mesh_.color.push_back(color);
    }
  }

  void read_faces(const PlyElement& element, Topology topology) {
    const PlyColors colors(element);
    for (uint64_t i = 0; i < element.count; ++i) {
      file_.begin(element, i);
      Rgba color{0, 0, 0, 255};
      for (size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (is_corners(property)) {
          read_corners(property, topology);
        } else if (has_face_colors_ && colors.channel(k) >= 0) {
          colors.set(k, file_.number(property.type), file_, &color);
        } else {
          skip(property);
        }
      }
      file_.end();
      if (has_face_colors_) faces_.color.resize(faces_.corners.size(), color);
    }
  }

  void read_corners(const PlyProperty& property, Topology topology) {
    const uint64_t size = file_.list_size(*property.count);
    corners_.clear();
    for (uint64_t k = 0; k < size; ++k) {
      const double corner = file_.number(property.type);
      if (corner == kRestart && topology == Topology::kStrip) {
        add_face(topology);
        corners_.clear();
        continue;
      }
      if (!(corner >= 0 && corner < static_cast<double>(vertices_)) ||
          corner != std::floor(corner)) {
        file_.fail(fmt::format("an index of {} vertices", vertices_), fmt::format("{}", corner));
      }
      corners_.push_back(static_cast<uint32_t>(corner));
    }
    // The last strip may also be ended by -1, and is then done already.
    if (!corners_.empty() || topology == Topology::kFan) add_face(topology);
  }

  void add_face(Topology topology) {
    if (corners_.size() < 3) {
      file_.fail("three or more corners", fmt::format("{}", corners_.size()));
    }
    if (topology == Topology::kFan) {
      faces_.corner.insert(faces_.corner.end(), corners_.begin(), corners_.end());
      faces_.corners.push_back(static_cast<uint32_t>(corners_.size()));
      return;
    }
    for (size_t i = 0; i < triangle_count(topology, corners_.size()); ++i) {
      for (const size_t at : triangle_corners(topology, i)) faces_.corner.push_back(corners_[at]);
      faces_.corners.push_back(3);
    }
  }

  // Gives each face its own vertices, with the face's colour.
  void separate_faces() {
    if (faces_.corner.size() >= std::numeric_limits<uint32_t>::max()) {
      throw InputError(name_, "expected less than 2^32 - 1 corners of faces that have colours");
    }
    origin_ = std::move(faces_.corner);
    faces_.corner.resize(origin_.size());
    std::iota(faces_.corner.begin(), faces_.corner.end(), 0U);
    vertex_position_ = std::move(mesh_.position);
    mesh_.position.clear();
    for (const uint32_t vertex : origin_) mesh_.position.push_back(vertex_position_[vertex]);
    for (size_t i = 0; i < faces_.corners.size(); ++i) {
      mesh_.color.resize(mesh_.color.size() + faces_.corners[i], faces_.color[i]);
    }
  }

  void cut_faces() {
    mesh_.triangle.reserve(faces_.corner.size() - 2 * faces_.corners.size());
    PolygonCutter cutter(&mesh_);
    const uint32_t* corner = faces_.corner.data();
    for (const uint32_t corners : faces_.corners) {
      cutter.add(corner, corners);
      corner += corners;
    }
    cutter.warn(name_, warnings_);
  }

  // Computes the normals of the file's vertices, also if separate_faces() has duplicated them.
  void set_normals() {
    auto triangle = mesh_.triangle;
    if (!origin_.empty()) {
      for (auto& t : triangle) {
        for (uint32_t& vertex : t) vertex = origin_[vertex];
      }
    }
    const auto& position = origin_.empty() ? mesh_.position : vertex_position_;
    std::vector<Vec3> normal = std::move(mesh_.normal);
    if (normal.empty()) {
      normal = mean_normals(position, triangle);
    } else if (const uint64_t mended = mend_normals(position, triangle, &normal)) {
      warn(fmt::format("{} normals are zero or not finite: theirs is the mean of the faces",
                       mended));
    }
    if (origin_.empty()) {
      mesh_.normal = std::move(normal);
      return;
    }
    mesh_.normal.clear();
    for (const uint32_t vertex : origin_) mesh_.normal.push_back(normal[vertex]);
  }

  void skip(const PlyProperty& property) {
    const uint64_t size = property.count ? file_.list_size(*property.count) : 1;
    for (uint64_t k = 0; k < size; ++k) file_.number(property.type);
  }

  void skip(const PlyElement& element) {
    if (element.count > 0) {
      warn(fmt::format("left out {} elements {}", element.count, quoted(element.name)));
    }
    for (uint64_t i = 0; i < element.count; ++i) {
      file_.begin(element, i);
      for (const auto& property : element.properties) skip(property);
      file_.end();
    }
  }

  std::string name_;
  PlyFile file_;
  std::vector<std::string>* warnings_;
  uint64_t vertices_ = 0;
  bool has_faces_ = false;
  bool has_normals_ = false;
  bool has_colors_ = false;
  bool has_face_colors_ = false;
  std::vector<uint32_t> corners_;  // of the face that is being read
  Faces faces_;
  Mesh mesh_;
  // After separate_faces(): the file's vertex of each mesh vertex, and the file's positions.
  std::vector<uint32_t> origin_;
  std::vector<Vec3> vertex_position_;
};

}  // namespace

Mesh read_ply(const std::string& file, std::vector<std::string>* warnings) {
  return Reader(file, warnings).read();
}

}  // namespace pineda::scene
