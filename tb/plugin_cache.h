// Plug-ins of designs that the build does not carry: verilated on demand, kept for the next time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "model/spec/widths.h"

namespace pineda::tb {

/// A file that comes with the program: in its build tree, wherever in it the program lies, or in
/// PREFIX/lib/pineda where it is installed. Empty where it is missing.
std::filesystem::path built_file(const std::string& name);

/// The folder that they are kept in: $PINEDA_CACHE, $XDG_CACHE_HOME/pineda or ~/.cache/pineda.
std::string plugin_cache_folder();

/// The plug-in of this design in the cache; it is built there by tb/plugin.mk when it is missing,
/// or when the RTL or the benches have changed since. `say` hears of a build before it starts, with
/// how long it takes. Two processes may build the same one: the first that is done wins.
///
/// In       a design that has RTL.
/// Errors   PluginError: a tool is missing, the sources are not there, the cache cannot be written,
///          or the build failed (its log is kept and named).
std::string cached_plugin(const spec::Contract& contract,
                          const std::function<void(const std::string&)>& say);

/// The same of the bench plug-in (bench_plugin.h), built by tb/bench_plugin.mk with this compiler.
std::string cached_bench_plugin(const spec::Contract& contract, const std::string& compiler,
                                const std::function<void(const std::string&)>& say);

/// The same of one unit, setup, traversal or interp_ztest, made of this Verilog in place of the RTL:
/// a netlist of mutants, with a port mutant_i, built by tb/plugin.mk.
std::string cached_mutants_plugin(const spec::Contract& contract, const std::string& unit,
                                  const std::string& verilog,
                                  const std::function<void(const std::string&)>& say);

/// The plug-in of one module alone (setup_unit, traversal_unit, interp_ztest_unit, raster_top) that
/// counts how often its lines run and its bits change.
std::string cached_coverage_plugin(const spec::Contract& contract, const std::string& module,
                                   const std::function<void(const std::string&)>& say);

/// Is there such a program on the path?
bool on_path(const std::string& tool);

}  // namespace pineda::tb
