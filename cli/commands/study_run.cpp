// pineda study run, export and compare: results that last.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <thread>

#include "cli/output.h"
#include "cli/report/study_page.h"
#include "cli/reserved_file.h"
#include "cli/study_file.h"
#include "studies/run/compare.h"
#include "studies/run/derived.h"
#include "studies/run/results.h"
#include "studies/run/rows_csv.h"
#include "studies/run/run.h"
#include "studies/run/slurm.h"

namespace pineda::cli {
namespace {

namespace fs = std::filesystem;

struct RunOptions : Options {
  std::string study;
  std::string results;
  int jobs = 0;  // 0: as many as there are processors
  std::string shard;
  int slurm = 0;  // tasks of an array
  std::string sbatch;
};

/// "2/8": shard 2 of 8, counted from 0.
studies::Shard shard_of(const std::string& text) {
  if (text.empty()) return {};
  unsigned number = 0, of = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%5u/%5u%c", &number, &of, &rest) != 2 || number >= of) {
    throw UsageError(fmt::format("--shard: expected I/N with I from 0 to N - 1, got '{}'", text));
  }
  return {number, of};
}

std::string of_a_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) {
    return (value < 0 ? "-" : "") + grouped(static_cast<uint64_t>(std::abs(value)));
  }
  return fmt::format("{:.5g}", value);
}

/// The figures that a row's line shows; the others are in the export.
std::string shown(const studies::Row& row) {
  constexpr size_t kMost = 6;
  std::string text;
  size_t left = row.figures.size();
  for (const studies::Figure& f : row.figures) {
    if (row.figures.size() - left == kMost) break;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", f.name, of_a_number(f.value));
    --left;
  }
  return left == 0 ? text : fmt::format("{}, and {} more", text, left);
}

void print_rows(const Output& output, const std::vector<studies::Row>& rows) {
  std::string place;
  for (const studies::Row& row : rows) {
    const std::string here = place_of(row);
    if (here != place) output.line("{}", place = here);
    output.line("  {:<11}{}", row.measure, shown(row));
  }
}

/// A number with its unit's exponent, "-" where there is none.
std::string scaled(std::optional<double> value, double by, int digits) {
  return value ? fmt::format("{:.{}f}", *value * by, digits) : "-";
}

void print_throughputs(const Output& output, const std::vector<studies::Throughput>& all) {
  if (all.empty()) return;
  output.line("\n{:<44}{:<16}{:>9}{:>11}{:>11}{:>13}{:>11}{:>11}", "at the design's fastest clock",
              "technology", "MHz", "Mtri/s", "Mpix/s", "Mpix/s/mm^2", "read MB/s", "write MB/s");
  for (const studies::Throughput& t : all) {
    std::optional<double> for_area;
    if (t.area_mm2) for_area = t.samples_per_second / *t.area_mm2;
    output.line("{:<44}{:<16}{:>9.0f}{:>11.2f}{:>11.1f}{:>13}{:>11}{:>11}",
                fmt::format("{}, {}, {}", t.scene, t.design, t.memory), t.technology, t.fmax_mhz,
                1e-6 * t.triangles_per_second, 1e-6 * t.samples_per_second,
                scaled(for_area, 1e-6, 0), scaled(t.read_mb_per_second, 1, 0),
                scaled(t.written_mb_per_second, 1, 0));
  }
}

Json throughput_json(const studies::Throughput& t) {
  Json json{{"scene", t.scene},
            {"design", t.design},
            {"memory", t.memory},
            {"technology", t.technology},
            {"fmax_mhz", t.fmax_mhz},
            {"triangles_per_second", t.triangles_per_second},
            {"pixels_per_second", t.samples_per_second}};
  const auto add = [&](const char* name, std::optional<double> value) {
    if (value) json[name] = *value;
  };
  add("area_mm2", t.area_mm2);
  add("read_mb_per_second", t.read_mb_per_second);
  add("written_mb_per_second", t.written_mb_per_second);
  add("depth_hit_rate", t.depth_hit_rate);
  add("color_hit_rate", t.color_hit_rate);
  return json;
}

Json row_json(const studies::Row& row) {
  Json json{{"scene", row.scene},     {"design", row.design}, {"memory", row.memory},
            {"measure", row.measure}, {"key", row.key},       {"made_by", row.made_by}};
  for (const studies::Figure& f : row.figures) json["figures"][f.name] = f.value;
  return json;
}

Json rows_json(const std::vector<studies::Row>& rows) {
  Json json = Json::array();
  for (const studies::Row& row : rows) json.push_back(row_json(row));
  return json;
}

