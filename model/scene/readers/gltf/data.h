// A glTF or GLB file and the bytes of its buffers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/readers/gltf/document.h"

namespace pineda::scene {

/// In       glTF 2.0 as text or GLB (told apart by their first bytes), of less than 4 GiB; buffers
///          in the file, as data URI of any media type, or in regular files, named relative to the
///          file's folder. A buffer is read when it is first asked for, all together less than
///          4 GiB.
/// Errors   InputError: what parse_json() and read_document() find, chunks that do not fill the
///          GLB, a buffer that is not there or shorter than it says. No message shows base64 text.
/// Source   Khronos glTF 2.0 specification, 3.6.1.1 for URIs, 4.4 for GLB.
class GltfData {
 public:
  explicit GltfData(const std::string& file);
  GltfData(const GltfData&) = delete;
  GltfData& operator=(const GltfData&) = delete;

  const std::string& file() const { return file_; }
  const GltfDocument& document() const { return document_; }
  /// The bytes of a buffer, as many as it says.
  std::string_view buffer(int i);
  /// True once for each accessor: what costs time is checked once.
  bool is_first_use(size_t accessor);

 private:
  std::string load(size_t i, const GltfBuffer& buffer) const;
  std::string load_file(const std::string& where, const std::string& uri, size_t bytes) const;

  std::string file_;
  std::string bytes_;                      // of the whole file, if it is a GLB
  std::optional<std::string_view> chunk_;  // BIN
  GltfDocument document_;
  std::vector<std::optional<std::string>> buffers_;  // those loaded
  uint64_t loaded_bytes_ = 0;
  std::vector<bool> is_used_;  // of the accessors
};

}  // namespace pineda::scene
