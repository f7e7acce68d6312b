#include "studies/area/synthesis.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

#include "model/files/data_folder.h"
#include "model/spec/package.h"
#include "studies/area/area_error.h"
#include "studies/area/rtlil.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

// Of a clock, what a module's own logic may take.
constexpr double kShareOfLogic = .85;

fs::path rtl(const std::string& file) { return files::data_folder() / "rtl" / file; }

bool has_state(const RtlilCell& cell) {
  return cell.type.rfind("$dff", 0) == 0 || cell.type.rfind("$adff", 0) == 0 ||
         cell.type.rfind("$sdff", 0) == 0 || cell.type.rfind("$mem", 0) == 0;
}

/// Whether a module has state, and more than registers with an enable: those are mapped where they
/// stand, so that what nobody reads of them is left out.
bool is_mapped_alone(const RtlilModule& module) {
  const auto is_register = [](const RtlilCell& cell) {
    return cell.type == "$mux" || cell.type.find("dff") != std::string::npos;
  };
  return std::any_of(module.cells.begin(), module.cells.end(), has_state) &&
         !std::all_of(module.cells.begin(), module.cells.end(), is_register);
}

bool is_memory(const RtlilCell& cell, long least_bits) {
  if (cell.type != "$mem_v2") return false;
  const auto& p = cell.parameter;
  constexpr long kMostReads = 2;
  return p.at("WR_PORTS") == 1 && p.at("RD_PORTS") <= kMostReads &&
         p.at("SIZE") * p.at("WIDTH") >= least_bits;
}

/// "stream_fifo_8ea2ba" of the name that Yosys gives a module with parameters.
std::string plain_name(const std::string& name) {
  if (name[0] == '\\') return name.substr(1);
  const std::string paramod = "$paramod";
  const size_t slash = name.find('\\');
  if (name[paramod.size()] == '$') {
    return name.substr(slash + 1) + "_" + name.substr(paramod.size() + 1, 6);
  }
  const size_t second = name.find('\\', slash + 1);
  return fmt::format("{}_{:06x}", name.substr(slash + 1, second - slash - 1),
                     spec::text_hash(name.substr(second)) & 0xffffff);
}

constexpr const char* kProbe = R"(module probe (
  input  logic       clk_i, rst_ni,
  input  logic [2:0] d_i,
  output logic [2:0] q_o,
  output logic       y_o
);
  always_ff @(posedge clk_i) q_o[0] <= d_i[0];
  always_ff @(posedge clk_i or negedge rst_ni) if (!rst_ni) q_o[1] <= 1'b0; else q_o[1] <= d_i[1];
  always_ff @(posedge clk_i or negedge rst_ni) if (!rst_ni) q_o[2] <= 1'b1; else q_o[2] <= d_i[2];
  assign y_o = d_i[0] && !d_i[1];
endmodule
)";

std::string bare(const std::string& name) { return name[0] == '\\' ? name.substr(1) : name; }

}  // namespace

std::string unit_name(const std::string& module) { return module.substr(0, module.rfind('_')); }

std::string sources_of(const spec::Contract& contract) {
  std::string text = spec::package_text(contract);
  std::istringstream files(text_of(rtl("files.f")));
  for (std::string file; files >> file;) {
    if (file != "pineda_pkg.sv") text += text_of(rtl(file));
  }
  return text;
}

Synthesis::Synthesis(const spec::Contract& contract, const Technology& technology,
                     long least_memory_bits, const ToolRuns& runs)
    : technology_(technology), runs_(runs) {
  liberty_ = runs_.keep(
      technology.liberty.text([&](const std::string& cell) { return technology.allows(cell); }),
      ".lib");
  constraints_ = runs_.keep(fmt::format("set_driving_cell {}\nset_load {} [all_outputs]\n",
                                        technology.driving_cell, technology.load_ff),
                            ".constr");
  try_cells();
  elaborate(contract, least_memory_bits);
}

