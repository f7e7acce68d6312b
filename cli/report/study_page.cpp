#include "cli/report/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "cli/output.h"
#include "model/files/data_folder.h"
#include "model/spec/design_file.h"
#include "studies/picture/svg.h"

namespace pineda::cli {
namespace {

using studies::Row;

std::string text_of(const std::string& file, const std::string& otherwise) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || text.str().empty()) throw UsageError(fmt::format("expected {}: {}", file, otherwise));
  return text.str();
}

std::string part(const std::string& name) {
  return text_of((files::data_folder() / "studies/run/page" / name).string(),
                 "it comes with pineda");
}

/// What is in some column of the rows of a measure that depends on `on`, in the order of the rows.
std::vector<std::string> values(const std::vector<Row>& rows, std::string Row::*column,
                                bool is_technology) {
  std::vector<std::string> all;
  for (const Row& row : rows) {
    const auto on = spec::row_of(*spec::named<studies::Measure>(row.measure)).on;
    if ((on == studies::DependsOn::kTechnology) != is_technology || (row.*column).empty()) continue;
    if (std::find(all.begin(), all.end(), row.*column) == all.end()) all.push_back(row.*column);
  }
  return all;
}

Json data(const studies::Study& study, const std::vector<Row>& rows) {
  Json json{{"scenes", values(rows, &Row::scene, false)},
            {"memories", values(rows, &Row::memory, false)},
            {"technologies", values(rows, &Row::memory, true)}};
  for (const spec::Design& d : study.designs) {
    json["designs"].push_back(
        {{"name", d.name},
         {"stamp", fmt::format("{}x{}", 1 << d.stamp_width_log2, 1 << d.stamp_height_log2)},
         {"toml", spec::design_toml(d, spec::kHighTile)}});
  }
  json["rows"] = Json::array();
  for (const Row& row : rows) {
    Json figures = Json::object();
    for (const studies::Figure& f : row.figures) figures[f.name] = f.value;
    json["rows"].push_back({{"measure", row.measure},
                            {"scene", row.scene},
                            {"design", row.design},
                            {"memory", row.memory},
                            {"figures", figures}});
  }
  return json;
}

/// What stands in a script must not end it.
std::string in_script(std::string text) {
  for (size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3)
    text.replace(at, 2, "<\\/");
  return text;
}

void put(const std::string& mark, const std::string& text, std::string* html) {
  for (size_t at = 0; (at = html->find(mark, at)) != std::string::npos; at += text.size()) {
    html->replace(at, mark.size(), text);
  }
}

}  // namespace

std::string study_page_html(const studies::Study& study, const std::vector<Row>& rows) {
  const std::string d3 = text_of(kD3File, "install libjs-d3");
  std::set<std::string> made_by;
  for (const Row& row : rows) made_by.insert(row.made_by);
  std::string versions;
  for (const std::string& one : made_by)
    versions += fmt::format("<li>{}</li>", studies::escaped(one));
  std::string html = part("report.html");
  put("@TITLE@", studies::escaped("Study " + study.name), &html);
  put("@SUMMARY@",
      fmt::format("{} designs, {} scenes; {} results", study.designs.size(), study.scenes.size(),
                  grouped(rows.size())),
      &html);
  put("@MADE_BY@", versions, &html);
  put("@CSS@", part("report.css"), &html);
  // The longest last: nothing is looked for in them.
  put("@JS@", part("report.js"), &html);
  put("@DATA@", in_script(data(study, rows).dump()), &html);
  put("@D3@", in_script(d3), &html);
  return html;
}

}  // namespace pineda::cli