/// "STUDY.csv" beside "STUDY.toml", if it is there.
std::string committed_rows(const std::string& study) {
  const std::string csv = fs::path(study).replace_extension(".csv").string();
  return fs::exists(csv) ? csv : "";
}

std::string time_left(double seconds_so_far, size_t done, size_t of) {
  const double left = seconds_so_far / static_cast<double>(done) * static_cast<double>(of - done);
  const auto seconds = static_cast<uint64_t>(std::ceil(left));
  return fmt::format("{} of {} results, about {}:{:02} left", done, of, seconds / 60, seconds % 60);
}

void run_on_slurm(const RunOptions& options, const studies::Study& study, const std::string& path,
                  const Output& output, studies::Results* results) {
  studies::SlurmOptions slurm;
  slurm.shards = static_cast<size_t>(options.slurm);
  slurm.program = fs::read_symlink("/proc/self/exe").string();
  slurm.study = fs::absolute(options.study).string();
  slurm.folder = fs::absolute(fs::path(path).replace_extension(".slurm")).string();
  slurm.sbatch = options.sbatch;
  slurm.say = [&](const std::string& text) { output.say(text); };
  studies::run_on_slurm(
      slurm, [&] { return studies::is_whole(study, *results); }, results);
}

void say_what_is_there(const RunOptions& options, const StudyFile& file,
                       const studies::Results& results, const studies::RunReport& report,
                       double seconds, const Output& output) {
  const auto rows = studies::rows_of(file.study, results.rows());
  const auto throughputs = studies::throughputs(rows);
  constexpr size_t kMostRows = 200;
  if (rows.size() <= kMostRows) {
    print_rows(output, rows);
    print_throughputs(output, throughputs);
    if (!rows.empty()) output.line("");
  }
  output.row("Study", fmt::format("{}: {} designs, {} scenes", file.study.name,
                                  file.study.designs.size(), file.study.scenes.size()));
  output.row("Results",
             fmt::format("{} of {} are in {}{}", grouped(report.there + report.added),
                         grouped(report.rows), results.file(),
                         rows.size() > kMostRows ? ": see study report and export" : ""));
  output.row("New", report.there == report.rows
                        ? "nothing to do"
                        : fmt::format("{} in {:.1f} s", grouped(report.added), seconds));
  if (file.left_out > 0) {
    output.warn(fmt::format("{}: {} combinations cannot be built and are left out; the first: {}",
                            options.study, file.left_out, file.reason));
  }
  for (const studies::Failure& failure : report.failures) {
    output.warn(fmt::format("{}: {}", failure.what, failure.why));
  }
  Json json{{"study", file.study.name},
            {"results", results.file()},
            {"designs", file.study.designs.size()},
            {"scenes", file.study.scenes.size()},
            {"left_out", file.left_out},
            {"rows", report.rows},
            {"there", report.there},
            {"added", report.added},
            {"failed", report.failures.size()},
            {"seconds", seconds}};
  for (const studies::Failure& failure : report.failures) {
    json["failures"].push_back({{"what", failure.what}, {"why", failure.why}});
  }
  json["values"] = rows_json(rows);
  json["throughput"] = Json::array();
  for (const studies::Throughput& t : throughputs) json["throughput"].push_back(throughput_json(t));
  output.json(json);
}

int run(const RunOptions& options) {
  const Output output(options);
  Progress progress(options);
  const StudyFile file = read_study(options.study);
  const std::string path =
      options.results.empty() ? fs::path(options.study).filename().replace_extension(".db").string()
                              : options.results;
  studies::Results results(path, true);
  if (const std::string csv = committed_rows(options.study); !csv.empty()) {
    const size_t read = results.add(studies::read_csv(csv));
    if (read > 0) output.say(fmt::format("{} rows read from {}", grouped(read), csv));
  }

  if (options.slurm > 0) run_on_slurm(options, file.study, path, output, &results);
  studies::RunOptions run;
  run.shard = shard_of(options.shard);
  run.jobs = options.jobs > 0 ? static_cast<size_t>(options.jobs)
                              : std::max(1u, std::thread::hardware_concurrency());
  run.made_by = "pineda " PINEDA_VERSION;
  run.say = [&](const std::string& text) {
    progress.clear();
    output.say(text);
  };
  const auto start = std::chrono::steady_clock::now();
  run.progress = [&](size_t done, size_t of) {
    const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - start;
    progress.update(time_left(so_far.count(), done, of).c_str(), 0);
  };
  const studies::RunReport report = studies::run_study(file.study, run, &results);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  progress.clear();

  say_what_is_there(options, file, results, report, seconds.count(), output);
  return report.failures.empty() ? kHolds : kMismatch;
}

