#include "tests/cli/program.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pineda::test {
namespace fs = std::filesystem;
namespace {

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

Pipe make_pipe() {
  int ends[2];
  // Closed on exec: a child that inherited the other end would never see its input end.
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

/// A pseudo-terminal: what is written to write_end can be read from read_end.
Pipe make_terminal() {
  Pipe ends;
  if (openpty(&ends.read_end, &ends.write_end, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("no pseudo-terminal");
  }
  fcntl(ends.read_end, F_SETFD, FD_CLOEXEC);
  fcntl(ends.write_end, F_SETFD, FD_CLOEXEC);
  return ends;
}

/// Puts a file in the place of one end.
void replace(int* end, const std::string& path, int mode) {
  close(*end);
  *end = open(path.c_str(), mode | O_CLOEXEC);
  if (*end < 0) throw std::runtime_error("cannot open " + path);
}

void write_all(int to, const std::string& bytes) {
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = write(to, bytes.data() + done, bytes.size() - done);
    if (count <= 0) break;  // the program need not read to the end
    done += static_cast<size_t>(count);
  }
  close(to);
}

void read_all(int from, std::string* to) {
  char buffer[1 << 16];
  // A pseudo-terminal ends with an error when its other side closes.
  for (ssize_t count = 1; count > 0;) {
    count = read(from, buffer, sizeof buffer);
    if (count > 0) to->append(buffer, static_cast<size_t>(count));
  }
  close(from);
}

/// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become_pineda(char* const* argv, const char* folder, int in, int out, int err) {
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  signal(SIGPIPE, SIG_DFL);
  if (*folder == '\0' || chdir(folder) == 0) execv(argv[0], argv);
  _exit(127);
}

}  // namespace

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "pineda_cli_test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
  folder_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string Scratch::write(const std::string& name, const std::string& bytes) const {
  fs::create_directories(fs::path(path(name)).parent_path());
  std::ofstream(path(name), std::ios::binary) << bytes;
  return path(name);
}

std::vector<std::string> Scratch::files(const std::string& folder) const {
  std::vector<std::string> all;
  if (!fs::exists(folder_ / folder)) return all;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / folder)) {
    if (!entry.is_directory()) all.push_back(entry.path().lexically_relative(folder_ / folder));
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string read_bytes(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

Json Outcome::json() const {
  Json value = Json::parse(out, nullptr, false);
  EXPECT_FALSE(value.is_discarded()) << "not JSON alone: " << out;
  return value;
}

Surroundings inside(const std::string& folder) {
  Surroundings surroundings;
  surroundings.folder = folder;
  return surroundings;
}

Outcome pineda(const Arguments& arguments, const Surroundings& surroundings) {
  signal(SIGPIPE, SIG_IGN);  // the program may refuse its input before it is all written
  Pipe in = make_pipe();
  const Pipe err = surroundings.error_is_a_terminal ? make_terminal() : make_pipe();
  Pipe out = make_pipe();
  if (!surroundings.in.empty()) replace(&in.read_end, surroundings.in, O_RDONLY);
  if (!surroundings.out.empty()) replace(&out.write_end, surroundings.out, O_WRONLY);

  std::string program = surroundings.program;
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{program.data()};
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    become_pineda(argv.data(), surroundings.folder.c_str(), in.read_end, out.write_end,
                  err.write_end);
  }
  close(in.read_end);
  close(out.write_end);
  close(err.write_end);

  Outcome run;
  std::thread feed([&] { write_all(in.write_end, surroundings.input); });
  std::thread listen([&] { read_all(err.read_end, &run.err); });
  read_all(out.read_end, &run.out);
  feed.join();
  listen.join();
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  run.peak_kib = used.ru_maxrss;
  return run;
}

Json figures(Arguments arguments, const Surroundings& surroundings) {
  arguments.insert(arguments.end(), {"--json", "-"});
  const Outcome run = pineda(arguments, surroundings);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.json();
}

testing::AssertionResult ended_silently(const Outcome& run, int exit_code) {
  if (run.exit_code == exit_code && run.err.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "exit " << run.exit_code << ", said: " << run.err;
}

testing::AssertionResult is_refused(const Outcome& run, const std::string& part) {
  if (run.exit_code != 2) {
    return testing::AssertionFailure() << "exit " << run.exit_code << ", said: " << run.err;
  }
  if (std::count(run.err.begin(), run.err.end(), '\n') != 1 || run.err.back() != '\n') {
    return testing::AssertionFailure() << "not one line: " << run.err;
  }
  if (part.empty() || run.err.find(part) == std::string::npos) {
    return testing::AssertionFailure() << "'" << run.err << "' does not hold '" << part << "'";
  }
  return testing::AssertionSuccess();
}

}  // namespace pineda::test
