#include "tb/work_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <regex>
#include <thread>
#include <vector>

#include "tb/rtl.h"

namespace pineda::tb {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kBetweenLooks{10};
constexpr int kRemovals = 200;

/// Opens the folder and locks it for this process alone; -1 where another process has locked it.
/// Processes that this one starts do not inherit the lock.
int locked(const fs::path& folder, int how) {
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0 || flock(file, how) == 0) return file;
  close(file);
  return -1;
}

/// Tries more than once: a process that was just killed may still make a file.
void remove_folder(const fs::path& folder) {
  std::error_code error;
  for (int i = 0; i < kRemovals; ++i) {
    fs::remove_all(folder, error);
    if (!fs::exists(folder, error)) return;
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

bool is_work_folder(const fs::directory_entry& entry) {
  static const std::regex name(".*_[0-9a-f]{16}\\.[A-Za-z0-9]{6}");
  std::error_code error;
  return entry.is_directory(error) && !entry.is_symlink(error) &&
         std::regex_match(entry.path().filename().string(), name);
}

/// Removes the folders in the cache that no process has locked. The caller has locked the cache.
void sweep_locked(const fs::path& cache) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator at(cache, error), end; !error && at != end; at.increment(error)) {
    if (is_work_folder(*at)) folders.push_back(at->path());
  }
  for (const fs::path& folder : folders) {
    const int lock = locked(folder, LOCK_EX | LOCK_NB);
    if (lock < 0) continue;
    remove_folder(folder);
    close(lock);
  }
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& cache, const std::string& key) {
  std::error_code error;
  fs::create_directories(cache, error);
  // Until the new folder is locked the cache is, so that nobody sweeps the folder away.
  const int cache_lock = locked(cache, LOCK_EX);
  std::string name = (cache / (key + ".XXXXXX")).string();
  if (!error && mkdtemp(name.data()) != nullptr) {
    path_ = name;
    lock_ = locked(path_, LOCK_EX);
  }
  if (cache_lock >= 0) close(cache_lock);
  if (path_.empty()) {
    throw PluginError(fmt::format(
        "{}: expected a folder to keep the RTL of designs in ($PINEDA_CACHE)", cache.string()));
  }
}

WorkFolder::~WorkFolder() {
  remove_folder(path_);
  if (lock_ >= 0) close(lock_);
}

bool WorkFolder::run(const std::string& command) const {
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    setpgid(0, 0);                     // a group of its own, so that all of it can be ended
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // ends it when this process dies
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  setpgid(child, child);  // here as well, since either process may come first
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(child, &status, WNOHANG)) == 0) {
    if (signals_.came()) kill(-child, SIGKILL);
    std::this_thread::sleep_for(kBetweenLooks);
  }
  if (signals_.came()) throw PluginError("interrupted");  // the program ends before it says so
  return ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void sweep_work_folders(const fs::path& cache) {
  const int cache_lock = locked(cache, LOCK_EX);
  if (cache_lock < 0) return;
  sweep_locked(cache);
  close(cache_lock);
}

}  // namespace pineda::tb
