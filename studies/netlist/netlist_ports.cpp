#include "studies/netlist/netlist_ports.h"

#include <fmt/format.h>

#include <algorithm>

namespace pineda::studies {
namespace {

/// "out_0, out_1", or backwards.
std::string bits_of(const NetlistPort& port, bool backwards) {
  std::vector<std::string> bits;
  for (int i = 0; i < port.bits; ++i) bits.push_back(fmt::format("{}_{}", port.signal, i));
  if (backwards) std::reverse(bits.begin(), bits.end());
  return fmt::format("{}", fmt::join(bits, ", "));
}

}  // namespace

std::string unit_instance(const std::string& unit, const std::string& out,
                          const std::vector<NetlistPort>& ports) {
  std::string wires, joined, connections;
  bool has_memory = false;
  for (const NetlistPort& port : ports) {
    has_memory |= port.signal == "read";
    const bool is_collected = port.is_output && port.bits > 1;
    if (is_collected) {
      wires += fmt::format("wire {};\n", bits_of(port, false));
      joined +=
          fmt::format("always @(posedge settled) {} = {{{}}};\n", port.signal, bits_of(port, true));
    }
    for (int i = 0; i < port.bits; ++i) {
      connections += connections.empty() ? "" : ",\n";
      if (port.bits == 1) {
        connections += fmt::format(".{}({})", port.name, port.signal);
      } else {
        connections +=
            fmt::format(is_collected ? ".\\{0}[{1}] ({2}_{1})" : ".\\{0}[{1}] ({2}[{1}])",
                        port.name, i, port.signal);
      }
    }
  }
  const std::string none =
      has_memory ? "" : "assign {read_valid, write_valid, response_ready} = 0;\n";
  return fmt::format("localparam OUT_NAME = \"{}\";\n{}{}{}{}_unit u_unit (\n{});\n", out, none,
                     wires, joined, unit, connections);
}

}  // namespace pineda::studies
