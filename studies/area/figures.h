// Stored areas and slowest paths of a design's units: a ratchet, by the versions of the tools.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "studies/area/area.h"

namespace pineda::studies {

/// What a figure may grow by before a check fails, and must shrink by to be stored anew.
inline constexpr double kFigureTolerance = .02;

/// What is stored of a unit.
struct UnitFigures {
  double area_um2 = 0;
  double slowest_path_ps = 0;
};
using Figures = std::map<std::string, UnitFigures>;  // setup, traversal, interp_ztest

/// A file of figures: of one design on one technology at one clock.
struct FiguresFile {
  std::string path;
  std::string design;
  std::string technology;
  int clock_ps = 0;
  std::map<std::string, Figures> by_tools;  // by the versions of the tools

  /// Errors   AreaError: file and what was expected.
  static FiguresFile read(const std::string& path);
  std::string text() const;
};

/// The figures of a study, rounded to what a file holds.
Figures figures_of(const AreaStudy& study);

/// A figure that was measured beside the one that is stored.
struct FigureChange {
  std::string unit;
  std::string figure;  // area_um2 or slowest_path_ps
  double stored = 0;
  double measured = 0;

  double share() const { return measured / stored - 1; }
  bool has_grown() const { return share() > kFigureTolerance; }
  bool has_shrunk() const { return share() < -kFigureTolerance; }
};

/// Every figure, in the order of the units.
///
/// In       both have the same units.
std::vector<FigureChange> changes(const Figures& stored, const Figures& measured);

/// What is to be stored: smaller figures where they have shrunk, greater ones where they have grown;
/// a figure within the tolerance stays, so that it cannot creep.
Figures updated(const Figures& stored, const Figures& measured);

}  // namespace pineda::studies
