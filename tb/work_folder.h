// The folder that a plug-in is built in, beside the place where it is kept.
#pragma once

#include <filesystem>
#include <string>

#include "model/files/unfinished.h"

namespace pineda::tb {

/// A folder CACHE/KEY.XXXXXX of its own, removed at its end, also when a signal ends the program.
/// It is locked as long as the process lives: what a killed one left is known by that.
///
/// Errors   PluginError: the cache cannot be written.
class WorkFolder {
 public:
  WorkFolder(const std::filesystem::path& cache, const std::string& key);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Runs a shell's command; does it exit 0? A signal ends it and all that it has started.
  /// Errors   PluginError: a signal came; the program ends once this folder is gone.
  bool run(const std::string& command) const;

 private:
  files::HeldSignals signals_;
  std::filesystem::path path_;
  int lock_ = -1;
};

/// Removes the folders in the cache whose processes are gone; what cannot be removed stays.
void sweep_work_folders(const std::filesystem::path& cache);

}  // namespace pineda::tb
