#include "model/scene/readers/gltf/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "model/scene/readers/gltf/extensions.h"
#include "model/scene/readers/lines.h"

namespace pineda::scene {
namespace {

int columns_of(const JsonPlace& accessor) {
  static const std::pair<const char*, int> kTypes[] = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  const Json* type = accessor.find("type");
  for (const auto& [name, columns] : kTypes) {
    if (type != nullptr && *type == name) return columns;
  }
  return 0;
}

GltfSparse read_sparse(const JsonPlace& place) {
  GltfSparse sparse;
  sparse.count = place.size_value("count");
  const auto indices = place.object("indices");
  const auto values = place.object("values");
  if (!indices) place.fail("indices", "an object");
  if (!values) place.fail("values", "an object");
  sparse.indices_view = indices->required_index("bufferView");
  sparse.indices_offset = indices->size_value("byteOffset");
  sparse.indices_type = indices->required_index("componentType");
  sparse.values_view = values->required_index("bufferView");
  sparse.values_offset = values->size_value("byteOffset");
  return sparse;
}

GltfAccessor read_accessor(const JsonPlace& place) {
  GltfAccessor accessor;
  accessor.view = place.index("bufferView");
  accessor.offset = place.size_value("byteOffset");
  accessor.count = place.size_value("count");
  accessor.component_type = place.index("componentType").value_or(0);
  accessor.columns = columns_of(place);
  const Json* normalized = place.find("normalized");
  accessor.is_normalized = normalized != nullptr && *normalized == true;
  if (const auto sparse = place.object("sparse")) accessor.sparse = read_sparse(*sparse);
  return accessor;
}

GltfBufferView read_view(const JsonPlace& place) {
  return {place.required_index("buffer"), place.size_value("byteOffset"),
          place.size_value("byteLength"), place.size_value("byteStride")};
}

GltfBuffer read_buffer(const JsonPlace& place) {
  GltfBuffer buffer{place.size_value("byteLength"), {}};
  if (Json* uri = place.find("uri")) {
    if (!uri->is_string()) place.fail("uri", "a text");
    buffer.uri = std::move(uri->get_ref<std::string&>());
  }
  return buffer;
}

bool has_extension(const JsonPlace& place, const char* name) {
  const auto extensions = place.object("extensions");
  return extensions && extensions->find(name) != nullptr;
}

GltfPrimitive read_primitive(const JsonPlace& place) {
  GltfPrimitive primitive;
  primitive.indices = place.index("indices");
  primitive.material = place.index("material");
  primitive.mode = place.index("mode").value_or(4);
  if (primitive.mode > 6) place.fail("mode", "0 to 6");
  const auto attributes = place.object("attributes");
  if (!attributes) place.fail("attributes", "an object");
  primitive.position = attributes->index("POSITION");
  primitive.normal = attributes->index("NORMAL");
  primitive.color = attributes->index("COLOR_0");
  primitive.has_targets = place.size("targets") > 0;
  primitive.is_draco = has_extension(place, "KHR_draco_mesh_compression");
  return primitive;
}

bool is_visible(const JsonPlace& node) {
  const auto extensions = node.object("extensions");
  if (!extensions) return true;
  const auto visibility = extensions->object("KHR_node_visibility");
  if (!visibility) return true;
  const Json* visible = visibility->find("visible");
  if (visible != nullptr && !visible->is_boolean()) visibility->fail("visible", "true or false");
  return visible == nullptr || visible->get<bool>();
}

GltfNode read_node(const JsonPlace& place) {
  GltfNode node;
  node.mesh = place.index("mesh");
  node.has_skin = place.index("skin").has_value();
  node.camera = place.index("camera");
  node.children = place.indices("children");
  node.is_visible = is_visible(place);
  node.matrix = place.numbers("matrix", 16);
  node.translation = place.numbers("translation", 3);
  node.rotation = place.numbers("rotation", 4);
  node.scale = place.numbers("scale", 3);
  return node;
}

GltfMaterial read_material(const JsonPlace& place) {
  GltfMaterial material;
  const auto pbr = place.object("pbrMetallicRoughness");
  if (!pbr) return material;
  const auto base = pbr->numbers("baseColorFactor", 4);
  std::copy(base.begin(), base.end(), material.base_color.begin());
  material.has_texture = pbr->object("baseColorTexture").has_value();
  return material;
}

// Reads a camera. An error in it is stored, and only reported if that camera is used.
class CameraReader {
 public:
  CameraReader(const Json& json, std::string name) : json_(json), name_(std::move(name)) {}

  GltfCamera read() {
    const Json type = json_.is_object() ? json_.value("type", Json()) : Json();
    if (type == "perspective") {
      perspective();
    } else if (type == "orthographic") {
      orthographic();
    } else {
      fail("type", "perspective or orthographic", type);
    }
    return std::move(camera_);
  }

