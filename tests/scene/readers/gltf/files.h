// glTF and GLB files, made value by value.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pineda::scene {

using Json = nlohmann::json;

template <class T>
std::string packed(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size()};
}

inline std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

enum : int { kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126 };

struct GltfFile {
  Json json = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;  // of the one buffer

  /// An accessor with a view of its own; its index.
  int accessor(int component_type, const char* type, size_t count, const std::string& values,
               bool normalized = false) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size()}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"type", type},
                                 {"count", count}});
    if (normalized) json["accessors"].back()["normalized"] = true;
    bytes += values;
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int vectors(const std::vector<float>& values) {
    return accessor(kF32, "VEC3", values.size() / 3, packed(values));
  }
  /// Puts values over rows of an accessor.
  template <class Index>
  void sparse(int over, int index_type, const std::vector<Index>& rows, const std::string& values) {
    const int indices = accessor(index_type, "SCALAR", rows.size(), packed(rows));
    const int other = accessor(kU8, "SCALAR", values.size(), values);
    const auto view = [&](int i) {
      return json["accessors"][static_cast<size_t>(i)]["bufferView"];
    };
    json["accessors"][static_cast<size_t>(over)]["sparse"] = {
        {"count", rows.size()},
        {"indices", {{"bufferView", view(indices)}, {"componentType", index_type}}},
        {"values", {{"bufferView", view(other)}}}};
  }
  /// A mesh of one primitive and a node for it; the primitive.
  Json& mesh(const Json& attributes) {
    json["nodes"].push_back({{"mesh", json["meshes"].size()}});
    json["meshes"].push_back({{"primitives", {{{"attributes", attributes}}}}});
    return json["meshes"].back()["primitives"][0];
  }

  std::string text(const std::string& uri = "") const {
    Json all = json;
    all["buffers"] = {
        {{"byteLength", bytes.size()},
         {"uri", uri.empty() ? "data:application/octet-stream;base64," + base64(bytes) : uri}}};
    return all.dump(1);
  }
  std::string glb() const {
    Json all = json;
    all["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string chunk = all.dump();
    chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
    std::string binary = bytes;
    binary.resize((binary.size() + 3) / 4 * 4);
    const auto u32 = [](size_t value) { return packed<uint32_t>({static_cast<uint32_t>(value)}); };
    return "glTF" + u32(2) + u32(28 + chunk.size() + binary.size()) + u32(chunk.size()) + "JSON" +
           chunk + u32(binary.size()) + std::string("BIN\0", 4) + binary;
  }
};

inline Json& primitive(GltfFile* file) { return file->json["meshes"][0]["primitives"][0]; }

/// Vertex i stands at (i, i*i, 0), so that a triangle names its vertices.
inline GltfFile numbered(size_t vertices) {
  GltfFile file;
  std::vector<float> positions;
  for (size_t i = 0; i < vertices; ++i) {
    const auto x = static_cast<float>(i);
    positions.insert(positions.end(), {x, x * x, 0});
  }
  file.mesh({{"POSITION", file.vectors(positions)}});
  return file;
}

/// The corners (0 0 0), (1 0 0), (0 1 0), without indices.
inline GltfFile one_triangle() {
  GltfFile file;
  file.mesh({{"POSITION", file.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  return file;
}

}  // namespace pineda::scene
