#include "cli/report/area_tables.h"

#include <cmath>

namespace pineda::cli {
namespace {

/// Three digits, but all before the point: "1,024", "87.5", "0.0312".
std::string three_digits(double value) {
  if (value >= 99.95) return grouped(static_cast<uint64_t>(std::llround(value)));
  return fmt::format("{:#.3g}", value);
}

void print_throughput(const Output& output, const std::vector<AreaRow>& rows, bool per_square_mm) {
  output.line("\nMtri/s, Gpix/s{}\n", per_square_mm ? ", both per mm^2" : "");
  std::string head = "| design |", rule = "|---|";
  for (const Throughput& t : rows.front().scenes) {
    head += fmt::format(" {} |", t.scene);
    rule += "---|";
  }
  output.line("{}\n{}", head, rule);
  for (const AreaRow& row : rows) {
    const double unit = per_square_mm ? row.square_mm() : 1;
    std::string cells;
    for (const Throughput& t : row.scenes) {
      cells += fmt::format(" {}, {} |", three_digits(1e-6 * t.triangles_per_second / unit),
                           three_digits(1e-9 * t.pixels_per_second / unit));
    }
    output.line("| `{}` |{}", row.contract.design.name, cells);
  }
}

}  // namespace

void print_area_tables(const Output& output, const std::vector<AreaRow>& rows) {
  output.line(
      "\n| design | um^2 | setup | traversal | interpolation | flip-flops | memory bits | MHz |");
  output.line("|---|---|---|---|---|---|---|---|");
  for (const AreaRow& row : rows) {
    const studies::AreaStudy& a = row.area;
    const auto of = [&](const char* unit) {
      return grouped(static_cast<uint64_t>(std::llround(a.units.at(unit).area_um2)));
    };
    output.line("| `{}` | {} | {} | {} | {} | {} | {} | {:.0f} |", row.contract.design.name,
                grouped(static_cast<uint64_t>(std::llround(a.area_um2))), of("setup"),
                of("traversal"), of("interp_ztest"), grouped(static_cast<uint64_t>(a.flip_flops)),
                grouped(static_cast<uint64_t>(a.memory_bits)), a.fmax_mhz());
  }
  if (rows.front().scenes.empty()) return;
  print_throughput(output, rows, false);
  print_throughput(output, rows, true);
}

}  // namespace pineda::cli