 private:
  void perspective() {
    kind_ = "perspective";
    camera_.yfov = number("yfov", 0, "an angle between 0 and pi");
    if (!(camera_.yfov < M_PI)) fail("yfov", "an angle between 0 and pi", *find("yfov"));
    camera_.near = number("znear", 0, "a distance above 0");
    if (find("zfar") != nullptr) camera_.far = far();
  }

  // xmag is only checked: the aspect ratio is the frame's. A negative one would mirror the picture.
  void orthographic() {
    kind_ = "orthographic";
    camera_.is_orthographic = true;
    number("xmag", 0, "a number above 0");
    camera_.ymag = number("ymag", 0, "a number above 0");
    camera_.near = number("znear", -std::numeric_limits<double>::denorm_min(), "0 or above");
    camera_.far = far();
  }

  double far() { return number("zfar", camera_.near, "a distance beyond znear"); }

  // A number that must be above `bound`; 1 if it is not.
  double number(const char* key, double bound, const char* expected) {
    const Json* value = find(key);
    const bool fits = value != nullptr && value->is_number() && value->get<double>() > bound;
    if (!fits) fail(key, expected, value == nullptr ? Json() : *value);
    return fits ? value->get<double>() : 1;
  }

  const Json* find(const char* key) const {
    const auto lens = json_.find(kind_);
    if (lens == json_.end() || !lens->is_object()) return nullptr;
    const auto value = lens->find(key);
    return value == lens->end() ? nullptr : &*value;
  }

  // Keeps the first error only.
  void fail(const std::string& key, const char* expected, const Json& got) {
    if (!camera_.wrong.empty()) return;
    const std::string shown = got.is_null()     ? "none"
                              : got.is_string() ? quoted(got.get<std::string>())
                              : got.is_number() ? got.dump()
                                                : "something else";
    camera_.wrong = fmt::format("{}.{}{}{}: expected {}, got {}", name_, kind_,
                                kind_.empty() ? "" : ".", key, expected, shown);
  }

  const Json& json_;
  std::string name_, kind_;
  GltfCamera camera_;
};

std::vector<GltfCamera> read_cameras(const JsonPlace& root) {
  std::vector<GltfCamera> all;
  const Json* cameras = root.find("cameras");
  if (cameras == nullptr || !cameras->is_array()) return all;
  for (const Json& camera : *cameras) {
    all.push_back(CameraReader(camera, fmt::format("cameras[{}]", all.size())).read());
  }
  return all;
}

void check_asset(const JsonPlace& root) {
  const auto asset = root.object("asset");
  if (!asset) root.fail("asset", "an object");
  const Json* version = asset->find("version");
  const bool fits = version != nullptr && version->is_string() &&
                    version->get_ref<const std::string&>().compare(0, 2, "2.") == 0;
  if (!fits) asset->fail("version", "\"2.0\"");
}

std::vector<std::string> read_extensions(const JsonPlace& root) {
  const auto required = root.strings("extensionsRequired");
  for (const std::string& name : required) {
    const GltfExtension extension = gltf_extension(name);
    if (extension.effect != GltfEffect::kRefused) continue;
    root.fail("extensionsRequired", fmt::format("none that changes what is drawn, got {} ({})",
                                                quoted(name), extension.reason));
  }
  std::vector<std::string> all = root.strings("extensionsUsed");
  all.insert(all.end(), required.begin(), required.end());
  std::set<std::string> seen;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const std::string& name) { return !seen.insert(name).second; }),
            all.end());
  return all;
}

template <class Part, class Read>
std::vector<Part> read_all(const JsonPlace& place, const char* key, Read read) {
  std::vector<Part> all;
  place.for_each(key, [&](const JsonPlace& element) { all.push_back(read(element)); });
  return all;
}

}  // namespace

GltfDocument read_document(const std::string& file, Json* json) {
  const JsonPlace root(file, json);
  check_asset(root);
  GltfDocument document;
  document.extensions = read_extensions(root);
  document.scene = root.index("scene");
  document.scenes = read_all<std::vector<int>>(
      root, "scenes", [](const JsonPlace& scene) { return scene.indices("nodes"); });
  document.nodes = read_all<GltfNode>(root, "nodes", read_node);
  document.meshes = read_all<std::vector<GltfPrimitive>>(root, "meshes", [](const JsonPlace& mesh) {
    return read_all<GltfPrimitive>(mesh, "primitives", read_primitive);
  });
  document.accessors = read_all<GltfAccessor>(root, "accessors", read_accessor);
  document.views = read_all<GltfBufferView>(root, "bufferViews", read_view);
  document.buffers = read_all<GltfBuffer>(root, "buffers", read_buffer);
  document.materials = read_all<GltfMaterial>(root, "materials", read_material);
  document.cameras = read_cameras(root);
  document.animations = root.size("animations");
  return document;
}

}  // namespace pineda::scene
