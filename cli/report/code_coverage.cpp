#include "cli/report/code_coverage.h"

#include <map>
#include <optional>
#include <tuple>

#include "model/files/data_folder.h"
#include "model/spec/package.h"

namespace pineda::cli {
namespace {

using vectors::CodePoint;
using vectors::JudgedPoint;

void count(const JudgedPoint& p, CodeTally* tally) {
  ++(p.point.is_hit ? tally->hit : p.waiver != nullptr ? tally->waived : tally->missed);
}

// Bits of one signal in a row are one gap.
struct Bits {
  std::string signal;
  int line, low, high;
  const vectors::CodeWaiver* waiver;

  CodeGap gap() const {
    const std::string index = low < 0       ? ""
                              : low == high ? fmt::format("[{}]", low)
                                            : fmt::format("[{}:{}]", high, low);
    return {line, true, signal + index, static_cast<uint64_t>(high - low + 1), waiver};
  }
};

std::vector<CodeGap> gaps_of(const std::vector<const JudgedPoint*>& points,
                             vectors::RtlSource* source) {
  std::vector<CodeGap> gaps;
  std::map<std::tuple<int, std::string, int>, const vectors::CodeWaiver*> bits;
  for (const JudgedPoint* p : points) {
    const CodePoint& point = p->point;
    if (point.is_hit) continue;
    if (point.is_bit) {
      const auto [signal, bit] = vectors::split_bit(point.name);
      bits[{point.line, signal, bit}] = p->waiver;
      continue;
    }
    gaps.push_back({point.line, false, point.name + ": " + source->line(point.file, point.line), 1,
                    p->waiver});
  }
  std::optional<Bits> row;
  for (const auto& [place, waiver] : bits) {
    const auto& [line, signal, bit] = place;
    if (row && row->signal == signal && row->line == line && row->high + 1 == bit && bit > 0 &&
        row->waiver == waiver) {
      row->high = bit;
      continue;
    }
    if (row) gaps.push_back(row->gap());
    row = Bits{signal, line, bit, bit, waiver};
  }
  if (row) gaps.push_back(row->gap());
  return gaps;
}

std::string percent_text(const CodeTally& tally) {
  return tally.points() == 0 ? "-" : fmt::format("{:.1f}", tally.percent());
}

void print_row(const Output& output, const std::string& name, const CodeTally& lines,
               const CodeTally& toggles) {
  output.line("{:<40}{:>7}{:>7}{:>7}{:>7}  {:>7}{:>7}{:>7}{:>7}", name, lines.points(), lines.hit,
              percent_text(lines), lines.waived, toggles.points(), toggles.hit,
              percent_text(toggles), toggles.waived);
}

Json tally_json(const CodeTally& tally) {
  return {{"points", tally.points()},
          {"hit", tally.hit},
          {"waived", tally.waived},
          {"percent", tally.percent()}};
}

}  // namespace

double CodeTally::percent() const {
  return points() == 0 ? 100 : 100 * static_cast<double>(hit) / static_cast<double>(points());
}

std::string default_code_waivers() {
  return files::data_folder() / "vectors/coverage/code_waivers.toml";
}

CodeCoverage code_coverage(const vectors::CodeCounts& counts,
                           std::vector<vectors::CodeWaiver> waivers,
                           const spec::Contract& contract) {
  CodeCoverage coverage;
  coverage.waivers = std::move(waivers);
  vectors::RtlSource source(spec::package_text(contract));
  const std::vector<JudgedPoint> judged =
      judge_points(counts.points(), coverage.waivers, contract.design.name, &source);
  std::map<std::string, std::vector<const JudgedPoint*>> files;
  for (const JudgedPoint& p : judged) files[p.point.file].push_back(&p);
  for (const auto& [name, points] : files) {
    FileCoverage file{name, {}, {}, gaps_of(points, &source)};
    for (const JudgedPoint* p : points) {
      count(*p, p->point.is_bit ? &file.toggles : &file.lines);
      count(*p, p->point.is_bit ? &coverage.toggles : &coverage.lines);
    }
    coverage.files.push_back(std::move(file));
  }
  return coverage;
}

void print_code_coverage(const Output& output, const CodeCoverage& coverage) {
  output.line("\n{:<40}{:>28}  {:>28}", "", "lines", "toggles");
  output.line("{:<40}{:>7}{:>7}{:>7}{:>7}  {:>7}{:>7}{:>7}{:>7}", "file", "points", "hit", "%",
              "waived", "points", "hit", "%", "waived");
  bool is_missed = false;
  for (const FileCoverage& file : coverage.files) {
    print_row(output, file.file, file.lines, file.toggles);
    is_missed |= file.lines.missed + file.toggles.missed > 0;
  }
  print_row(output, "all", coverage.lines, coverage.toggles);
  if (is_missed) output.line("\nnot hit");
  for (const FileCoverage& file : coverage.files) {
    for (const CodeGap& gap : file.gaps) {
      if (gap.waiver == nullptr) output.line("  {}:{}: {}", file.file, gap.line, gap.what);
    }
  }
}

Json code_coverage_json(const CodeCoverage& coverage) {
  Json json{{"lines", tally_json(coverage.lines)}, {"toggles", tally_json(coverage.toggles)}};
  for (const FileCoverage& file : coverage.files) {
    Json& entry = json["files"][file.file];
    entry = {{"lines", tally_json(file.lines)}, {"toggles", tally_json(file.toggles)}};
    for (const char* list : {"missed", "waived"}) entry[list] = Json::array();
    for (const CodeGap& gap : file.gaps) {
      Json one{{"line", gap.line},
               {"kind", gap.is_bits ? "toggle" : "line"},
               {"what", gap.what},
               {"points", gap.points}};
      if (gap.waiver != nullptr) one["reason"] = gap.waiver->reason;
      entry[gap.waiver == nullptr ? "missed" : "waived"].push_back(one);
    }
  }
  return json;
}

}  // namespace pineda::cli
