// A study on many machines: a job array of Slurm.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "studies/run/results.h"

namespace pineda::studies {

struct SlurmOptions {
  size_t shards = 1;    // tasks of the array
  std::string program;  // pineda, where the nodes find it
  std::string study;    // STUDY.toml, likewise
  std::string
      folder;  // for the shards' results, their logs and the script; nodes and this machine share it
  std::string sbatch;  // further options, as one has them for sbatch
  std::function<void(const std::string&)> say;
};

/// Runs a study's shards as an array and waits. Each task keeps its results in a file of its own, which
/// starts with those that are there, so a task that Slurm puts back, since its node has died, goes on
/// where it was. Then all are added to *results. What is missing of them then is submitted again, twice
/// at most, as long as `is_done` does not hold.
///
/// Errors   ResultsError: sbatch is not there, or takes no job; the folder cannot be written.
void run_on_slurm(const SlurmOptions& options, const std::function<bool()>& is_done,
                  Results* results);

}  // namespace pineda::studies
