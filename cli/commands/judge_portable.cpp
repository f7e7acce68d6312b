// pineda judge --portable: a frame for each case of a file.
#include <filesystem>

#include "cli/commands/judge.h"
#include "studies/portable/portable_file.h"

namespace pineda::cli {
namespace {

using studies::FrameVerdict;
using studies::PortableCase;

constexpr size_t kShown = 20;  // cases that fail, in the table; the JSON has all

/// What becomes of the cases.
struct Tally {
  uint64_t cases = 0, judged = 0, samples = 0, samples_wrong = 0;
  std::vector<std::string> not_drawn;
  size_t failing = 0;
  Json failures = Json::array();
  Json rules = Json::object();  // of the first wrong samples: how often each was broken
};

/// Judges the frame in `folder`.
FrameVerdict judge_case(const PortableCase& value, const studies::FrameTolerance& tolerance,
                        const std::string& folder) {
  const auto dump = studies::read_dump(folder, value.frame.width, value.frame.height);
  return studies::judge_frame(value.frame, tolerance, dump, nullptr,
                              [&](const char*, const auto& visit) {
                                for (const auto& triangle : value.triangles) visit(triangle);
                              });
}

void take_failure(const PortableCase& value, const FrameVerdict& verdict, const Output& output,
                  Tally* tally) {
  tally->samples_wrong += verdict.wrong.size();
  if (tally->failing++ == 0) output.line("\n{:<24}{:>10}  {}", "case", "wrong", "first");
  if (tally->failing <= kShown) {
    output.line("{:<24}{:>10}  {}: {}", value.name, verdict.wrong.size(),
                diagnosis_text(*verdict.first), verdict.first->what);
  }
  const char* const rule = spec::name_of(verdict.first->rule);
  tally->rules[rule] = tally->rules.value(rule, 0) + 1;
  Json first = diagnosis_json(*verdict.first);
  tally->failures.push_back(
      {{"case", value.name}, {"samples_wrong", verdict.wrong.size()}, {"first", first}});
}

void print_tally(const JudgeOptions& options, const Tally& tally, const Output& output) {
  if (tally.failing > kShown) {
    output.line("and {} more, which --json has", grouped(tally.failing - kShown));
  }
  if (tally.failing > 0) output.line("");
  output.row("cases", fmt::format("{}, {} of them judged: {} samples", grouped(tally.cases),
                                  grouped(tally.judged), grouped(tally.samples)));
  if (!tally.not_drawn.empty()) {
    output.row("not drawn",
               fmt::format("{}{}, first {}", grouped(tally.not_drawn.size()),
                           options.drawn_only ? " (left out)" : "", tally.not_drawn.front()));
  }
  output.row("cases wrong",
             fmt::format("{}: {} samples", grouped(tally.failing), grouped(tally.samples_wrong)));
  for (const auto& [rule, count] : tally.rules.items()) {
    output.row("", fmt::format("{} by {}", count.get<int>(), rule));
  }
}

}  // namespace

int judge_portable(const JudgeOptions& options) {
  const Output output(options);
  Progress progress(options);
  require_ending("-o", options.out, {".tri"});
  std::optional<ReservedFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  studies::PortableReader reader(options.portable);
  studies::FrameTolerance tolerance = reader.header().tolerance;
  tolerance.depth_ulp = options.depth_ulp.value_or(tolerance.depth_ulp);
  tolerance.color_lsb = options.color_lsb.value_or(tolerance.color_lsb);
  output.line("{}: frames in {}", options.portable, options.dump);
  output.row("tolerance", fmt::format("{} subpixel bits, {} depth bits, {} ulp, {} LSB",
                                      tolerance.format.subpixel_bits, tolerance.format.depth_bits,
                                      tolerance.depth_ulp, tolerance.color_lsb));
  Tally tally;
  for (PortableCase value; reader.next(&value);) {
    progress.update("judging", ++tally.cases);
    const std::string folder = (std::filesystem::path(options.dump) / value.name).string();
    if (!std::filesystem::exists(folder)) {
      tally.not_drawn.push_back(value.name);
      continue;
    }
    const FrameVerdict verdict = judge_case(value, tolerance, folder);
    ++tally.judged;
    tally.samples += value.samples();
    if (verdict.holds()) continue;
    if (tally.failing == 0 && out) {
      write_smallest_scene(options, value.frame, *verdict.first, &*out, output);
    }
    take_failure(value, verdict, output, &tally);
  }
  progress.clear();
  if (tally.judged == 0) {
    throw UsageError(fmt::format("{}: expected a folder for each case of {}, there is none",
                                 options.dump, options.portable));
  }
  print_tally(options, tally, output);
  const bool holds = tally.failing == 0 && (options.drawn_only || tally.not_drawn.empty());
  output.line("{}", holds ? "It holds." : "IT DOES NOT HOLD.");
  Json json{{"file", options.portable},
            {"subpixel_bits", tolerance.format.subpixel_bits},
            {"depth_bits", tolerance.format.depth_bits},
            {"depth_ulp", tolerance.depth_ulp},
            {"color_lsb", tolerance.color_lsb},
            {"cases", tally.cases},
            {"judged", tally.judged},
            {"not_drawn", tally.not_drawn},
            {"samples", tally.samples},
            {"verdict", holds ? "holds" : "fails"},
            {"cases_wrong", tally.failing},
            {"samples_wrong", tally.samples_wrong},
            {"rules", tally.rules},
            {"failures", tally.failures}};
  if (tally.failing > 0) {
    json["first"] = tally.failures.front().at("first");
    json["first"]["case"] = tally.failures.front().at("case");
  }
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace pineda::cli
