#include "model/scene/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/scene/error.h"
#include "model/scene/normals.h"
#include "model/scene/ply_file.h"
#include "model/scene/topology.h"

namespace pineda::scene {
namespace {

// What a vertex may have, in the order in which it is kept.
constexpr const char* kSlots[] = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha"};
constexpr size_t kNormal = 3, kColor = 6, kAlpha = 9, kSlotCount = 10;
constexpr double kRestart = -1;  // in the list of tristrips

bool is_scalar(const PlyElement& element, const std::string& name) {
  const auto& all = element.properties;
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& p) { return p.name == name && !p.count; });
}

bool has_slots(const PlyElement& vertex, size_t first, size_t end) {
  return std::all_of(kSlots + first, kSlots + end,
                     [&](const char* name) { return is_scalar(vertex, name); });
}

bool is_corners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// 1 as a colour of this type; 0 where the format says none.
double full_scale(PlyType type) {
  switch (type) {
    case PlyType::kU8:
      return 255;
    case PlyType::kU16:
      return 65535;
    case PlyType::kF32:
    case PlyType::kF64:
      return 1;
    default:
      return 0;
  }
}

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
    if (mesh_.triangle.empty()) throw InputError(name_, "expected faces, got none");
    if (file_.has_more()) warn("left out what follows the last element");
    if (mesh_.normal.empty()) mesh_.normal = mean_normals(mesh_.position, mesh_.triangle);
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

  // The header decides what can be read, so nothing needs to be read first.
  void check() {
    const PlyElement* vertex = find("vertex");
    if (vertex == nullptr || !has_slots(*vertex, 0, kNormal)) {
      throw InputError(name_, "expected an element vertex with x, y and z");
    }
    if (vertex->count >= std::numeric_limits<uint32_t>::max()) {
      throw InputError(name_,
                       fmt::format("expected less than 2^32 - 1 vertices, got {}", vertex->count));
    }
    vertices_ = vertex->count;
    bool has_faces = false;
    for (const char* name : {"face", "tristrips"}) {
      const PlyElement* element = find(name);
      if (element == nullptr) continue;
      const auto& all = element->properties;
      if (std::count_if(all.begin(), all.end(), is_corners) != 1) {
        throw InputError(name_, fmt::format("expected one list vertex_indices in {}", name));
      }
      has_faces = true;
    }
    if (!has_faces) throw InputError(name_, "expected an element face or tristrips");
    check_colors(*vertex);
    has_normals_ = has_slots(*vertex, kNormal, kColor);
  }

  void check_colors(const PlyElement& vertex) {
    has_colors_ = has_slots(vertex, kColor, kAlpha);
    for (const auto& property : vertex.properties) {
      const bool is_color =
          std::find(kSlots + kColor, kSlots + kSlotCount, property.name) != kSlots + kSlotCount;
      if (!is_color || (has_colors_ && !property.count && full_scale(property.type) > 0)) continue;
      has_colors_ = false;
      return warn("colours not used: expected red, green and blue as uchar, ushort or float");
    }
  }

  void read_vertices(const PlyElement& element) {
    std::vector<size_t> slot;
    for (const auto& property : element.properties) {
      const auto* found = std::find(kSlots, kSlots + kSlotCount, property.name);
      slot.push_back(static_cast<size_t>(found - kSlots));
    }
    for (uint64_t i = 0; i < element.count; ++i) {
      file_.begin(element, i);
      std::array<double, kSlotCount> value{};
      value[kAlpha] = 1;
      for (size_t k = 0; k < slot.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (property.count || slot[k] == kSlotCount) {
          skip(property);
        } else {
          value[slot[k]] = file_.number(property.type);
          if (slot[k] >= kColor && has_colors_) value[slot[k]] /= full_scale(property.type);
        }
      }
      file_.end();
      add_vertex(value);
    }
  }

  void add_vertex(const std::array<double, kSlotCount>& value) {
    mesh_.position.push_back({value[0], value[1], value[2]});
    if (has_normals_) {
      const Vec3 n = {value[kNormal], value[kNormal + 1], value[kNormal + 2]};
      if (!is_finite(n)) file_.fail("a finite normal", fmt::format("{} {} {}", n[0], n[1], n[2]));
      mesh_.normal.push_back(normalized(n));
    }
    if (!has_colors_) return;
    Rgba rgba;
    for (size_t k = 0; k < 4; ++k) {
      const double c = value[kColor + k];
      if (!(c >= 0 && c <= 1)) file_.fail("a colour from 0 to 1", fmt::format("{}", c));
      rgba[k] = static_cast<uint8_t>(std::lround(c * 255));
    }
    mesh_.color.push_back(rgba);
  }

  void read_faces(const PlyElement& element, Topology topology) {
    for (uint64_t i = 0; i < element.count; ++i) {
      file_.begin(element, i);
      for (const auto& property : element.properties) {
        if (is_corners(property)) {
          read_corners(property, topology);
        } else {
          skip(property);
        }
      }
      file_.end();
    }
  }

  void read_corners(const PlyProperty& property, Topology topology) {
    const uint64_t size = file_.list_size(*property.count);
    corners_.clear();
    for (uint64_t k = 0; k < size; ++k) {
      const double corner = file_.number(property.type);
      if (corner == kRestart && topology == Topology::kStrip) {
        add_triangles(topology);
        corners_.clear();
        continue;
      }
      if (!(corner >= 0 && corner < static_cast<double>(vertices_)) ||
          corner != std::floor(corner)) {
        file_.fail(fmt::format("an index of {} vertices", vertices_), fmt::format("{}", corner));
      }
      corners_.push_back(static_cast<uint32_t>(corner));
    }
    // A strip may end with its -1.
    if (!corners_.empty() || topology == Topology::kFan) add_triangles(topology);
  }

  void add_triangles(Topology topology) {
    if (corners_.size() < 3) {
      file_.fail("three or more corners", fmt::format("{}", corners_.size()));
    }
    for (size_t i = 0; i < triangle_count(topology, corners_.size()); ++i) {
      const auto at = triangle_corners(topology, i);
      mesh_.triangle.push_back({corners_[at[0]], corners_[at[1]], corners_[at[2]]});
    }
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
  bool has_normals_ = false;
  bool has_colors_ = false;
  std::vector<uint32_t> corners_;
  Mesh mesh_;
};

}  // namespace

Mesh read_ply(const std::string& file, std::vector<std::string>* warnings) {
  return Reader(file, warnings).read();
}

}  // namespace pineda::scene
