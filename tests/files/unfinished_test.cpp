// Which files a signal removes and which it leaves: each case in a process of its own.
#include "model/files/unfinished.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <list>
#include <optional>

namespace pineda::files {
namespace {

namespace fs = std::filesystem;

constexpr int kWentOn = 7;  // exit code of a process that its signal did not end

/// A folder of its own, removed with all it holds.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "pineda_files_test-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string at(const std::string& name) const { return (path_ / name).string(); }
  bool has(const std::string& name) const { return fs::exists(path_ / name); }

 private:
  fs::path path_;
};

void make(const std::string& path) { std::ofstream(path) << "part of it"; }

/// How a process ends that does this: the signal, or minus its exit code.
int end_of(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
    work();
    _exit(kWentOn);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : -WEXITSTATUS(status);
}

class EverySignal : public testing::TestWithParam<int> {};

TEST_P(EverySignal, RemovesFilesAndEmptyFoldersAndStillEndsTheProgram) {
  const Folder folder;
  EXPECT_EQ(end_of([&] {
              remove_unfinished_on_signals();
              const Unfinished made(folder.at("made"));
              const Unfinished file(folder.at("made/file"));
              const Unfinished never_made(folder.at("made/other"));
              const Unfinished full(folder.at("full"));
              fs::create_directory(folder.at("made"));
              fs::create_directory(folder.at("full"));
              make(folder.at("made/file"));
              make(folder.at("full/of_others"));
              raise(GetParam());
            }),
            GetParam());
  EXPECT_FALSE(folder.has("made"));
  EXPECT_TRUE(folder.has("full/of_others"));
}

TEST_P(EverySignal, LeavesWhatIsFinished) {
  const Folder folder;
  EXPECT_EQ(end_of([&] {
              remove_unfinished_on_signals();
              std::optional<Unfinished> first(folder.at("first"));
              const Unfinished second(folder.at("second"));
              make(folder.at("first"));
              make(folder.at("second"));
              first.reset();
              raise(GetParam());
            }),
            GetParam());
  EXPECT_TRUE(folder.has("first"));
  EXPECT_FALSE(folder.has("second"));
}

// Ignored signals stay ignored, as under nohup or behind an & in a script.
TEST_P(EverySignal, StaysIgnoredWhereItWas) {
  const Folder folder;
  EXPECT_EQ(end_of([&] {
              std::signal(GetParam(), SIG_IGN);
              remove_unfinished_on_signals();
              const Unfinished file(folder.at("file"));
              make(folder.at("file"));
              raise(GetParam());
            }),
            -kWentOn);
  EXPECT_TRUE(folder.has("file"));
}

TEST_P(EverySignal, OfAForkedProcessRemovesNothingOfItsParent) {
  const Folder folder;
  EXPECT_EQ(end_of([&] {
              remove_unfinished_on_signals();
              const Unfinished file(folder.at("file"));
              make(folder.at("file"));
              const pid_t child = fork();
              if (child == 0) {
                raise(GetParam());
                _exit(kWentOn);
              }
              int status = 0;
              waitpid(child, &status, 0);
              if (!WIFSIGNALED(status) || !folder.has("file")) _exit(1);
            }),
            -kWentOn);
}

TEST_P(EverySignal, HeldEndsTheProgramOnceTheWorkIsPutAway) {
  const Folder folder;
  EXPECT_EQ(end_of([&] {
              remove_unfinished_on_signals();
              const Unfinished file(folder.at("file"));
              make(folder.at("file"));
              {
                const HeldSignals outer;
                {
                  const HeldSignals inner;
                  if (inner.came()) _exit(1);
                  raise(GetParam());
                  if (!inner.came() || !folder.has("file")) _exit(2);
                }
                make(folder.at("put_away"));
              }
              _exit(3);  // it has ended before
            }),
            GetParam());
  EXPECT_FALSE(folder.has("file"));
  EXPECT_TRUE(folder.has("put_away"));
}

INSTANTIATE_TEST_SUITE_P(Unfinished, EverySignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

// Further signals, of lower and of higher numbers, come while paths are removed.
TEST(Unfinished, ManySignalsAtOnceEndTheProgramToo) {
  const Folder folder;
  const auto under_fire = [&](const std::function<void()>& wait) {
    remove_unfinished_on_signals();
    std::list<Unfinished> many;
    for (int i = 0; i < 20000; ++i) many.emplace_back(folder.at(std::to_string(i)));
    alarm(60);  // ends a test that hangs
    const pid_t program = getpid();
    if (fork() == 0) {
      while (getppid() == program) {
        for (const int signal : {SIGTERM, SIGINT, SIGHUP}) kill(program, signal);
      }
      _exit(0);
    }
    wait();
  };
  const auto held = [] {
    const HeldSignals signals;
    while (!signals.came()) sched_yield();
  };
  const auto not_held = [] {
    while (true) pause();
  };
  for (const std::function<void()>& wait : {std::function<void()>(held), {not_held}}) {
    const int end = end_of([&] { under_fire(wait); });
    EXPECT_TRUE(end == SIGTERM || end == SIGINT || end == SIGHUP) << end;
  }
}

// The mutant: without the handler the file stays, and the test sees it.
TEST(Unfinished, StaysWithoutAHandler) {
  const Folder folder;
  EXPECT_EQ(end_of([&] {
              const Unfinished file(folder.at("file"));
              make(folder.at("file"));
              raise(SIGTERM);
            }),
            SIGTERM);
  EXPECT_TRUE(folder.has("file"));
}

}  // namespace
}  // namespace pineda::files
