// Loads a glTF or GLB file and its buffers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/readers/gltf/document.h"

namespace pineda::scene {

/// In       glTF 2.0 as text or GLB (told apart by their first bytes), of less than 4 GiB; buffers
///          in the GLB, as data URIs of any media type, or in regular files named relative to the
///          file's folder. A buffer is loaded when it is first used; all of them together must be
///          smaller than 4 GiB.
/// Errors   InputError: from parse_json() and read_document(); chunks that do not fill the GLB; a
///          buffer that is missing or shorter than stated. No message shows base64 text.
/// Source   Khronos glTF 2.0 specification, 3.6.1.1 for URIs, 4.4 for GLB.
class GltfData {
 public:
  explicit GltfData(const std::string& file);
  GltfData(const GltfData&) = delete;
  GltfData& operator=(const GltfData&) = delete;

  const std::string& file() const { return file_; }
  const GltfDocument& document() const { return document_; }
  /// The bytes of a buffer, as many as its byteLength.
  std::string_view buffer(int i);
  /// True on the first call for an accessor, so that slow checks are done only once.
  bool is_first_use(size_t accessor);

 private:
  std::string load(size_t i, const GltfBuffer& buffer) const;
  std::string load_file(const std::string& where, const std::string& uri, size_t bytes) const;

  std::string file_;
  std::string bytes_;                      // of the whole file, if it is a GLB
  std::optional<std::string_view> chunk_;  // the BIN chunk
  GltfDocument document_;
  std::vector<std::optional<std::string>> buffers_;  // those loaded
  uint64_t loaded_bytes_ = 0;
  std::vector<bool> is_used_;  // of the accessors
};

}  // namespace pineda::scene
