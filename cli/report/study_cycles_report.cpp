#include "cli/report/study_cycles_report.h"

#include <algorithm>
#include <cmath>

namespace pineda::cli {
namespace {

std::string speed_text(double speed) { return speed > 0 ? fmt::format("{:.2f}", speed) : "-"; }
std::string ratio_text(double model, double rtl) {
  return model > 0 && rtl > 0 ? fmt::format("{:.1f}", model / rtl) : "-";
}

void add(const CycleRow& row, CycleWorst* worst) {
  const auto& p = row.point;
  ++worst->rows;
  worst->off += p.is_off() ? 1 : 0;
  worst->counters_off = std::max(worst->counters_off, p.counters_off);
  worst->error = std::max(worst->error, p.error());
  worst->p99 = std::max(worst->p99, p.retire.p99);
  worst->max = std::max(worst->max, p.retire.max);
  worst->holds = worst->holds && row.holds();
}

}  // namespace

void print_columns(const Output& output) {
  output.line(
      "{:<14}{:>10}{:>12}{:>12}{:>9} {:>7}{:>5}{:>6}{:>9}{:>9}  {:>6} {:<13}{:>8}{:>8}{:>8}{:>8}",
      "", "", "cycles", "", "error", "retire", "", "", "", "counters", "RTL", "", "model", "",
      "ratio", "");
  output.line(
      "{:<14}{:>10}{:>12}{:>12}{:>9} {:>7}{:>5}{:>6}{:>9}{:>9}  {:>6} {:<13}{:>8}{:>8}{:>8}{:>8}",
      "scene", "triangles", "model", "RTL", "%", "off", "p99", "max", "triangle", "off", "Mc/s",
      "by", "time", "bits", "time", "bits");
}

void print_row(const Output& output, const CycleRow& r) {
  const auto& retire = r.point.retire;
  const auto* fastest = r.point.fastest();
  output.line(
      "{:<14}{:>10}{:>12}{:>12}{:>9.4f} {:>7}{:>5}{:>6}{:>9}{:>9}  {:>6} "
      "{:<13}{:>8}{:>8}{:>8}{:>8}",
      r.scene, grouped(r.triangles), grouped(static_cast<uint64_t>(r.point.model_cycles)),
      grouped(static_cast<uint64_t>(r.point.rtl_cycles)), 100 * r.point.error(), retire.off,
      retire.p99, retire.max, retire.off > 0 ? fmt::format("{}", retire.worst) : "-",
      r.point.counters_off, speed_text(r.rtl_speed()),
      fastest != nullptr ? fastest->compiler.data() : "-", speed_text(r.time_speed()),
      speed_text(r.bits_speed()), ratio_text(r.time_speed(), r.rtl_speed()),
      ratio_text(r.bits_speed(), r.rtl_speed()));
}

Json row_json(const CycleRow& r) {
  const auto& p = r.point;
  Json json{{"scene", r.scene},
            {"width", r.size.width},
            {"height", r.size.height},
            {"design", r.design},
            {"memory", r.memory},
            {"stall", r.stall},
            {"triangles", r.triangles},
            {"model_cycles", p.model_cycles},
            {"rtl_cycles", p.rtl_cycles},
            {"error", p.error()},
            {"same_frame", p.same_frame},
            {"holds", r.holds()},
            {"counters_compared", p.counters},
            {"counters_off", p.counters_off},
            {"retire",
             {{"triangles", p.retire.triangles},
              {"off", p.retire.off},
              {"p99_cycles", p.retire.p99},
              {"max_cycles", p.retire.max},
              {"worst_triangle", p.retire.worst}}}};
  if (r.latency_cycles) json["depth_latency_cycles"] = *r.latency_cycles;
  if (p.counters_off > 0) json["first_counter_off"] = p.first_counter.data();
  for (size_t i = 0; i < p.compilers; ++i) {
    json["rtl_seconds"][p.rtl[i].compiler.data()] = p.rtl[i].seconds;
  }
  if (const auto* fastest = p.fastest(); fastest != nullptr) {
    json["compiler"] = fastest->compiler.data();
    json["speed"] = {{"rtl", r.rtl_speed()}, {"time", r.time_speed()}, {"bits", r.bits_speed()}};
    json["ratio"] = {{"time", r.time_speed() / r.rtl_speed()},
                     {"bits", r.bits_speed() / r.rtl_speed()}};
  }
  return json;
}

std::vector<CycleWorst> worst_of(const std::vector<CycleRow>& rows) {
  std::vector<CycleWorst> designs;
  CycleWorst all;
  all.design = "all";
  for (const CycleRow& row : rows) {
    if (designs.empty() || designs.back().design != row.design) {
      designs.emplace_back();
      designs.back().design = row.design;
    }
    add(row, &designs.back());
    add(row, &all);
  }
  if (designs.size() > 1) designs.push_back(all);
  return designs;
}

void print_worst(const Output& output, const std::vector<CycleWorst>& all) {
  output.line("{:<14}{:>6}{:>10}{:>10}{:>7}{:>7}{:>10}  {}", "worst", "rows", "rows off", "error %",
              "p99", "max", "counters", "");
  for (const CycleWorst& w : all) {
    output.line("{:<14}{:>6}{:>10}{:>10.4f}{:>7}{:>7}{:>10}  {}", w.design, w.rows, w.off,
                100 * w.error, w.p99, w.max, w.counters_off, w.holds ? "" : "does not hold");
  }
}

Json worst_json(const std::vector<CycleWorst>& all) {
  Json json = Json::array();
  for (const CycleWorst& w : all) {
    json.push_back({{"design", w.design},
                    {"rows", w.rows},
                    {"rows_off", w.off},
                    {"error", w.error},
                    {"p99_cycles", w.p99},
                    {"max_cycles", w.max},
                    {"counters_off", w.counters_off},
                    {"holds", w.holds}});
  }
  return json;
}

CycleMeans means_of(const std::vector<CycleRow>& rows) {
  double rtl = 0, time = 0, bits = 0;
  int count = 0;
  for (const CycleRow& r : rows) {
    if (r.rtl_speed() <= 0) continue;
    rtl += std::log(r.rtl_speed());
    time += std::log(r.time_speed());
    bits += std::log(r.bits_speed());
    ++count;
  }
  if (count == 0) return {};
  return {std::exp(rtl / count), std::exp(time / count), std::exp(bits / count)};
}

void print_means(const Output& output, const CycleMeans& means) {
  output.line("Geometric means: RTL {}, model {} (time), {} (bits): ratio {}, {}",
              speed_text(means.rtl), speed_text(means.time), speed_text(means.bits),
              ratio_text(means.time, means.rtl), ratio_text(means.bits, means.rtl));
}

Json means_json(const CycleMeans& means) {
  return {{"rtl", means.rtl},
          {"time", means.time},
          {"bits", means.bits},
          {"ratio_time", means.time / means.rtl},
          {"ratio_bits", means.bits / means.rtl}};
}

}  // namespace pineda::cli
