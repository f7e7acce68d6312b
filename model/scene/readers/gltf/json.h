// Typed access to the JSON of a glTF file; error messages name the place of a value.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pineda::scene {

using Json = nlohmann::json;

/// Errors   InputError: no JSON (with the line), or values nested more than 64 deep.
Json parse_json(const std::string& file, std::string_view text);

/// A JSON object and its place in the file, such as "meshes[0].primitives[2]", which is only
/// composed for a message. A JsonPlace must outlive those made from it.
///
/// Errors   InputError, "PLACE.KEY: expected ...": a value that is present but of a wrong type.
class JsonPlace {
 public:
  JsonPlace(const std::string& file, Json* root);

  std::string name(const std::string& key = {}) const;
  /// The value of a key, of any type; nullptr if there is none.
  Json* find(const char* key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& expected) const;

  std::optional<JsonPlace> object(const char* key) const;
  /// Calls `visit` with the place of each element of an array of objects.
  template <class Visit>
  void for_each(const char* key, Visit&& visit) const {
    Json* all = array(key);
    for (size_t i = 0; all != nullptr && i < all->size(); ++i) {
      const JsonPlace element(this, key, i, &(*all)[i]);
      if (!element.json_->is_object()) element.fail("", "an object");
      visit(element);
    }
  }
  /// The length of an array, whatever its elements; 0 if there is none.
  size_t size(const char* key) const;
  /// An integer from 0 to 2^31 - 1: a count, an index or an offset.
  std::optional<int> index(const char* key) const;
  int required_index(const char* key) const;
  /// The same as a size; 0 if there is none.
  size_t size_value(const char* key) const;
  std::vector<int> indices(const char* key) const;
  /// An array of exactly `count` numbers; empty if there is none.
  std::vector<double> numbers(const char* key, size_t count) const;
  std::vector<std::string> strings(const char* key) const;

 private:
  JsonPlace(const JsonPlace* parent, const char* key, std::optional<size_t> element, Json* json);
  Json* array(const char* key) const;

  const std::string* file_;
  const JsonPlace* parent_ = nullptr;
  const char* key_ = nullptr;
  std::optional<size_t> element_;
  Json* json_;
};

}  // namespace pineda::scene