std::string Synthesis::mapping_of(const std::string& module, int delay_ps) const {
  const std::string abc = fmt::format(
      "+strash;dch,-f;map,-B,0.9,-D,{0};topo;buffer,-c,-N,16;upsize,-D,{0};dnsize,-D,{0}",
      delay_ps);
  // Cells get public names, so that a flat netlist tells their instances.
  return fmt::format(
      "synth -noabc -top {0}\ndfflibmap -liberty {1}\nopt\n"
      "abc -liberty {1} -constr {2} -D {3} -script {4}\nsetundef -zero\nopt_clean -purge\n"
      "rename -enumerate -pattern cell_% {0}/c:$*\n"
      "select {0}\nwrite_rtlil -selected {5}/mapped.il\n",
      module, liberty_, constraints_, delay_ps, abc, kOut);
}

// Maps a gate and each kind of flip-flop that the RTL has: what a technology lacks is known at once.
void Synthesis::try_cells() const {
  const std::string script = fmt::format("read_verilog -sv {}\n", runs_.keep(kProbe, ".sv")) +
                             mapping_of("probe", technology_.first_clock_ps);
  try {
    runs_.run({{"yosys", script, "trying the cells of " + technology_.name}});
  } catch (const AreaError& error) {
    throw AreaError(fmt::format(
        "{}: expected cells for gates, and flip-flops with low resets to 0 and to 1: {}",
        technology_.file, error.what()));
  }
}

// The RTL's modules with parameters resolved, under plain names.
std::string Synthesis::elaborated(const spec::Contract& contract) const {
  const std::string script = fmt::format(
      "read_verilog -sv -DSYNTHESIS {}\nhierarchy -check -top {}\n"
      "proc\nopt_clean\nmemory -nomap\nopt_clean\n"
      "setattr -unset src\nsetattr -mod -unset src\nwrite_rtlil {}/design.il\n",
      runs_.keep(sources_of(contract), ".sv"), kTop, kOut);
  const auto folders = runs_.run({{"yosys", script, "elaborating the RTL"}});
  std::string design = text_of(folders.front() / "design.il");
  for (const RtlilModule& module : parse_rtlil(design)) {
    const std::string name = plain_name(module.name);
    for (const char end : {'\n', ' '}) {
      design =
          replaced(design, fmt::format("{}{}", module.name, end), fmt::format("\\{}{}", name, end));
    }
  }
  return design;
}

// The modules that are mapped by themselves; each memory is one, and in *memory by its name.
std::string Synthesis::split(const std::string& design, long least_memory_bits,
                             std::map<std::string, RtlilCell>* memory) const {
  std::string enables, memories;
  std::set<std::string> kept{kTop};
  kept.insert(std::begin(kUnits), std::end(kUnits));
  for (const RtlilModule& module : parse_rtlil(design)) {
    const std::string name = bare(module.name);
    if (is_mapped_alone(module)) kept.insert(name);
    int number = 0;
    for (const RtlilCell& cell : module.cells) {
      if (!is_memory(cell, least_memory_bits)) continue;
      const std::string own = fmt::format("{}_memory{}", name, number++);
      memories += fmt::format("submod -name {} {}/{}\n", own, name, bare(cell.name));
      (*memory)[own] = cell;
    }
    // A memory's enable is a wire for each bit, made by a multiplexer of ones and zeros: as a single
    // bit, so that it is one port of the module, which drives all flip-flops behind buffers.
    if (number > 0) {
      enables += fmt::format(
          "select {}\nsimplemap t:$mux\nopt_expr -mux_undef -mux_bool\n"
          "opt_merge\nopt_clean\nselect -clear\n",
          name);
    }
  }
  const std::string script = fmt::format(
      "read_rtlil {}\nsetattr -mod -set keep_hierarchy 1 {}\nflatten\n"
      "hierarchy -top {}\nopt_clean -purge\n{}{}write_rtlil {}/split.il\n",
      runs_.keep(design, ".il"), fmt::join(kept, " "), kTop, enables, memories, kOut);
  std::string text =
      text_of(runs_.run({{"yosys", script, "dividing the RTL"}}).front() / "split.il");
  for (const auto& [name, cell] : *memory) {  // an instance "memory0" of it
    text = replaced(text, fmt::format("  cell \\{0} \\{0}\n", name),
                    fmt::format("  cell \\{} \\{}\n", name, name.substr(name.rfind('_') + 1)));
  }
  return text;
}

