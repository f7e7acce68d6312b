#include "model/scene/gltf_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "model/scene/error.h"
#include "model/scene/lines.h"

namespace pineda::scene {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;  // the format itself needs 6

Json parse(const std::string& file, const std::string& text) {
  const auto check_depth = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kDeepest) return true;
    throw InputError(file, fmt::format("expected values nested at most {} deep", kDeepest));
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const Json::parse_error& error) {
    const size_t at = std::min(text.size(), std::max<size_t>(error.byte, 1) - 1);
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw InputError(file, static_cast<uint64_t>(line) + 1,
                     "expected JSON, got " + quoted(text.substr(at)));
  } catch (const Json::exception&) {
    throw InputError(file, "expected JSON with numbers in the range of a double");
  }
}

// A value of the file, and its name for a message: "meshes[0].primitives[2]".
struct Place {
  const Json* json;
  std::string name;
};

class Guard {
 public:
  Guard(std::string file, const Json& root) : file_(std::move(file)), root_{&root, ""} {}

  void check() const {
    if (!root_.json->is_object()) fail(root_, "", "an object");
    check_asset();
    index(root_, "scene");
    for (const auto& scene : objects(root_, "scenes")) indices(scene, "nodes");
    for (const auto& node : objects(root_, "nodes")) check_node(node);
    for (const auto& mesh : objects(root_, "meshes")) {
      for (const auto& primitive : objects(mesh, "primitives")) check_primitive(primitive);
    }
    for (const auto& accessor : objects(root_, "accessors")) {
      for (const char* key : {"bufferView", "byteOffset", "componentType", "count"}) {
        index(accessor, key);
      }
    }
    for (const auto& view : objects(root_, "bufferViews")) {
      for (const char* key : {"buffer", "byteOffset", "byteLength", "byteStride"}) index(view, key);
    }
    for (const auto& buffer : objects(root_, "buffers")) index(buffer, "byteLength");
    for (const auto& material : objects(root_, "materials")) check_material(material);
  }

 private:
  static const Json* find(const Place& place, const char* key) {
    const auto at = place.json->find(key);
    return at == place.json->end() ? nullptr : &*at;
  }

  static std::string join(const Place& place, const std::string& key) {
    return place.name.empty() || key.empty() ? place.name + key : place.name + "." + key;
  }

  [[noreturn]] void fail(const Place& place, const std::string& key,
                         const std::string& expected) const {
    const std::string name = join(place, key);
    throw InputError(file_,
                     fmt::format("{}expected {}", name.empty() ? "" : name + ": ", expected));
  }

  void check_asset() const {
    const Json* asset = find(root_, "asset");
    if (asset == nullptr || !asset->is_object()) fail(root_, "asset", "an object");
    const Json version = asset->value("version", Json());
    if (!version.is_string() || version.get<std::string>().compare(0, 2, "2.") != 0) {
      fail(root_, "asset.version", "\"2.0\"");
    }
    const Json* required = find(root_, "extensionsRequired");
    if (required == nullptr) return;
    if (!required->is_array()) fail(root_, "extensionsRequired", "an array");
    if (required->empty()) return;
    const Json& first = required->front();
    fail(root_, "extensionsRequired",
         "none, got " + quoted(first.is_string() ? first.get<std::string>() : "no name"));
  }

  void check_node(const Place& node) const {
    for (const char* key : {"mesh", "skin", "camera"}) index(node, key);
    indices(node, "children");
    numbers(node, "matrix", 16);
    numbers(node, "translation", 3);
    numbers(node, "rotation", 4);
    numbers(node, "scale", 3);
  }

  void check_primitive(const Place& primitive) const {
    for (const char* key : {"indices", "material", "mode"}) index(primitive, key);
    const Json* attributes = find(primitive, "attributes");
    if (attributes == nullptr || !attributes->is_object()) {
      fail(primitive, "attributes", "an object");
    }
    const Place place{attributes, join(primitive, "attributes")};
    for (const char* key : {"POSITION", "NORMAL", "COLOR_0"}) index(place, key);
  }

  void check_material(const Place& material) const {
    const Json* pbr = find(material, "pbrMetallicRoughness");
    if (pbr == nullptr) return;
    const Place place{pbr, join(material, "pbrMetallicRoughness")};
    if (!pbr->is_object()) fail(place, "", "an object");
    numbers(place, "baseColorFactor", 4);
  }

  // The elements of an array of objects; none if it is absent.
  std::vector<Place> objects(const Place& place, const char* key) const {
    std::vector<Place> all;
    const Json* array = find(place, key);
    if (array == nullptr) return all;
    if (!array->is_array()) fail(place, key, "an array");
    for (const Json& element : *array) {
      all.push_back({&element, fmt::format("{}[{}]", join(place, key), all.size())});
      if (!element.is_object()) fail(all.back(), "", "an object");
    }
    return all;
  }

  void index(const Place& place, const char* key) const {
    const Json* value = find(place, key);
    if (value != nullptr && !is_index(*value)) fail(place, key, kIndex);
  }

  void indices(const Place& place, const char* key) const {
    const Json* array = find(place, key);
    if (array == nullptr) return;
    if (!array->is_array() || !std::all_of(array->begin(), array->end(), is_index)) {
      fail(place, key, std::string("an array, each element ") + kIndex);
    }
  }

  void numbers(const Place& place, const char* key, size_t count) const {
    const Json* array = find(place, key);
    if (array == nullptr) return;
    if (!array->is_array() || array->size() != count ||
        !std::all_of(array->begin(), array->end(), [](const Json& n) { return n.is_number(); })) {
      fail(place, key, fmt::format("{} numbers", count));
    }
  }

  static constexpr const char* kIndex = "an integer from 0 to 2147483647";
  static bool is_index(const Json& value) {
    return value.is_number_unsigned() &&
           value.get<uint64_t>() <= uint64_t{std::numeric_limits<int32_t>::max()};
  }

  std::string file_;
  Place root_;
};

}  // namespace

void guard_gltf(const std::string& file, const std::string& json) {
  const Json root = parse(file, json);
  Guard(file, root).check();
}

}  // namespace pineda::scene
