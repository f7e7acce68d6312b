#include "studies/error/error_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/error/error_pictures.h"
#include "studies/error/error_table.h"
#include "studies/picture/numbers.h"
#include "studies/picture/svg.h"

namespace pineda::studies {
namespace {

constexpr int kSmallFramePx = 320;  // frames below this are shown in large pixels

constexpr const char* kStyle =
    "body{font:15px/1.45 system-ui,sans-serif;color:#1c2430;background:#fff;margin:2rem auto;"
    "max-width:72rem;padding:0 1rem}h1{font-size:1.5rem;margin:0 0 .2rem}"
    "h2{font-size:1.05rem;margin:2rem 0 .4rem}p{margin:.2rem 0 .6rem;max-width:52rem}"
    ".good{color:#12703a;font-weight:600}.bad{color:#b3261e;font-weight:600}"
    "svg{max-width:100%;height:auto;display:block;margin-bottom:1rem}"
    ".scroll{overflow-x:auto}table{border-collapse:collapse;font-size:14px}"
    "th,td{padding:.15rem .55rem;text-align:right;border-bottom:1px solid #e3e6ea;"
    "font-variant-numeric:tabular-nums;font-weight:400;white-space:nowrap}"
    "thead th{color:#5a6573;border:0;padding-bottom:0}thead tr+tr th{border-bottom:1px solid "
    "#5a6573}"
    ".text{text-align:left;padding-left:1.6rem}.group{padding-left:1.6rem}"
    "tr>:first-child{padding-left:0}tbody+tbody{border-top:2px solid #9aa4b0}"
    ".design th{color:#0069a8;font-weight:600}.baseline th{color:#c2500a}"
    ".note{color:#5a6573;font-size:13px}.maps{display:grid;gap:1rem;"
    "grid-template-columns:repeat(auto-fill,minmax(15rem,1fr))}figure{margin:0}"
    "img{width:100%;height:auto;background:#000;display:block}.small img{image-rendering:pixelated}"
    "figcaption{font-size:13px;color:#5a6573}figcaption b{color:#1c2430;font-weight:600}"
    "@media print{body{margin:0;max-width:none}figure,svg,tr{break-inside:avoid}}";

std::string rows(const Table& table, bool designs) {
  std::string html = fmt::format("<tbody class=\"{}\">\n", designs ? "design" : "baseline");
  for (const auto& cells : designs ? table.designs : table.baselines) {
    html += "<tr>";
    for (size_t i = 0; i < cells.size(); ++i) {
      const Column& column = table.columns[i];
      const char* tag = i == 0 ? "th" : "td";
      const char* kind = column.is_text ? "text" : column.group.empty() ? "" : "group";
      html += fmt::format("<{0} class=\"{1}\">{2}</{0}>", tag, kind, escaped(cells[i]));
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n";
}

std::string table_html(const Table& table) {
  std::string groups;
  std::string names;
  for (const Column& column : table.columns) {
    const char* kind = column.is_text ? "text" : column.group.empty() ? "" : "group";
    groups += fmt::format("<th class=\"{}\">{}</th>", kind, escaped(column.group));
    names += fmt::format("<th class=\"{}\">{}</th>", kind, escaped(column.name));
  }
  std::string html = fmt::format(
      "<div "
      "class=\"scroll\"><table>\n<thead><tr>{}</tr>\n<tr>{}</tr></thead>\n{}{}</table></div>\n",
      groups, names, rows(table, true), rows(table, false));
  for (const auto& note : table.notes) {
    html += fmt::format("<p class=\"note\">{}</p>\n", escaped(note));
  }
  return html;
}

std::string verdict(const ErrorStudy& study) {
  if (study.holds()) {
    return "<p class=\"good\">It holds: every design covers the right samples and keeps its "
           "bounds.</p>\n";
  }
  std::string names;
  for (const Subject& s : study.subjects) {
    if (s.is_design && !s.holds()) names += (names.empty() ? "" : ", ") + s.name;
  }
  return fmt::format("<p class=\"bad\">It does not hold: {}.</p>\n", escaped(names));
}

std::string plot(const ErrorStudy& study, const std::string& scene, Quantity quantity, Pace pace) {
  return inlined(speed_error_svg(study, scene, quantity, pace));
}

std::string tables(const ErrorStudy& study) {
  std::string html =
      "<h2>Accuracy</h2>\n<p>Missing: samples that a triangle covers and the subject leaves out. "
      "Extra: samples that it draws and the triangle does not cover, or draws twice. Errors are "
      "those of the final codes against exact arithmetic, at every sample rightly covered, hidden "
      "ones included: the largest, the one that 99.9 % do not exceed, the root mean square, and "
      "the percentage of codes that are not the nearest one (off). Bound: what the design promises "
      "for any triangle.</p>\n";
  if (study.affine_lsb > 0) {
    html += fmt::format(
        "<p>Colours are judged as affine interpolation. In this scene perspective-correct colours "
        "differ from that by up to {} LSB.</p>\n",
        figure(study.affine_lsb));
  }
  html += table_html(accuracy(study));
  html +=
      "<h2>Speed</h2>\n<p>Software: millions of triangles and of covered samples a second on this "
      "computer, the frame in memory; for designs that is the speed of their model. Cycles: for "
      "designs those of the cycle model, for the whole frame, divided by its triangles and by its "
      "covered samples.</p>\n";
  return html + table_html(speed(study));
}

std::string gallery(const ErrorStudy& study) {
  const auto has_map = [](const Subject& s) { return !s.map.depth_ulp.empty(); };
  if (std::none_of(study.subjects.begin(), study.subjects.end(), has_map)) return {};
  std::string html = fmt::format(
      "<h2>Where the error is</h2>\n<p>The largest depth error at each pixel, over all triangles "
      "that cover it. One scale for all.</p>\n{}<div class=\"maps{}\">\n",
      inlined(error_scale_svg({study, Quantity::kDepth})),
      study.width < kSmallFramePx ? " small" : "");
  for (const Subject& s : study.subjects) {
    if (!has_map(s)) continue;
    const uint64_t wrong = s.missing + s.extra;
    html += fmt::format(
        "<figure><a href=\"{0}\"><img src=\"{0}\" width=\"{1}\" height=\"{2}\" alt=\"depth error "
        "of "
        "{3}\"></a><figcaption><b>{3}</b>: {4}{5}</figcaption></figure>\n",
        map_file(s), study.width, study.height, escaped(s.name),
        s.depth.count() == 0 ? "nothing judged" : "up to " + figure(s.depth.max()) + " ulp",
        wrong == 0 ? "" : fmt::format("; samples wrong: {}", count_figure(wrong)));
  }
  return html + "</div>\n";
}

}  // namespace

std::string error_page(const ErrorStudy& study, const std::string& scene) {
  return fmt::format(
             "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width\">\n"
             "<title>pineda error {0}</title>\n<style>{1}</style>\n<h1>{0}</h1>\n"
             "<p>{2} × {3} px, {4} triangles judged, {5} covered samples, hidden ones "
             "included</p>\n",
             escaped(scene), kStyle, study.width, study.height, grouped(study.triangles),
             grouped(study.samples)) +
         verdict(study) +
         "<h2>Speed against error</h2>\n<p>Down and to the right is better. Hollow: some samples "
         "are missing or wrong, so that the speed is that of another picture.</p>\n" +
         plot(study, scene, Quantity::kDepth, Pace::kHost) + tables(study) +
         "<h2>The same in hardware, and for colours</h2>\n" +
         plot(study, scene, Quantity::kDepth, Pace::kClock) +
         plot(study, scene, Quantity::kColor, Pace::kHost) +
         "<h2>Histograms</h2>\n<p>An octave begins at its lower end: an error of exactly ½ stands "
         "to the right of the line.</p>\n" +
         inlined(histogram_svg(study)) + gallery(study) + "</html>\n";
}

}  // namespace pineda::studies
