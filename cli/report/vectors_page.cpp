#include "cli/report/vectors_page.h"

#include <utility>

#include "studies/picture/svg.h"

namespace pineda::cli {
namespace {

using studies::escaped;

constexpr const char* kStyle =
    "body{font:15px/1.45 system-ui,sans-serif;color:#1c2430;background:#fff;margin:2rem auto;"
    "max-width:88rem;padding:0 1rem}h1{font-size:1.5rem;margin:0 0 .2rem}"
    "h2{font-size:1.15rem;margin:2.2rem 0 .4rem}p{margin:.2rem 0 .6rem;max-width:56rem}"
    ".good{color:#12703a}.bad{color:#b3261e;font-weight:600}.grey{color:#5a6573}"
    "table{border-collapse:collapse;font-size:14px;width:100%}"
    "th,td{padding:.2rem 1rem .2rem 0;text-align:left;vertical-align:top;font-weight:400;"
    "border-bottom:1px solid #e3e6ea;font-variant-numeric:tabular-nums}"
    "thead th{color:#5a6573;border-bottom:1px solid #5a6573}.n{text-align:right;white-space:nowrap}"
    ".plan td+td+td+td{white-space:nowrap}.plan code{font-size:12px}"
    "code{font:13px/1.4 ui-monospace,monospace;overflow-wrap:anywhere}"
    ".tiles{display:flex;flex-wrap:wrap;gap:1rem;margin:1rem 0}"
    ".tiles div{flex:1 1 11rem;border:1px solid #e3e6ea;border-radius:.4rem;padding:.6rem .9rem}"
    ".tiles b{display:block;font-size:1.4rem;font-weight:600;font-variant-numeric:tabular-nums}"
    ".bar{display:inline-block;width:5rem;height:.55rem;background:#f0c9c6;margin-right:.6rem;"
    "vertical-align:baseline}.bar i{display:block;height:100%;background:#12703a}"
    "details{border-bottom:1px solid #e3e6ea;padding:.15rem 0}details table{margin:.3rem 0 .6rem "
    "1.2rem;width:calc(100% - 1.2rem)}summary{cursor:pointer;display:grid;gap:0 1rem;"
    "grid-template-columns:16rem 12rem 1fr}summary.file{grid-template-columns:20rem 15rem 1fr}"
    "summary::before{content:none}summary:hover{background:#f5f7f9}nav a{margin-right:1.2rem;"
    "color:#0069a8}.waived{color:#5a6573}"
    "@media print{body{margin:0;max-width:none}}";

std::string cell(const std::string& html, const char* kind = "") {
  return fmt::format("<td{}>{}</td>", *kind == 0 ? "" : fmt::format(" class=\"{}\"", kind), html);
}

std::string number(uint64_t value) { return cell(grouped(value), "n"); }

std::string code(const std::string& text) { return "<code>" + escaped(text) + "</code>"; }

std::string head(std::initializer_list<std::pair<const char*, const char*>> names) {
  std::string row = "<table><thead><tr>";
  for (const auto& [name, kind] : names) {
    row += fmt::format("<th class=\"{}\">{}</th>", kind, escaped(name));
  }
  return row + "</tr></thead>\n";
}

/// A bar and "12 of 13".
std::string share(uint64_t hit, uint64_t all) {
  const double percent = all == 0 ? 100 : 100 * static_cast<double>(hit) / static_cast<double>(all);
  return fmt::format(
      "<span class=\"{}\"><span class=\"bar\"><i style=\"width:{:.1f}%\"></i></span>"
      "{} of {}</span>",
      hit == all ? "good" : "bad", percent, grouped(hit), grouped(all));
}

struct Bins {
  uint64_t reachable = 0, hit = 0;
  Bins& operator+=(const Bins& other) {
    reachable += other.reachable;
    hit += other.hit;
    return *this;
  }
};

Bins bins_of(const vectors::PointHits& point) {
  Bins bins;
  for (size_t i = 0; i < point.bins.size(); ++i) {
    if (!point.bins[i].unreachable.empty()) continue;
    ++bins.reachable;
    bins.hit += point.count[i] > 0 ? 1 : 0;
  }
  return bins;
}

Bins bins_of(const UnitBins& unit) {
  Bins all;
  for (const vectors::PointHits& point : unit.points()) all += bins_of(point);
  return all;
}

Bins bins_of(const std::list<UnitBins>& units, const std::string& point_name) {
  Bins all;
  for (const UnitBins& unit : units) {
    for (const vectors::PointHits& point : unit.points()) {
      if (point.name == point_name) all += bins_of(point);
    }
  }
  return all;
}

std::string tile(const std::string& value, const std::string& what, bool is_good) {
  return fmt::format("<div><b class=\"{}\">{}</b>{}</div>\n", is_good ? "good" : "bad", value,
                     escaped(what));
}

std::string summary(const VectorsPage& page) {
  Bins bins;
  for (const UnitBins& unit : page.bins) bins += bins_of(unit);
  std::string html = "<div class=\"tiles\">\n";
  html += tile(grouped(page.plan.size()), "testpoints", true);
  html += tile(fmt::format("{} of {}", grouped(bins.hit), grouped(bins.reachable)),
               "reachable bins hit", bins.hit == bins.reachable);
  const CodeTally &lines = page.code.lines, &toggles = page.code.toggles;
  html += tile(fmt::format("{:.1f} %", lines.percent()),
               fmt::format("of {} lines of the RTL, {} waived", grouped(lines.points()),
                           grouped(lines.waived)),
               lines.missed == 0);
  html += tile(fmt::format("{:.1f} %", toggles.percent()),
               fmt::format("of {} bits of the RTL rise and fall, {} waived",
                           grouped(toggles.points()), grouped(toggles.waived)),
               toggles.percent() >= kLeastToggles);
  uint64_t mutants = 0, survivors = 0;
  for (const UnitMutants& unit : page.mutants) {
    mutants += unit.mutants;
    survivors += unit.surviving();
  }
  if (mutants > 0) {
    html += tile(grouped(survivors), fmt::format("of {} mutants survive", grouped(mutants)),
                 survivors == 0);
  }
  return html + "</div>\n";
}

std::string plan_html(const VectorsPage& page) {
  std::string html =
      "<h2 id=\"plan\">Test plan</h2>\n<p>Reachable bins of each point that are hit; none: neither "
      "the design nor the units run have the point.</p>\n<div class=\"plan\">";
  html += head({{"testpoint", ""}, {"stage", ""}, {"shows", ""}, {"coverage", ""}, {"tests", ""}});
  for (const Testpoint& point : page.plan) {
    std::string coverage, tests;
    for (const std::string& name : point.coverage) {
      const Bins bins = bins_of(page.bins, name);
      coverage += fmt::format("<div>{} {}</div>", escaped(name),
                              bins.reachable == 0
                                  ? std::string("<span class=\"grey\">none here</span>")
                                  : fmt::format("<span class=\"{}\">{} of {}</span>",
                                                bins.hit == bins.reachable ? "good" : "bad",
                                                grouped(bins.hit), grouped(bins.reachable)));
    }
    for (const std::string& name : point.tests) tests += "<div>" + code(name) + "</div>";
    html += "<tr>" + cell(escaped(point.name)) + cell(escaped(point.stage)) +
            cell(escaped(point.desc)) + cell(coverage) + cell(tests) + "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string names_of(const UnitBins::Hitters& hitters) {
  std::string text;
  for (const std::string& name : hitters.names) text += (text.empty() ? "" : ", ") + escaped(name);
  const uint64_t more = hitters.cases - hitters.names.size();
  if (more > 0) text += fmt::format(" <span class=\"grey\">and {} more</span>", grouped(more));
  return text;
}

std::string bins_html(const UnitBins& unit) {
  const Bins all = bins_of(unit);
  std::string html =
      fmt::format("<h2>Bins of {}: {} of {} hit by {} cases</h2>\n", spec::name_of(unit.unit()),
                  grouped(all.hit), grouped(all.reachable), grouped(unit.cases()));
  if (unit.not_timed() > 0) {
    html += fmt::format(
        "<p class=\"grey\">{} frames of more than {} samples are not seen in time.</p>\n",
        grouped(unit.not_timed()), grouped(vectors::kTimedSamples));
  }
  for (size_t p = 0; p < unit.points().size(); ++p) {
    const vectors::PointHits& point = unit.points()[p];
    const Bins bins = bins_of(point);
    html += fmt::format(
        "<details><summary><span>{}</span><span>{}</span><span class=\"grey\">{}"
        "</span></summary>\n",
        escaped(point.name), share(bins.hit, bins.reachable), escaped(point.what));
    html += head({{"bin", ""}, {"hits", "n"}, {"cases", "n"}, {"which", ""}});
    for (size_t i = 0; i < point.bins.size(); ++i) {
      const vectors::Bin& bin = point.bins[i];
      const UnitBins::Hitters& hitters = unit.hitters(p, i);
      const std::string which =
          !bin.unreachable.empty()
              ? "<span class=\"grey\">unreachable: " + escaped(bin.unreachable) + "</span>"
          : hitters.cases == 0 ? "<span class=\"bad\">not hit</span>"
                               : names_of(hitters);
      html += "<tr>" + cell(escaped(bin.name)) + number(point.count[i]) + number(hitters.cases) +
              cell(which) + "</tr>\n";
    }
    html += "</table></details>\n";
  }
  return html;
}

std::string file_html(const FileCoverage& file) {
  std::string html = fmt::format(
      "<details><summary class=\"file\"><span>{}</span><span>{}</span><span>{}</span></summary>\n",
      code(file.file), share(file.lines.hit, file.lines.points()),
      share(file.toggles.hit, file.toggles.points()));
  if (file.gaps.empty()) return html + "<p class=\"grey\">Nothing is missed.</p></details>\n";
  html += head({{"line", "n"}, {"not hit", ""}, {"points", "n"}, {"waived, since", ""}});
  for (const CodeGap& gap : file.gaps) {
    html += fmt::format("<tr class=\"{}\">", gap.waiver == nullptr ? "" : "waived") +
            cell(fmt::format("{}", gap.line), "n") + cell(code(gap.what)) + number(gap.points) +
            cell(gap.waiver == nullptr ? std::string() : escaped(gap.waiver->reason)) + "</tr>\n";
  }
  return html + "</table></details>\n";
}

std::string code_html(const CodeCoverage& coverage) {
  std::string html =
      "<h2 id=\"code\">Code of the RTL</h2>\n<p>By file: blocks and branches that run, bits that "
      "rise and fall, as Verilator counts them while the vectors run. What is waived is not "
      "counted.</p>\n<details open><summary class=\"file grey\"><span>file</span><span>lines"
      "</span><span>bits</span></summary></details>\n";
  for (const FileCoverage& file : coverage.files) html += file_html(file);
  return html;
}

std::string mutants_html(const VectorsPage& page) {
  std::string html = "<h2 id=\"mutants\">Mutants</h2>\n";
  if (page.mutants.empty()) {
    html +=
        "<p class=\"grey\">Mutants of the RTL: not scored; --mutants FILE.json adds them.</p>\n";
  } else {
    html += head({{"mutants of the RTL", ""},
                  {"all", "n"},
                  {"killed by level 1", "n"},
                  {"by level 2", "n"},
                  {"equivalent", "n"},
                  {"undecided", "n"},
                  {"surviving", "n"}});
    for (const UnitMutants& u : page.mutants) {
      html += "<tr>" + cell(escaped(u.unit)) + number(u.mutants) + number(u.killed_level1) +
              number(u.killed_level2) + number(u.equivalent) + number(u.undecided) +
              cell(fmt::format("<span class=\"{}\">{}</span>", u.surviving() == 0 ? "good" : "bad",
                               grouped(u.surviving())),
                   "n") +
              "</tr>\n";
    }
    html += "</table>\n";
  }
  html += fmt::format(
      "<p>Mutants of the functional model: {}. <code>scripts/core-mutants</code> builds each, runs "
      "the committed vectors on it, and fails where one survives.</p>\n<details><summary>which"
      "</summary>\n",
      grouped(page.core.size()));
  html += head({{"file", ""}, {"text", ""}, {"what takes its place", ""}});
  for (const CoreMutant& m : page.core) {
    html +=
        "<tr>" + cell(code(m.file)) + cell(code(m.text)) + cell(code(m.replacement)) + "</tr>\n";
  }
  return html + "</table></details>\n";
}

}  // namespace

void UnitBins::note(const std::string& name) {
  ++cases_;
  const std::vector<vectors::PointHits> before = std::exchange(points_, coverage_.points());
  hitters_.resize(points_.size());
  for (size_t p = 0; p < points_.size(); ++p) {
    hitters_[p].resize(points_[p].bins.size());
    for (size_t i = 0; i < points_[p].bins.size(); ++i) {
      const uint64_t earlier = before.empty() ? 0 : before[p].count[i];
      if (points_[p].count[i] == earlier) continue;
      Hitters& hitters = hitters_[p][i];
      if (hitters.cases++ < kNames) hitters.names.push_back(name);
    }
  }
}

uint64_t UnitMutants::surviving() const {
  const uint64_t told = killed_level1 + killed_level2 + equivalent + undecided;
  return mutants > told ? mutants - told : 0;
}

std::string vectors_page_html(const VectorsPage& page) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>pineda vectors report {0}</title>\n<style>{1}</style>\n"
      "<h1>Verification of {0}</h1>\n<p class=\"grey\">{2}</p>\n"
      "<nav><a href=\"#plan\">Test plan</a><a href=\"#bins\">Bins</a><a href=\"#code\">Code</a>"
      "<a href=\"#mutants\">Mutants</a></nav>\n",
      escaped(page.design), kStyle, escaped(page.settings));
  html += summary(page) + plan_html(page) + "<div id=\"bins\">\n";
  for (const UnitBins& unit : page.bins) html += bins_html(unit);
  return html + "</div>\n" + code_html(page.code) + mutants_html(page) + "</html>\n";
}

}  // namespace pineda::cli
