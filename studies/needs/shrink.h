// The parameters of a design that can shrink to what a scene needs, and the smaller values of each.
#pragma once

#include <string>
#include <vector>

#include "model/spec/design.h"

namespace pineda::studies {

struct ShrinkableParameter {
  const char* name;
  /// Its value, "-" if the design does not use it.
  std::string (*text)(const spec::Design&);
  /// The design with each smaller value, the next smaller one first; dependent parameters follow.
  /// The last ones may be designs that cannot be built.
  std::vector<spec::Design> (*smaller)(const spec::Design&);
  void (*copy)(const spec::Design& from, spec::Design* to);
};

/// In the order in which a search tries them.
const std::vector<ShrinkableParameter>& shrinkable_parameters();
const ShrinkableParameter& shrinkable_parameter(const std::string& name);

/// The reciprocals that this design could have, by rising cost, each with a smaller error bound
/// than all before it. None makes setup's interval longer.
std::vector<spec::Design> reciprocal_front(const spec::Design& design);

}  // namespace pineda::studies
