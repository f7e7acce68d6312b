#include "model/files/unfinished.h"

#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>

namespace pineda::files {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// The process that removes files on a signal; 0: none. Forked processes must not.
std::atomic<pid_t> owner{0};
std::atomic<int> held{0};
std::atomic<int> noted{0};
std::atomic_flag busy = ATOMIC_FLAG_INIT;

/// The unfinished paths, newest first. Never destroyed: a signal may come during program exit.
std::list<std::string>& paths() {
  static auto* const all = new std::list<std::string>;
  return *all;
}

sigset_t signal_set() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : kSignals) sigaddset(&set, signal);
  return set;
}

void lock() {
  while (busy.test_and_set(std::memory_order_acquire)) sched_yield();
}

/// Holds the lock with signals blocked, so that a handler never waits for a lock that the thread it
/// interrupted holds.
class Locked {
 public:
  Locked() {
    const sigset_t set = signal_set();
    pthread_sigmask(SIG_BLOCK, &set, &before_);
    lock();
  }
  ~Locked() {
    busy.clear(std::memory_order_release);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  sigset_t before_;
};

/// Removes all paths and never releases the lock, so that no new path can be added.
void remove_all() {
  lock();
  for (const std::string& path : paths()) {
    if (unlink(path.c_str()) != 0) rmdir(path.c_str());
  }
}

/// Ends the program by the signal's default action. Only this signal is unblocked: the handler of
/// another one would wait for the lock that remove_all() keeps.
void end_by(int signal) {
  struct sigaction plain {};
  plain.sa_handler = SIG_DFL;
  sigaction(signal, &plain, nullptr);
  raise(signal);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
}

/// The signal handler; all that it calls is async-signal-safe.
void on_signal(int signal) {
  const int before = errno;
  if (getpid() != owner) {
    end_by(signal);
  } else if (held > 0) {
    noted = signal;
  } else {
    remove_all();
    end_by(signal);
  }
  errno = before;
}

}  // namespace

void remove_unfinished_on_signals() {
  paths();
  owner = getpid();
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_mask = signal_set();
  action.sa_flags = SA_RESTART;
  for (const int signal : kSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

Unfinished::Unfinished(const std::string& path) {
  std::list<std::string> one{path};
  const Locked locked;
  paths().splice(paths().begin(), one);
  place_ = paths().begin();
}

Unfinished::~Unfinished() {
  std::list<std::string> one;
  const Locked locked;
  one.splice(one.begin(), paths(), place_);
}

HeldSignals::HeldSignals() { ++held; }

HeldSignals::~HeldSignals() {
  const sigset_t set = signal_set();
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &set, &before);
  if (--held == 0 && noted != 0) {
    remove_all();
    end_by(noted);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

bool HeldSignals::came() const { return noted != 0; }

}  // namespace pineda::files
