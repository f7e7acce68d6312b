// Unfinished files: they are removed if a signal ends the program.
#pragma once

#include <list>
#include <string>

namespace pineda::files {

/// From now on SIGINT, SIGTERM and SIGHUP remove all unfinished files before they end the program.
/// A signal that is ignored (as under nohup) stays ignored, and forked processes remove nothing.
void remove_unfinished_on_signals();

/// A path that is removed if a signal ends the program while this object lives: a file, or an empty
/// folder. The newest path is removed first. Make the object before the file, so that there is no
/// moment in which a signal leaves the file behind.
class Unfinished {
 public:
  explicit Unfinished(const std::string& path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  std::list<std::string>::const_iterator place_;
};

/// While an object of this class lives, signals are only recorded: for work that needs more
/// cleaning up than removing files. Its destructor ends the program if a signal came.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  bool came() const;
};

}  // namespace pineda::files
