// pineda study area --check and --update: a study beside stored figures.
#pragma once

#include <optional>
#include <string>

#include "cli/output.h"
#include "cli/reserved_file.h"
#include "studies/area/figures.h"

namespace pineda::cli {

struct AreaRatchetOptions {
  std::string check;   // a file of figures; empty: none
  std::string update;  // the same, to be written
  bool allow_growth = false;

  bool is_wanted() const { return !check.empty() || !update.empty(); }
};

/// A file of figures that a study is held to, or that is stored anew.
class AreaRatchet {
 public:
  /// What the figures must be of.
  struct Subject {
    std::string design;
    std::string technology;
    std::string tools;  // their versions
    int clock_ps = 0;   // of a new file, or that the file must have; 0: the technology's first
    int first_clock_ps = 0;
  };

  /// Reads the file, before anything is measured.
  ///
  /// Errors   AreaError: no figures, or of something else, of another clock, or of other tools; an
  ///          update may have none of these tools, and no file. InputError: it cannot be written.
  AreaRatchet(const AreaRatchetOptions& options, const Subject& subject);

  int clock_ps() const { return file_.clock_ps; }
  /// Prints the figures beside the stored ones, and stores them where that is wanted and allowed.
  /// Has none grown, or may they? And does no path lead through a unit?
  bool run(const Output& output, const studies::AreaStudy& study, Json* json);

 private:
  void read(const std::string& path);

  AreaRatchetOptions options_;
  Subject subject_;
  studies::FiguresFile file_;
  std::optional<ReservedFile> new_file_;
};

}  // namespace pineda::cli
