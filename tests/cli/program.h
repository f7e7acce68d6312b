// Runs the pineda program, as another program would.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pineda::test {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

/// A folder of its own, removed with all it holds.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file, making its folder; returns its path.
  std::string write(const std::string& name, const std::string& bytes) const;
  /// Every file under `folder` of the scratch, sorted, by its path from there.
  std::vector<std::string> files(const std::string& folder = {}) const;

 private:
  std::filesystem::path folder_;
};

std::string read_bytes(const std::string& path);

struct Outcome {
  int exit_code = -1;  // -1: killed by a signal
  std::string out;
  std::string err;
  int64_t peak_kib = 0;  // the most memory it held

  /// Standard output as JSON; fails the test when it is not JSON alone.
  Json json() const;
};

/// Where a run happens, and what it reads and writes.
struct Surroundings {
  std::string input;   // bytes on standard input, through a pipe
  std::string in;      // or a path to read it from
  std::string folder;  // working directory; empty: the test's own
  std::string program = PINEDA_PROGRAM;
  std::string out;                   // standard output goes to this path; empty: to Outcome::out
  bool error_is_a_terminal = false;  // standard error
};

/// The surroundings of a run in that working directory.
Surroundings inside(const std::string& folder);

/// Runs `pineda ARGUMENTS...` to its end.
Outcome pineda(const Arguments& arguments, const Surroundings& surroundings = {});

/// `pineda ARGUMENTS... --json -`, which must exit 0.
Json figures(Arguments arguments, const Surroundings& surroundings = {});

/// Did the run end with `exit_code`, and say nothing on standard error?
testing::AssertionResult ended_silently(const Outcome& run, int exit_code = 0);

/// Did it exit 2, with one line on standard error that holds `part`, and print no figures?
testing::AssertionResult is_refused(const Outcome& run, const std::string& part);

/// The commands that take a scene.
inline const std::vector<std::string> kSceneCommands = {"render", "time", "rtl", "check"};

/// An environment variable for as long as this lives; the program inherits it.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name); old != nullptr) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (old_) {
      setenv(name_, old_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

}  // namespace pineda::test
