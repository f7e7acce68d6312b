#include "cli/report/area_ratchet.h"

#include <algorithm>
#include <filesystem>

#include "studies/area/area_error.h"

namespace pineda::cli {
namespace {

using studies::AreaError;
using studies::FigureChange;

/// "slowest path of setup by 3.1 %"
std::string change_text(const FigureChange& change) {
  return fmt::format("{} of {} by {:.1f} %", change.figure == "area_um2" ? "area" : "slowest path",
                     change.unit, 100 * std::abs(change.share()));
}

template <class Which>
std::string texts_of(const std::vector<FigureChange>& changes, Which which) {
  std::vector<std::string> texts;
  for (const FigureChange& change : changes) {
    if (which(change)) texts.push_back(change_text(change));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The units with a path from an input to an output: "setup, traversal".
std::string units_passed_through(const studies::AreaStudy& study) {
  std::vector<std::string> units;
  for (const auto& [name, unit] : study.units) {
    if (unit.through.ps > 0) units.push_back(name);
  }
  return fmt::format("{}", fmt::join(units, ", "));
}

void print_changes(const Output& output, const std::vector<FigureChange>& changes) {
  output.line("\n{:<14}{:<18}{:>12}{:>12}{:>10}", "unit", "figure", "stored", "measured", "");
  for (const FigureChange& c : changes) {
    output.line("{:<14}{:<18}{:>12.0f}{:>12.0f}{:>+8.1f} %", c.unit, c.figure, c.stored, c.measured,
                100 * c.share());
  }
}

}  // namespace

AreaRatchet::AreaRatchet(const AreaRatchetOptions& options, const Subject& subject)
    : options_(options), subject_(subject) {
  if (!options.check.empty()) {
    read(options.check);
    if (file_.by_tools.count(subject.tools) == 0) {
      throw AreaError(fmt::format("{}: no figures of {}: nothing is checked (--update adds them)",
                                  options.check, subject.tools));
    }
    return;
  }
  const int clock_ps = subject.clock_ps > 0 ? subject.clock_ps : subject.first_clock_ps;
  if (std::filesystem::exists(options.update)) {
    read(options.update);
  } else {
    file_ = {options.update, subject.design, subject.technology, clock_ps, {}};
  }
  new_file_.emplace(options.update);
}

void AreaRatchet::read(const std::string& path) {
  file_ = studies::FiguresFile::read(path);
  if (file_.design != subject_.design || file_.technology != subject_.technology) {
    throw AreaError(fmt::format("{}: expected figures of {} on {}, they are of {} on {}", path,
                                subject_.design, subject_.technology, file_.design,
                                file_.technology));
  }
  if (subject_.clock_ps > 0 && subject_.clock_ps != file_.clock_ps) {
    throw AreaError(fmt::format("{}: expected figures at a clock of {} ps, they are at {} ps", path,
                                subject_.clock_ps, file_.clock_ps));
  }
}

bool AreaRatchet::run(const Output& output, const studies::AreaStudy& study, Json* json) {
  const studies::Figures measured = studies::figures_of(study);
  studies::Figures& stored = file_.by_tools.try_emplace(subject_.tools, measured).first->second;
  const auto changes = studies::changes(stored, measured);
  const bool holds = std::none_of(changes.begin(), changes.end(),
                                  [](const FigureChange& change) { return change.has_grown(); });
  print_changes(output, changes);
  const std::string grown = texts_of(changes, [](const auto& c) { return c.has_grown(); });
  const std::string shrunk = texts_of(changes, [](const auto& c) { return c.has_shrunk(); });
  const double percent = 100 * studies::kFigureTolerance;
  if (!shrunk.empty()) {
    output.line("Smaller by more than {:.0f} %: {}{}", percent, shrunk,
                new_file_ ? "" : "; --update stores it");
  }
  const bool is_stored = new_file_ && (holds || options_.allow_growth);
  if (is_stored) {
    stored = studies::updated(stored, measured);
    new_file_->keep(std::fputs(file_.text().c_str(), new_file_->file()) >= 0);
    output.line("{}: stored{}", file_.path, grown.empty() ? "" : ", with what has grown: " + grown);
  } else if (holds) {
    output.line("It holds: no figure has grown by more than {:.0f} %.", percent);
  } else {
    output.line("IT DOES NOT HOLD: more than {:.0f} %: {}{}", percent, grown,
                new_file_ ? "; nothing is stored without --allow-growth" : "");
  }
  const std::string passed_through = units_passed_through(study);
  if (!passed_through.empty()) {
    output.line("IT DOES NOT HOLD: a path leads from an input to an output of {}", passed_through);
  }
  Json& result = (*json)["figures"];
  result = {
      {"file", file_.path}, {"holds", holds && passed_through.empty()}, {"stored", is_stored}};
  for (const FigureChange& c : changes) {
    result["units"][c.unit][c.figure] = {{"stored", c.stored}, {"measured", c.measured}};
  }
  return (holds || is_stored) && passed_through.empty();
}

}  // namespace pineda::cli
