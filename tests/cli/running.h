// A program that runs while a test goes on.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include "tests/cli/program.h"

namespace pineda::test {

/// `pineda ARGUMENTS...`, silent, until it is ended.
class Running {
 public:
  explicit Running(Arguments arguments) {
    arguments.insert(arguments.begin(), PINEDA_PROGRAM);
    std::vector<char*> argv;
    for (auto& word : arguments) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    process_ = fork();
    if (process_ == 0) {
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null, stream);
      for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
      execv(argv[0], argv.data());
      _exit(127);
    }
    close(null);
  }
  ~Running() {
    if (process_ > 0) end_by(SIGKILL);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Waits until there() holds; false if the program ends before.
  bool comes_to(const std::function<bool()>& there) const {
    while (!there()) {
      siginfo_t ended{};
      waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT);
      if (ended.si_pid != 0) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
  }

  /// Waits until it ends by itself; its exit code, -1 where a signal ended it.
  int finish() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// The signal that ended it; 0: it ended by itself.
  int end_by(int signal) {
    int status = 0;
    kill(process_, signal);
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }

 private:
  pid_t process_ = 0;
};

}  // namespace pineda::test
