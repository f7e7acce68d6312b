// A smaller case that fails as a larger one does.
#pragma once

#include <functional>
#include <string>

#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// Leaves out of a case what it fails without: inputs first, then stalls and reset, then raster state,
/// the size of the frame, and values of vertices. None that is left can be left out alone.
///
/// In       a case for which fails() is true; fails() is asked about cases whose outputs are those of the
///          model.
template <class Case>
Case shrunk(const spec::Contract& contract, const Case& failing,
            const std::function<bool(const Case&)>& fails);

/// What a difference is about, without the places: "setup_prim: e" of "setup case sliver.3: setup_prim 2:
/// e[1]: expected 0x7f...". Two failures of one kind are taken for the same.
std::string kind_of(const std::string& difference);

}  // namespace pineda::vectors
