// Vectors run on mutants of a unit's RTL: which of them die, and where.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/rtl.h"
#include "vectors/grammar/cases.h"

namespace pineda::studies {

/// What a mutant did with vectors.
struct Sight {
  bool is_dead = false;     // a bit or a token differs, or a rule of the streams is broken
  bool is_late = false;     // a handshake of the original came in another cycle, in `cycle` of it
  std::string vector;       // the first case that shows it
  std::string what;         // the difference
  timing::Cycle cycle = 0;  // of the case
};

/// Runs each mutant on the cases until one of them kills it. All bits of the original must be right.
/// A late mutant goes on: it may die later.
///
/// In       the plug-in of a unit's mutants; their numbers.
/// Out      one Sight for each of them. `done` hears how many are through, from any thread.
/// Errors   AreaError: the original is not as the cases expect.
template <class Case>
std::vector<Sight> sights_of(const tb::RtlLibrary& library, const std::vector<Case>& cases,
                             const std::vector<int>& mutants,
                             const std::function<void(size_t)>& done);

}  // namespace pineda::studies
