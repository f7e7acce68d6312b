// The files of pineda time that show time: timeline, waveform of states, heat map.
#pragma once

#include <memory>

#include "cli/job.h"
#include "model/timing/counted/listener.h"

namespace pineda::cli {

struct SeeingOptions {
  std::string timeline;  // files; empty = none
  std::string trace;
  std::string heat_map;
  int64_t from = 0;
  std::optional<int64_t> until;
};

/// Adds --timeline, --trace, --heat-map, --from and --until; none goes with `bench`.
void add_seeing_options(CLI::App* command, SeeingOptions* options, CLI::Option* bench);

/// UsageError in one line where the options make no sense.
void check_seeing_options(const SeeingOptions& options);

/// The files of a frame, each complete or absent.
class Seeing {
 public:
  /// Errors   scene::InputError: a file cannot be written.
  Seeing(const SeeingOptions& options, const Job& job);
  ~Seeing();

  /// What the model reports to; null where there is nothing to see.
  timing::Listener* listener() const;

  /// After the frame: ends the files, says what they are and puts it into the JSON.
  /// Errors   scene::InputError: not everything could be written.
  void finish(timing::Cycle drained, const Output& output, Json* json);

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace pineda::cli