void Synthesis::elaborate(const spec::Contract& contract, long least_memory_bits) {
  std::map<std::string, RtlilCell> memory;
  const auto all = parse_rtlil(split(elaborated(contract), least_memory_bits, &memory));
  for (const RtlilModule& module : all) {
    SynthesizedModule m;
    m.name = bare(module.name);
    m.rtlil = runs_.keep(renumbered(module.text), ".il");
    std::string around;
    for (const RtlilModule& other : all) {
      bool is_part = false;
      for (const RtlilCell& cell : module.cells) {
        if (cell.type != other.name) continue;
        is_part = true;
        m.parts[bare(cell.name)] = bare(other.name);
      }
      if (is_part) around += black_box(other);
    }
    m.around = runs_.keep(around, ".il");
    if (const auto own = memory.find(m.name); own != memory.end()) {
      m.memory_words = static_cast<int>(own->second.parameter.at("SIZE"));
      m.memory_bits = m.memory_words * own->second.parameter.at("WIDTH");
    }
    modules_[m.name] = m;
  }
}

void Synthesis::map(const std::map<std::string, int>& delay_ps) {
  std::vector<ToolRun> all;
  for (const auto& [name, delay] : delay_ps) {
    const SynthesizedModule& m = modules_.at(name);
    all.push_back({"yosys",
                   fmt::format("read_rtlil {}\nread_rtlil {}\nhierarchy -check -top {}\n", m.around,
                               m.rtlil, name) +
                       mapping_of(name, delay),
                   fmt::format("mapping {} for {} ps", name, delay)});
  }
  const auto results = runs_.run(all);
  size_t i = 0;
  for (const auto& [name, delay] : delay_ps) {
    SynthesizedModule& m = modules_.at(name);
    const fs::path file = results[i++] / "mapped.il";
    m.netlist = runs_.name_of(file);
    m.cells.clear();
    for (const RtlilModule& module : parse_rtlil(text_of(file))) {
      if (bare(module.name) != name) continue;
      for (const RtlilCell& cell : module.cells) {
        const std::string type = bare(cell.type);
        if (m.parts.count(bare(cell.name)) != 0) continue;
        if (technology_.liberty.cells().count(type) == 0) {
          throw AreaError(fmt::format("{}: expected a cell that can be a {}, which {} needs",
                                      technology_.liberty_file, type, name));
        }
        ++m.cells[type];
      }
    }
  }
}

std::map<std::string, std::string> Synthesis::instances(const std::string& top) const {
  std::map<std::string, std::string> all;
  const std::function<void(const std::string&, const std::string&)> visit =
      [&](const std::string& path, const std::string& name) {
        all[path] = name;
        for (const auto& [instance, part] : modules_.at(name).parts) {
          visit(path.empty() ? instance : fmt::format("{}.{}", path, instance), part);
        }
      };
  visit("", top);
  return all;
}

std::vector<std::string> Synthesis::flat_netlists(const std::vector<std::string>& tops) const {
  std::vector<ToolRun> all;
  for (const std::string& top : tops) {
    std::set<std::string> names;
    for (const auto& [path, name] : instances(top)) names.insert(name);
    std::string script;
    for (const std::string& name : names) {
      script.append(fmt::format("read_rtlil {}\n", modules_.at(name).netlist));
    }
    script += fmt::format(
        "hierarchy -top {0}\nsetattr -mod -unset keep_hierarchy\nflatten\nsplitnets -ports\n"
        "opt_clean -purge\nwrite_verilog -noattr -noexpr {1}/flat.v\n",
        top, kOut);
    all.push_back({"yosys", script, fmt::format("joining the netlist of {}", top)});
  }
  std::vector<std::string> files;
  for (const fs::path& folder : runs_.run(all)) files.push_back(runs_.name_of(folder / "flat.v"));
  return files;
}

std::map<std::string, int> first_delays(const Synthesis& synthesis, const std::string& top,
                                        int clock_ps) {
  std::map<std::string, int> delays;
  for (const auto& [path, name] : synthesis.instances(top)) {
    delays[name] = static_cast<int>(clock_ps * kShareOfLogic);
  }
  return delays;
}

}  // namespace pineda::studies
