// How the ports of a unit's netlist are joined to the signals of studies/netlist/netlist_bench.sv.
#pragma once

#include <string>
#include <vector>

namespace pineda::studies {

struct NetlistPort {
  std::string name;    // in the RTL
  std::string signal;  // of the bench
  int bits = 1;
  bool is_output = false;
};

/// The bench's unit.svh: an instance of UNIT_unit, which has a port for each bit, and what the bench
/// asks for of a unit without depth memory. `out`: the name of the stream out of it.
std::string unit_instance(const std::string& unit, const std::string& out,
                          const std::vector<NetlistPort>& ports);

}  // namespace pineda::studies
