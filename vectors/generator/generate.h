// Makes vector files: runs scenes through the model and checks the results by exact arithmetic.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "vectors/generator/judge.h"
#include "vectors/grammar/file.h"

namespace pineda::vectors {

/// A case that exact arithmetic contradicts: a bug of the model, or a bound too tight.
class Misjudged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which cases are asked for.
struct Request {
  int level = 1;
  uint64_t seed = 1;
  std::optional<uint64_t> count;  // so many, of the level's scenes first; else all of the level
};

/// What became of the scenes.
struct Tally {
  uint64_t cases = 0;
  uint64_t empty = 0;  // nothing of the scene reaches the unit
  uint64_t large = 0;  // more stamps or samples than a case of the unit may have
  uint64_t missed =
      0;  // reachable bins of the coverage that no case hits; 0 where a count was asked for
};

/// Calls visit(case) for the cases of one unit, each judged by exact arithmetic: those of the level, then
/// what it takes to hit every reachable bin of the coverage. Throws Misjudged.
template <class Case>
Tally for_each_case(const spec::Contract& contract, const Request& request,
                    const spec::ErrorBounds& bounds, const std::function<void(const Case&)>& visit);

/// The same in a file.
template <class Case>
File<Case> generate(const spec::Contract& contract, const Request& request,
                    const spec::ErrorBounds& bounds);

/// The same, written to `path` as they come. Throws Misjudged or Refused; then nothing is left there.
Tally generate_file(Unit unit, const spec::Contract& contract, const Request& request,
                    const spec::ErrorBounds& bounds, const std::string& path);

}  // namespace pineda::vectors
