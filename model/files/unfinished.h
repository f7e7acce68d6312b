// What is not whole yet: a signal that ends the program takes it along.
#pragma once

#include <list>
#include <string>

namespace pineda::files {

/// From here on SIGINT, SIGTERM and SIGHUP remove what is unfinished. The program still ends by the
/// signal. One that is ignored (as under nohup) stays ignored, and forked processes remove nothing.
void remove_unfinished_on_signals();

/// A path that is removed if a signal ends the program while this lives: a file, or a folder if it
/// is empty; later ones first. It begins before there is anything at the path, so nothing is
/// missed.
class Unfinished {
 public:
  explicit Unfinished(const std::string& path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  std::list<std::string>::const_iterator place_;
};

/// While this lives signals are only noted: for work that takes more to put away than removing a
/// file. At its end the program ends too, if one came.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  bool came() const;
};

}  // namespace pineda::files
