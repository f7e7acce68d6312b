// Runs what of a study is missing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/run/results.h"
#include "studies/run/study.h"

namespace pineda::studies {

/// Every `of`-th piece of work, from the `number`-th on.
struct Shard {
  size_t number = 0;
  size_t of = 1;
};

struct RunOptions {
  Shard shard;
  size_t jobs = 1;      // processes at once; synthesis, which is parallel in itself, one by one
  std::string made_by;  // the program's version
  std::function<void(size_t done, size_t of)> progress;
  std::function<void(const std::string&)> say;
};

/// A piece of work that has no result, and why.
struct Failure {
  std::string what;  // "bunny, high_tile, ideal: cycles, stalls"
  std::string why;
};

struct RunReport {
  size_t rows = 0;   // of the study, or of its shard
  size_t there = 0;  // of them, before
  size_t added = 0;
  std::vector<Failure> failures;
};

/// Each result is kept as soon as it is there. Another program may do parts of the same study in the
/// same file meanwhile.
///
/// Errors   ResultsError. What goes wrong in a piece of work is a Failure; the others are done.
RunReport run_study(const Study& study, const RunOptions& options, Results* results);

/// Are all rows of a study there?
bool is_whole(const Study& study, const Results& results);

/// Of some rows those of a study, in its order and under its names.
std::vector<Row> rows_of(const Study& study, const std::vector<Row>& rows);

}  // namespace pineda::studies
