// What a command says: a table for a person, JSON for a program, progress on a terminal.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/options.h"
#include "model/core/frame_counters.h"

namespace pineda::cli {

using Json = nlohmann::ordered_json;

/// Prints figures. With --json - the JSON has standard output to itself and the rest goes to
/// standard error; with --quiet there is no rest.
class Output {
 public:
  explicit Output(const Options& options);

  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) const {
    if (!quiet_) put(fmt::format(format, std::forward<Args>(args)...) + "\n");
  }
  /// A name and what it is, in columns.
  void row(const std::string& name, const std::string& value) const;
  /// A remark on the input that a reader must not miss: to standard error, even with --quiet.
  void warn(const std::string& text) const;
  /// A remark on what takes its time: to standard error, not with --quiet.
  void say(const std::string& text) const;
  /// Writes the JSON where --json wants it. Throws scene::InputError if it cannot.
  void json(const Json& value) const;

 private:
  void put(const std::string& text) const;

  std::string json_;
  bool quiet_;
  std::FILE* file_;
};

/// Throws scene::InputError when something printed did not get through.
void flush_stdout();

/// One line on standard error, rewritten as work goes on; only on a terminal, never with --quiet.
class Progress {
 public:
  explicit Progress(const Options& options);
  ~Progress() { clear(); }
  /// Cheap enough for every triangle.
  void update(const char* phase, uint64_t done);
  void clear();

 private:
  bool shown_;
  bool dirty_ = false;
  std::chrono::steady_clock::time_point last_;
};

/// "1,234,567".
std::string grouped(uint64_t value);

/// Median of wall times in seconds; the mean of the middle two of an even number.
double median(std::vector<double> seconds);

/// Seconds that a call takes.
template <class Call>
double seconds_of(Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Scene, design, size and state, as every command's JSON starts.
Json header_json(const scene::Scene& scene, const spec::Contract& contract);
/// The raster state that differs from the defaults, cull and depth function apart.
Json unusual_state_json(const spec::FrameState& frame);
/// What happened to the scene on its way in.
Json input_json(const scene::Counters& counters);
/// The counters of core::kFrameCounters. Without `depth_tests` the results of depth tests are
/// unknown, and counters that follow from them are left out.
Json counters_json(const core::FrameCounters& counters, bool depth_tests = true);
/// The scene's warnings and notes, one line each.
void print_notes(const Output& output, const scene::Scene& scene);
/// Prints the state of unusual_state_json(), if there is any.
void print_state(const Output& output, const scene::Scene& scene);
void print_counters(const Output& output, const core::FrameCounters& counters,
                    bool depth_tests = true);

}  // namespace pineda::cli
