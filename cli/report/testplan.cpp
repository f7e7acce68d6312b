#include "cli/report/testplan.h"

#include <fmt/format.h>

#include <fstream>

#include "cli/output.h"
#include "model/files/data_folder.h"

namespace pineda::cli {
namespace {

std::string text_of(const Json& entry, const char* key) {
  const auto at = entry.find(key);
  if (at == entry.end() || !at->is_string() || at->get<std::string>().empty()) {
    throw UsageError(fmt::format("expected a text '{}' in {}", key, entry.dump().substr(0, 80)));
  }
  return *at;
}

std::vector<std::string> texts_of(const Json& entry, const char* key) {
  const auto at = entry.find(key);
  if (at == entry.end() || !at->is_array()) {
    throw UsageError(fmt::format("expected a list '{}' in {}", key, entry.dump().substr(0, 80)));
  }
  std::vector<std::string> all;
  for (const Json& item : *at) {
    if (!item.is_string()) {
      throw UsageError(fmt::format("'{}': expected a text, got {}", key, item.dump()));
    }
    all.push_back(item);
  }
  return all;
}

Testpoint testpoint_of(const Json& entry) {
  Testpoint point{text_of(entry, "name"), text_of(entry, "desc"), text_of(entry, "stage"),
                  texts_of(entry, "tests"), texts_of(entry, "coverage")};
  if (point.stage != "V1" && point.stage != "V2" && point.stage != "V3") {
    throw UsageError(
        fmt::format("{}: expected stage V1, V2 or V3, got '{}'", point.name, point.stage));
  }
  return point;
}

}  // namespace

std::string default_testplan() { return files::data_folder() / "vectors/testplan.hjson"; }

std::vector<Testpoint> read_testplan(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw UsageError(fmt::format("{}: expected a file to read", file));
  std::vector<Testpoint> plan;
  try {
    const Json json = Json::parse(stream, nullptr, true, true);
    if (!json.is_object() || !json.contains("testpoints") || !json["testpoints"].is_array()) {
      throw UsageError("expected a list 'testpoints'");
    }
    for (const Json& entry : json["testpoints"]) plan.push_back(testpoint_of(entry));
  } catch (const Json::exception& error) {
    throw UsageError(fmt::format("{}: expected JSON with comments: {}", file, error.what()));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", file, error.what()));
  }
  return plan;
}

}  // namespace pineda::cli