std::vector<studies::Row> rows_of(const std::string& file) {
  if (fs::path(file).extension() == ".csv") return studies::read_csv(file);
  return studies::Results(file, false).rows();
}

// ---- Report

struct ReportOptions : Options {
  std::string study;
  std::string results;
  std::string out;
};

/// STUDY.db, if it is there or nothing else is, else STUDY.csv.
std::string results_of(const std::string& study, const std::string& asked) {
  if (!asked.empty()) return asked;
  const std::string own = fs::path(study).filename().replace_extension(".db").string();
  const std::string csv = committed_rows(study);
  return fs::exists(own) || csv.empty() ? own : csv;
}

int report(const ReportOptions& options) {
  const Output output(options);
  require_ending("--out", options.out, {".html"});
  const StudyFile file = read_study(options.study);
  const std::string from = results_of(options.study, options.results);
  const auto rows = studies::rows_of(file.study, rows_of(from));
  if (rows.empty())
    throw UsageError(fmt::format("{}: expected results of {}, got none", from, options.study));
  const std::string html = study_page_html(file.study, rows);
  ReservedFile page(options.out);
  page.keep(std::fputs(html.c_str(), page.file()) >= 0);
  output.line("{}: {} results of {}", options.out, grouped(rows.size()), from);
  output.json({{"page", options.out}, {"rows", rows.size()}});
  return kHolds;
}

// ---- Export

struct ExportOptions : Options {
  std::string results;
  std::string csv;
  bool host_speed = false;
};

int export_rows(const ExportOptions& options) {
  if (options.csv.empty() && options.json.empty()) throw UsageError("expected --csv or --json");
  if (options.csv == "-" && options.json == "-")
    throw UsageError("--csv, --json: expected one of them to be a file");
  Options to = options;
  if (options.csv == "-") to.quiet = true;
  const Output output(to);
  auto rows = rows_of(options.results);
  if (!options.host_speed) {
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [](const studies::Row& row) {
                                return row.measure == spec::name_of(studies::Measure::kHostSpeed);
                              }),
               rows.end());
  }
  const std::string text = studies::csv_of(rows);
  if (options.csv == "-") {
    std::fputs(text.c_str(), stdout);
  } else if (!options.csv.empty()) {
    ReservedFile file(options.csv);
    file.keep(std::fputs(text.c_str(), file.file()) >= 0);
  }
  output.line("{} rows of {}", grouped(rows.size()), options.results);
  output.json(rows_json(rows));
  return kHolds;
}

// ---- Merge

struct MergeOptions : Options {
  std::string into;
  std::vector<std::string> from;
};

int merge(const MergeOptions& options) {
  const Output output(options);
  std::vector<studies::Row> rows;
  for (const std::string& file : options.from) {
    const auto more = rows_of(file);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  studies::Results into(options.into, true);
  const size_t added = into.add(rows);
  output.line("{} rows are new in {}, {} were there", grouped(added), options.into,
              grouped(rows.size() - added));
  output.json({{"rows", rows.size()}, {"added", added}});
  return kHolds;
}

// ---- Compare

struct CompareOptions : Options {
  std::string before, after;
  double within_percent = 0;
  bool gate = false;
};

std::string change_text(const studies::Change& change) {
  const std::string share =
      change.before == 0 ? "" : fmt::format("{:+.2f} %", 100 * change.share());
  return fmt::format("{:<44} {:<30}{:>16}{:>16}{:>11}", place_of(*change.row),
                     change.row->measure + " " + change.figure, of_a_number(change.before),
                     of_a_number(change.after), share);
}

int compare(const CompareOptions& options) {
  const Output output(options);
  const auto before = rows_of(options.before);
  const auto after = rows_of(options.after);
  const studies::Comparison c = studies::compare(before, after, options.within_percent / 100);
  constexpr size_t kMost = 40;
  if (!c.changes.empty()) {
    output.line("{:<44} {:<30}{:>16}{:>16}", "", "", "before", "after");
  }
  for (size_t i = 0; i < std::min(kMost, c.changes.size()); ++i) {
    output.line("{}", change_text(c.changes[i]));
  }
  if (c.changes.size() > kMost)
    output.line("and {} more: --json has all", c.changes.size() - kMost);
  output.row("Compared", fmt::format("{} figures of {} rows", grouped(c.figures), grouped(c.rows)));
  output.row("Changed", grouped(c.changes.size()));
  output.row("Only before", grouped(c.only_before.size()));
  output.row("Only after", grouped(c.only_after.size()));
  Json json{{"rows", c.rows},
            {"figures", c.figures},
            {"changed", c.changes.size()},
            {"only_before", c.only_before.size()},
            {"only_after", c.only_after.size()},
            {"changes", Json::array()}};
  for (const studies::Change& change : c.changes) {
    json["changes"].push_back({{"scene", change.row->scene},
                               {"design", change.row->design},
                               {"memory", change.row->memory},
                               {"measure", change.row->measure},
                               {"figure", change.figure},
                               {"before", change.before},
                               {"after", change.after}});
  }
  output.json(json);
  const bool holds = c.changes.empty() && c.only_before.empty();
  return options.gate && !holds ? kMismatch : kHolds;
}

}  // namespace

