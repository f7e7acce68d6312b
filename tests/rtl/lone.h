// What the tests of a single Verilated module share.
#pragma once

#include <stdexcept>
#include <string>

#include "model/spec/random.h"
#include "model/spec/widths.h"
#include "tests/spec/schemes.h"

namespace pineda::tb {

/// The contract of a design of tests/spec/schemes.h or of a named one.
inline spec::Contract contract_of(const std::string& name) {
  for (const spec::Design& design : spec::kSchemes) {
    if (name == design.name) return spec::contract(design);
  }
  for (const spec::Design& design : spec::kSetups) {
    if (name == design.name) return spec::contract(design);
  }
  const spec::Design* named = spec::find_design(name);
  if (named == nullptr) throw std::invalid_argument(name);
  return spec::contract(*named);
}

template <class Model>
void clock(Model* model) {
  model->clk_i = 1;
  model->eval();
  model->clk_i = 0;
  model->eval();
}

}  // namespace pineda::tb
