#include "studies/run/slurm.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "studies/area/tool_runs.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

std::string shard_file(const SlurmOptions& options, size_t shard) {
  return fmt::format("{}/{}.db", options.folder, shard);
}

/// What each task of the array runs. Its exit code 1, of a piece of work that has no result, is no
/// reason to run it again.
std::string write_script(const SlurmOptions& options) {
  const std::string file = options.folder + "/run.sh";
  std::ofstream script(file);
  script << fmt::format(
      "#!/bin/sh\n"
      "#SBATCH --job-name=pineda --requeue --open-mode=append\n"
      "exec {} study run {} --results {}/$SLURM_ARRAY_TASK_ID.db --shard $SLURM_ARRAY_TASK_ID/{} "
      "--jobs \"${{SLURM_CPUS_PER_TASK:-1}}\" --quiet\n",
      quoted(options.program), quoted(options.study), quoted(options.folder), options.shards);
  script.close();
  if (!script) throw ResultsError(file + ": expected to write it");
  return file;
}

}  // namespace

void run_on_slurm(const SlurmOptions& options, const std::function<bool()>& is_done,
                  Results* results) {
  if (std::system("command -v sbatch >/dev/null 2>&1") != 0) {
    throw ResultsError("--slurm: expected sbatch on the path");
  }
  std::error_code error;
  fs::create_directories(options.folder, error);
  const std::string script = write_script(options);
  constexpr int kAttempts = 3;
  for (int attempt = 0; attempt < kAttempts && !is_done(); ++attempt) {
    const std::vector<Row> there = results->rows();
    for (size_t shard = 0; shard < options.shards; ++shard) {
      Results(shard_file(options, shard), true).add(there);
    }
    options.say(fmt::format("{} tasks submitted, logs in {}", options.shards, options.folder));
    const std::string command =
        fmt::format("sbatch --wait --array=0-{} --output={} {} {} >/dev/null", options.shards - 1,
                    quoted(options.folder + "/%a.log"), options.sbatch, quoted(script));
    const int status = std::system(command.c_str());
    size_t added = 0;
    for (size_t shard = 0; shard < options.shards; ++shard) {
      added += results->add(Results(shard_file(options, shard), false).rows());
    }
    options.say(fmt::format("{} results are new", added));
    if (status != 0 && added == 0) {
      throw ResultsError("--slurm: expected sbatch to run the array; see " + options.folder);
    }
  }
}

}  // namespace pineda::studies