namespace {

void add_run(CLI::App* study, int* exit_code) {
  auto options = std::make_shared<RunOptions>();
  auto* command = study->add_subcommand(
      "run", "Scenes x designs x memories x measures: what is missing of a study");
  command
      ->add_option("study", options->study,
                   "Scenes, designs, memories, technologies, measures: docs/studies.md")
      ->required()
      ->type_name("STUDY.toml");
  command
      ->add_option(
          "-r,--results", options->results,
          "Where results are kept; STUDY.db unless given. Rows of STUDY.csv are added first")
      ->type_name("FILE.db");
  command
      ->add_option("-j,--jobs", options->jobs,
                   "Processes at once; as many as there are processors unless given")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  auto* shard = command->add_option("--shard", options->shard,
                                    "Every N-th piece of work, from the I-th on, from 0");
  shard->type_name("I/N");
  auto* slurm = command->add_option(
      "--slurm", options->slurm,
      "First as an array of N tasks of Slurm; STUDY.slurm has their results and logs");
  slurm->check(CLI::Range(1, 10'000))->type_name("N")->excludes(shard);
  command->add_option("--sbatch", options->sbatch, "Further options for sbatch")
      ->needs(slurm)
      ->type_name("OPTIONS");
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

void add_report(CLI::App* study, int* exit_code) {
  auto reports = std::make_shared<ReportOptions>();
  auto* reporter =
      study->add_subcommand("report", "A study's results as one page that opens from a file");
  reporter->add_option("study", reports->study, "The study")->required()->type_name("STUDY.toml");
  reporter
      ->add_option("-r,--results", reports->results,
                   "Its results; STUDY.db or STUDY.csv unless given")
      ->type_name("FILE.db|FILE.csv");
  reporter->add_option("-o,--out", reports->out, "The page")->required()->type_name("FILE.html");
  add_output_options(reporter, reports.get());
  reporter->callback([reports, exit_code] { *exit_code = report(*reports); });
}

void add_export(CLI::App* study, int* exit_code) {
  auto exports = std::make_shared<ExportOptions>();
  auto* exporter = study->add_subcommand("export", "The results of studies as CSV or JSON");
  exporter->add_option("results", exports->results, "Results")
      ->required()
      ->type_name("FILE.db|FILE.csv");
  exporter->add_option("--csv", exports->csv, "A line a figure, - for stdout")->type_name("FILE");
  exporter->add_flag("--host-speed", exports->host_speed, "Also rows that depend on the machine");
  add_output_options(exporter, exports.get());
  exporter->callback([exports, exit_code] { *exit_code = export_rows(*exports); });
}

void add_merge(CLI::App* study, int* exit_code) {
  auto merges = std::make_shared<MergeOptions>();
  auto* merger = study->add_subcommand("merge", "Adds results to others");
  merger->add_option("into", merges->into, "Results; made if they are not there")
      ->required()
      ->type_name("FILE.db");
  merger->add_option("from", merges->from, "Results that are added")
      ->required()
      ->type_name("FILE.db|FILE.csv");
  add_output_options(merger, merges.get());
  merger->callback([merges, exit_code] { *exit_code = merge(*merges); });
}

void add_compare(CLI::App* study, int* exit_code) {
  auto compares = std::make_shared<CompareOptions>();
  auto* comparer = study->add_subcommand("compare", "What changed between two sets of results");
  comparer->add_option("before", compares->before, "Results")
      ->required()
      ->type_name("FILE.db|FILE.csv");
  comparer->add_option("after", compares->after, "Results")
      ->required()
      ->type_name("FILE.db|FILE.csv");
  comparer->add_option("--within", compares->within_percent, "Figures may differ by so much, %")
      ->check(CLI::Range(0., 1000.))
      ->type_name("PERCENT");
  comparer->add_flag("--gate", compares->gate,
                     "Exit 1 if a figure differs by more, or a row is missing");
  add_output_options(comparer, compares.get());
  comparer->callback([compares, exit_code] { *exit_code = compare(*compares); });
}

}  // namespace

void add_run_study(CLI::App* study, int* exit_code) {
  for (const auto add : {add_run, add_report, add_export, add_merge, add_compare})
    add(study, exit_code);
}

}  // namespace pineda::cli
