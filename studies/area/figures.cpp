#include "studies/area/figures.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "studies/area/area_error.h"

namespace pineda::studies {
namespace {

using Json = nlohmann::ordered_json;

struct Figure {
  const char* name;
  double UnitFigures::*value;
};
constexpr Figure kFigures[] = {{"area_um2", &UnitFigures::area_um2},
                               {"slowest_path_ps", &UnitFigures::slowest_path_ps}};

/// Reads a file's JSON; says where it is not as expected.
class FiguresReader {
 public:
  explicit FiguresReader(const std::string& path) : path_(path) {}

  const Json& member(const Json& object, const std::string& key) const {
    if (!object.is_object() || object.count(key) == 0) fail(fmt::format("a member {}", key));
    return object.at(key);
  }
  std::string text(const Json& object, const std::string& key) const {
    const Json& value = member(object, key);
    if (!value.is_string()) fail(fmt::format("{} to be a text", key));
    return value.get<std::string>();
  }
  double positive(const Json& object, const std::string& key) const {
    const Json& value = member(object, key);
    if (!value.is_number() || value.get<double>() <= 0) {
      fail(fmt::format("{} to be a positive number", key));
    }
    return value.get<double>();
  }
  Figures figures(const Json& units) const {
    Figures result;
    for (const char* top : kUnits) {
      const std::string unit = unit_name(top);
      const Json& stored = member(units, unit);
      for (const Figure& figure : kFigures) {
        result[unit].*figure.value = positive(stored, figure.name);
      }
    }
    return result;
  }
  [[noreturn]] void fail(const std::string& expected) const {
    throw AreaError(fmt::format("{}: expected {}", path_, expected));
  }

 private:
  const std::string& path_;
};

}  // namespace

FiguresFile FiguresFile::read(const std::string& path) {
  const FiguresReader reader(path);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) reader.fail("figures, cannot read it");
  const Json json = Json::parse(stream, nullptr, false);
  if (json.is_discarded()) reader.fail("figures in JSON");
  FiguresFile file;
  file.path = path;
  file.design = reader.text(json, "design");
  file.technology = reader.text(json, "technology");
  const double clock_ps = reader.positive(json, "clock_ps");
  if (clock_ps > kMostClockPs || clock_ps != std::floor(clock_ps)) {
    reader.fail(fmt::format("clock_ps to be a whole number up to {}", kMostClockPs));
  }
  file.clock_ps = static_cast<int>(clock_ps);
  const Json& by_tools = reader.member(json, "figures");
  if (!by_tools.is_object()) reader.fail("figures by the versions of the tools");
  for (const auto& [tools, units] : by_tools.items()) file.by_tools[tools] = reader.figures(units);
  return file;
}

std::string FiguresFile::text() const {
  Json json{{"design", design}, {"technology", technology}, {"clock_ps", clock_ps}};
  for (const auto& [tools, units] : by_tools) {
    for (const auto& [unit, figures] : units) {
      for (const Figure& figure : kFigures) {
        json["figures"][tools][unit][figure.name] = std::llround(figures.*figure.value);
      }
    }
  }
  return json.dump(2) + "\n";
}

Figures figures_of(const AreaStudy& study) {
  Figures figures;
  for (const char* top : kUnits) {
    const UnitArea& unit = study.units.at(unit_name(top));
    figures[unit_name(top)] = {std::round(unit.area_um2), std::round(unit.slowest.ps)};
  }
  return figures;
}

std::vector<FigureChange> changes(const Figures& stored, const Figures& measured) {
  std::vector<FigureChange> all;
  for (const char* top : kUnits) {
    const std::string unit = unit_name(top);
    for (const Figure& figure : kFigures) {
      all.push_back(
          {unit, figure.name, stored.at(unit).*figure.value, measured.at(unit).*figure.value});
    }
  }
  return all;
}

Figures updated(const Figures& stored, const Figures& measured) {
  Figures result = stored;
  for (auto& [unit, figures] : result) {
    for (const Figure& figure : kFigures) {
      const double was = figures.*figure.value;
      const double is = measured.at(unit).*figure.value;
      if (std::fabs(is / was - 1) > kFigureTolerance) figures.*figure.value = is;
    }
  }
  return result;
}

}  // namespace pineda::studies
