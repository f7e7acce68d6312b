#include "model/scene/readers/gltf/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/scene/error.h"
#include "model/scene/readers/lines.h"

namespace pineda::scene {
namespace {

constexpr int kDeepest = 64;  // greatest nesting depth; the format itself needs 8
constexpr const char* kIndex = "an integer from 0 to 2147483647";

bool is_index(const Json& value) {
  return value.is_number_unsigned() &&
         value.get<uint64_t>() <= uint64_t{std::numeric_limits<int32_t>::max()};
}

}  // namespace

Json parse_json(const std::string& file, std::string_view text) {
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
                     "expected JSON, got " + quoted(std::string(text.substr(at, 64))));
  } catch (const Json::exception&) {
    throw InputError(file, "expected JSON with numbers in the range of a double");
  }
}

JsonPlace::JsonPlace(const std::string& file, Json* root) : file_(&file), json_(root) {
  if (!root->is_object()) fail("", "an object");
}

JsonPlace::JsonPlace(const JsonPlace* parent, const char* key, std::optional<size_t> element,
                     Json* json)
    : file_(parent->file_), parent_(parent), key_(key), element_(element), json_(json) {}

std::string JsonPlace::name(const std::string& key) const {
  std::string all;
  if (parent_ != nullptr) all = parent_->name(key_);
  if (element_) all += fmt::format("[{}]", *element_);
  return all.empty() || key.empty() ? all + key : all + "." + key;
}

void JsonPlace::fail(const std::string& key, const std::string& expected) const {
  const std::string where = name(key);
  throw InputError(*file_,
                   fmt::format("{}expected {}", where.empty() ? "" : where + ": ", expected));
}

Json* JsonPlace::find(const char* key) const {
  const auto at = json_->find(key);
  return at == json_->end() ? nullptr : &*at;
}

Json* JsonPlace::array(const char* key) const {
  Json* all = find(key);
  if (all != nullptr && !all->is_array()) fail(key, "an array");
  return all;
}

std::optional<JsonPlace> JsonPlace::object(const char* key) const {
  Json* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_object()) fail(key, "an object");
  return JsonPlace(this, key, {}, value);
}

size_t JsonPlace::size(const char* key) const {
  const Json* all = array(key);
  return all == nullptr ? 0 : all->size();
}

std::optional<int> JsonPlace::index(const char* key) const {
  const Json* value = find(key);
  if (value == nullptr) return {};
  if (!is_index(*value)) fail(key, kIndex);
  return value->get<int>();
}

int JsonPlace::required_index(const char* key) const {
  const auto value = index(key);
  if (!value) fail(key, kIndex);
  return *value;
}

size_t JsonPlace::size_value(const char* key) const {
  return static_cast<size_t>(index(key).value_or(0));
}

std::vector<int> JsonPlace::indices(const char* key) const {
  const Json* all = find(key);
  if (all == nullptr) return {};
  if (!all->is_array() || !std::all_of(all->begin(), all->end(), is_index)) {
    fail(key, std::string("an array, each element ") + kIndex);
  }
  return all->get<std::vector<int>>();
}

std::vector<double> JsonPlace::numbers(const char* key, size_t count) const {
  const Json* all = find(key);
  if (all == nullptr) return {};
  if (!all->is_array() || all->size() != count ||
      !std::all_of(all->begin(), all->end(), [](const Json& n) { return n.is_number(); })) {
    fail(key, fmt::format("{} numbers", count));
  }
  return all->get<std::vector<double>>();
}

std::vector<std::string> JsonPlace::strings(const char* key) const {
  const Json* all = array(key);
  if (all == nullptr) return {};
  if (!std::all_of(all->begin(), all->end(), [](const Json& s) { return s.is_string(); })) {
    fail(key, "an array, each element a text");
  }
  return all->get<std::vector<std::string>>();
}

}  // namespace pineda::scene
