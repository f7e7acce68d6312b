// Makes vector files: runs scenes through the model and checks the results by exact arithmetic.
#pragma once

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

/// What became of the scenes of a level.
struct Tally {
  size_t cases = 0;
  size_t empty = 0;  // nothing of the scene reaches the unit
  size_t large = 0;  // more stamps or samples than a case of the unit may have
};

/// The cases of one unit. Throws Misjudged. `tally` may be nullptr.
template <class Case>
File<Case> generate(const spec::Contract& contract, int level, uint64_t seed,
                    const spec::ErrorBounds& bounds, Tally* tally);

/// The same, written to `path`. Throws Misjudged or Refused.
Tally generate_file(Unit unit, const spec::Contract& contract, int level, uint64_t seed,
                    const spec::ErrorBounds& bounds, const std::string& path);

}  // namespace pineda::vectors
