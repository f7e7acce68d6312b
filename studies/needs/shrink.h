// The parameters of a design that a scene may need less of, and the next smaller value of each.
#pragma once

#include <string>
#include <vector>

#include "model/spec/design.h"

namespace pineda::studies {

struct ShrinkableParameter {
  const char* name;
  /// Its value, "-" if the design does not use it.
  std::string (*text)(const spec::Design&);
  /// The design with each smaller value, from the next one on; what must follow does. The last ones
  /// may be beyond what can be built.
  std::vector<spec::Design> (*smaller)(const spec::Design&);
  void (*copy)(const spec::Design& from, spec::Design* to);
};

/// In the order in which a search tries them.
const std::vector<ShrinkableParameter>& shrinkable_parameters();
const ShrinkableParameter& shrinkable_parameter(const std::string& name);

/// The reciprocals that this design could have, by rising cost; each is more accurate, by its
/// bound, than all before it. A triangle every so many cycles as now, or sooner.
std::vector<spec::Design> reciprocal_front(const spec::Design& design);

}  // namespace pineda::studies
