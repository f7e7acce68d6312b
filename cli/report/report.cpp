#include "cli/report/report.h"

#include "cli/output.h"
#include "studies/picture/svg.h"

namespace pineda::cli {
namespace {

using studies::escaped;

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escaped(name), escaped(value));
}

std::string cycles_of(const Side& side) {
  return grouped(static_cast<uint64_t>(side.frame.cycles));
}

std::string side_row(const Side& s) {
  return fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                     escaped(s.name), grouped(s.compared), grouped(s.mismatches),
                     grouped(s.differing_samples), cycles_of(s));
}

std::string first_retire_table(const CheckResult& r) {
  if (!r.first_retire) return {};
  std::string table = "<h2>Where the cycles part</h2>\n<table>\n";
  for (const auto& [name, value] : difference_rows(*r.first_retire)) table += row(name, value);
  return table + "</table>\n";
}

constexpr const char* kStyle =
    "body{font:15px/1.45 system-ui,sans-serif;color:#1c2430;margin:2rem auto;max-width:72rem;"
    "padding:0 1rem}h1{font-size:1.5rem;margin:0 0 .2rem}h2{font-size:1.05rem;margin:1.6rem 0 "
    ".4rem}"
    "p{margin:.2rem 0}.good{color:#12703a;font-weight:600}.bad{color:#b3261e;font-weight:600}"
    "table{border-collapse:collapse}th,td{padding:.2rem 1.4rem .2rem 0;text-align:left;"
    "border-bottom:1px solid #e3e6ea;font-variant-numeric:tabular-nums}th{font-weight:500}"
    ".sides td,.sides thead th+th{text-align:right}.sides thead "
    "th{color:#5a6573}.pictures{display:flex;"
    "flex-wrap:wrap;gap:1rem}.pictures figure{margin:0;flex:1 1 20rem}img{width:100%;"
    "background:#000}.small "
    "img{image-rendering:pixelated;max-width:24rem}figcaption{color:#5a6573}code{font-size:13px}";

std::string dropped_text(const core::FrameCounters& c) {
  std::string text;
  for (int i = 1; i < core::kDropCauses; ++i) {
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(c.dropped[static_cast<size_t>(i)]),
                    core::drop_name(static_cast<core::Drop>(i)));
  }
  return text;
}

}  // namespace

std::string cycles_text(const CheckResult& r) {
  const std::string text = fmt::format("{} model, {} RTL", cycles_of(r.model), cycles_of(r.rtl));
  if (r.cycle_error() <= studies::kCycleErrorBound) return text;
  return fmt::format("{}: {:.2f} % apart, bound {:.1f} %", text, 100 * r.cycle_error(),
                     100 * studies::kCycleErrorBound);
}

std::string counters_text(const CheckResult& r) {
  return fmt::format(
      "{} compared, {}", r.counters_compared,
      r.counters_differ.empty() ? "all equal" : grouped(r.counters_differ.size()) + " differ");
}

std::string depth_error_text(const Judgement& j) {
  if (j.bounds.depth_ulp == 0) return "none: the design has no depth";
  return fmt::format("{:.4f} ulp at most, bound {:.4f}", j.max_depth_ulp, j.bounds.depth_ulp);
}

std::string color_error_text(const Judgement& j) {
  const std::string error = fmt::format("{:.4f} LSB at most", j.max_color_lsb);
  if (j.bounds.attribute_lsb == 0) return error + ": a triangle has its first vertex's colour";
  return fmt::format("{}, bound {:.4f}", error, j.bounds.attribute_lsb);
}

std::string report_html(const CheckResult& r, const scene::Scene& scene,
                        const spec::Contract& contract, const std::string& settings) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>pineda check {0}</title>\n"
      "<style>{1}</style>\n<h1>{0}</h1>\n<p>{2} x {3} px, design {4}</p>\n"
      "<p class=\"{5}\">{6}</p>\n",
      escaped(scene.name), kStyle, scene.frame.width, scene.frame.height,
      escaped(contract.design.name), r.holds() ? "good" : "bad",
      r.holds() ? "It holds: three ways, bit-identical, and within the bounds."
                : "It does not hold.");
  page += fmt::format("<div class=\"pictures{}\">", scene.frame.width < 320 ? " small" : "");
  page +=
      "<figure><img src=\"color.png\" alt=\"colour\">"
      "<figcaption>colour</figcaption></figure><figure><img src=\"depth.png\" alt=\"depth\">"
      "<figcaption>depth, near is bright</figcaption></figure></div>\n";
  page +=
      "<h2>Against the functional model, at every unit boundary</h2>\n<table class=\"sides\">"
      "<thead><tr><th></th><th>tokens compared</th><th>mismatches</th><th>samples that differ</th>"
      "<th>cycles</th></tr></thead>\n";
  page += side_row(r.model) + side_row(r.rtl) + "</table>\n";
  for (const Side* side : {&r.model, &r.rtl}) {
    if (!side->first_divergence.empty()) {
      page +=
          fmt::format("<p class=\"bad\"><code>{}</code></p>\n", escaped(side->first_divergence));
    }
  }
  page += fmt::format("<p>Cycles: {}. Retirement: {}. Counters: {}.</p>\n", escaped(cycles_text(r)),
                      escaped(retire_text(r.retire)), escaped(counters_text(r)));
  page += first_retire_table(r);
  page += "<h2>Against exact arithmetic</h2>\n<table>\n";
  page += row("samples judged", grouped(r.judgement.samples));
  page += row("missing, too many",
              fmt::format("{}, {}", grouped(r.judgement.missing), grouped(r.judgement.extra)));
  page += row("depth error", depth_error_text(r.judgement));
  page += row("colour error", color_error_text(r.judgement));
  if (r.judgement.mesh) page += row("mesh", mesh_text(*r.judgement.mesh));
  if (r.judgement.beyond > 0) {
    page += row("samples beyond their bounds", grouped(r.judgement.beyond));
  }
  page += "</table>\n<h2>Work</h2>\n<table>\n";
  page += row("settings", settings);
  page += row("triangles read", grouped(r.input.triangles));
  page += row("triangles set up", grouped(r.counters.triangles));
  page += row("dropped", dropped_text(r.counters));
  page += row("tiles tested",
              fmt::format("{}, {} rejected, {} accepted whole", grouped(r.counters.tiles_tested),
                          grouped(r.counters.tiles_rejected), grouped(r.counters.tiles_accepted)));
  page += row("stamps", grouped(r.counters.stamps));
  page += row("covered samples", fmt::format("{}, {} written", grouped(r.counters.fragments),
                                             grouped(r.counters.passed)));
  for (const auto& note : scene::notes(scene)) page += row("input", note);
  return page + "</table>\n</html>\n";
}

}  // namespace pineda::cli
