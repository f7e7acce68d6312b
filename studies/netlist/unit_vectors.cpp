#include "studies/netlist/unit_vectors.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

#include "model/files/data_folder.h"
#include "model/spec/clear_depth.h"
#include "model/spec/difference.h"
#include "model/spec/pack.h"
#include "model/spec/package.h"
#include "studies/area/area_error.h"
#include "studies/netlist/netlist_ports.h"
#include "studies/netlist/netlist_words.h"
#include "vectors/grammar/file.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

/// One of the streams out of a unit: compares its tokens with those of a case.
template <class T>
class ExpectedStream {
 public:
  explicit ExpectedStream(const spec::Contract& contract) : words_(contract), comparer_(contract) {}

  void start(const std::vector<T>& tokens) {
    tokens_ = tokens;
    for (T& token : tokens_) token.id &= 1;
    next_ = 0;
  }
  /// The difference of the next token, "stamp 3, cycle 120: mask: expected ...", or an empty text.
  std::string take(const std::string& cycle, const std::string& hex) {
    const std::string where = fmt::format("{} {}, cycle {}", spec::struct_name<T>(), next_, cycle);
    if (next_ == tokens_.size()) return where + ": expected the end, got one more";
    const T& expected = tokens_[next_++];
    const auto got = words_.token(hex);
    if (!got) return fmt::format("{}: expected {}, got {}", where, words_.hex(expected), hex);
    const auto text = comparer_.difference(expected, *got);
    return text ? fmt::format("{}: {}", where, *text) : "";
  }
  std::string end(const std::string& cycle) const {
    if (next_ == tokens_.size()) return "";
    return fmt::format("{} {}, cycle {}: expected one more, got the end", spec::struct_name<T>(),
                       next_, cycle);
  }

 private:
  NetlistWords<T> words_;
  spec::Comparer<T> comparer_;
  std::vector<T> tokens_;
  size_t next_ = 0;
};

/// The streams out of a unit by their names.
template <class Case>
struct Outputs;

template <>
struct Outputs<vectors::SetupCase> {
  ExpectedStream<spec::SetupPrim> prims;
  explicit Outputs(const spec::Contract& c) : prims(c) {}
  void start(const vectors::SetupCase& c) { prims.start(c.out); }
  std::string take(const std::string&, const std::string& cycle, const std::string& hex) {
    return prims.take(cycle, hex);
  }
  std::string end(const std::string& cycle) const { return prims.end(cycle); }
};

template <>
struct Outputs<vectors::TraversalCase> {
  ExpectedStream<spec::Stamp> stamps;
  explicit Outputs(const spec::Contract& c) : stamps(c) {}
  void start(const vectors::TraversalCase& c) { stamps.start(c.out); }
  std::string take(const std::string&, const std::string& cycle, const std::string& hex) {
    return stamps.take(cycle, hex);
  }
  std::string end(const std::string& cycle) const { return stamps.end(cycle); }
};

template <>
struct Outputs<vectors::InterpZtestCase> {
  ExpectedStream<spec::DepthWrite> depth;
  ExpectedStream<spec::ColorWrite> color;
  explicit Outputs(const spec::Contract& c) : depth(c), color(c) {}
  void start(const vectors::InterpZtestCase& c) {
    depth.start(c.depth);
    color.start(c.color);
  }
  std::string take(const std::string& stream, const std::string& cycle, const std::string& hex) {
    return stream == "depth_write" ? depth.take(cycle, hex) : color.take(cycle, hex);
  }
  std::string end(const std::string& cycle) const {
    const std::string text = depth.end(cycle);
    return text.empty() ? color.end(cycle) : text;
  }
};

template <class T>
int bits_of(const spec::Contract& contract) {
  const NetlistWords<T> words(contract);
  return words.bits();
}

/// Of a port of the depth memory: how wide it is, and where the fields lie that the memory reads.
template <class T>
void add_memory_port(const spec::Contract& c, const std::string& port,
                     const std::vector<std::pair<const char*, const char*>>& fields,
                     std::vector<std::string>* to) {
  to->push_back(fmt::format("{}Bits={}", port, bits_of<T>(c)));
  for (const auto& [parameter, field] : fields) {
    to->push_back(fmt::format("{}{}={}", port, parameter, spec::Packer<T>(c).position(field)));
  }
}

template <class Case, class In, class Out>
class VectorsOf : public UnitVectors {
 public:
  VectorsOf(const spec::Contract& contract, std::vector<Case> cases)
      : contract_(contract), cases_(std::move(cases)) {}

  std::string unit() const override { return spec::name_of(Case::kUnit); }
  size_t cases() const override { return cases_.size(); }

  std::vector<std::string> parameters() const override {
    std::vector<std::string> all{fmt::format("FrameBits={}", bits_of<spec::FrameState>(contract_)),
                                 fmt::format("InBits={}", bits_of<In>(contract_)),
                                 fmt::format("OutBits={}", bits_of<Out>(contract_))};
    if constexpr (std::is_same_v<Case, vectors::InterpZtestCase>) {
      const spec::Design& d = contract_.design;
      add_memory_port<spec::DepthRead>(contract_, "Read",
                                       {{"X", "x"}, {"Y", "y"}, {"Mask", "mask"}}, &all);
      add_memory_port<spec::DepthWrite>(
          contract_, "Write", {{"X", "x"}, {"Y", "y"}, {"Mask", "mask"}, {"Z", "z"}}, &all);
      all.push_back(fmt::format("XBits={}", contract_.width.stamp_x));
      all.push_back(fmt::format("YBits={}", contract_.width.stamp_y));
      all.push_back(fmt::format("WidthLog2={}", d.stamp_width_log2));
      all.push_back(fmt::format("HeightLog2={}", d.stamp_height_log2));
      all.push_back(fmt::format("DepthBits={}", d.depth_bits));
    }
    return all;
  }

  std::string instance() const override {
    const int in_bits = bits_of<In>(contract_);
    const int out_bits = bits_of<Out>(contract_);
    std::vector<NetlistPort> ports{{"clk_i", "clk"}, {"rst_ni", "rst_n"}, {"idle_o", "idle"}};
    const auto add_stream = [&](const std::string& name, const std::string& prefix, bool is_output,
                                const std::string& signal, int bits) {
      ports.push_back({name + (is_output ? "_valid_o" : "_valid_i"), prefix + "valid"});
      ports.push_back({name + (is_output ? "_ready_i" : "_ready_o"), prefix + "ready"});
      ports.push_back({name + (is_output ? "_o" : "_i"), signal, bits, is_output});
    };
    if constexpr (std::is_same_v<Case, vectors::SetupCase>) {
      ports.push_back({"frame_i", "frame", bits_of<spec::FrameState>(contract_)});
      add_stream("tri", "", false, "token", in_bits);
      add_stream("prim", "out_", true, "out", out_bits);
    } else if constexpr (std::is_same_v<Case, vectors::TraversalCase>) {
      add_stream("prim", "", false, "token", in_bits);
      add_stream("stamp", "out_", true, "out", out_bits);
    } else {
      const int read_bits = bits_of<spec::DepthRead>(contract_);
      const int write_bits = bits_of<spec::DepthWrite>(contract_);
      const int data_bits = bits_of<spec::DepthData>(contract_);
      ports.push_back({"depth_func_i", "depth_func", 4});
      ports.push_back({"depth_write_i", "depth_write"});
      add_stream("stamp", "", false, "token", in_bits);
      add_stream("depth_rd", "read_", true, "read", read_bits);
      add_stream("depth_rsp", "response_", false, "response", data_bits);
      add_stream("depth_wr", "write_", true, "write", write_bits);
      add_stream("color_wr", "out_", true, "out", out_bits);
    }
    return unit_instance(unit(), spec::struct_name<Out>(), ports);
  }

  std::string text() const override {
    const NetlistWords<spec::FrameState> frames(contract_);
    const NetlistWords<In> tokens(contract_);
    std::string text;
    for (const Case& c : cases_) {
      const spec::FrameState& f = c.frame;
      text += fmt::format("0 {} {:x} {:x} {:x} {:x} {:x}\n", frames.hex(f),
                          spec::cleared_depth(contract_.design, f), f.width, f.height,
                          static_cast<int>(f.depth), static_cast<int>(f.depth_write));
      for (const In& token : c.in) text += fmt::format("1 {}\n", tokens.hex(token));
    }
    return text;
  }

  Replay compare(std::istream& written) const override {
    Replay replay;
    replay.unit = unit();
    Outputs<Case> outputs(contract_);
    if (!cases_.empty()) outputs.start(cases_.front());
    for (std::string line; replay.difference.empty() && std::getline(written, line);) {
      take(line, &outputs, &replay);
    }
    replay.is_complete |= !replay.difference.empty();
    return replay;
  }

 private:
  void take(const std::string& line, Outputs<Case>* outputs, Replay* replay) const {
    std::istringstream words(line);
    std::string kind, stream, cycle, hex, difference;
    words >> kind;
    if (kind == "end") replay->is_complete = replay->cases == cases_.size();
    if (replay->cases == cases_.size()) return;
    const std::string name = cases_[replay->cases].name;
    if (kind == "out") {
      words >> stream >> cycle >> hex;
      if (stream == spec::struct_name<spec::DepthRead>()) return;  // its answer is what counts
      ++replay->words;
      difference = outputs->take(stream, cycle, hex);
    } else if (kind == "done") {
      words >> cycle;
      difference = outputs->end(cycle);
      if (difference.empty() && ++replay->cases < cases_.size()) {
        outputs->start(cases_[replay->cases]);
      }
    } else if (kind == "fault") {
      words >> cycle;
      std::getline(words >> std::ws, difference);
      difference = fmt::format("cycle {}: {}", cycle, difference);
    }
    if (!cycle.empty()) replay->cycles = std::stoll(cycle);
    if (!difference.empty()) {
      replay->difference = fmt::format("{} case {}: {}", unit(), name, difference);
    }
  }

  spec::Contract contract_;
  std::vector<Case> cases_;
};

/// `count` of the elements, evenly spread; 0: all.
template <class T>
std::vector<T> spread(const std::vector<T>& all, size_t count) {
  if (count == 0 || count >= all.size()) return all;
  std::vector<T> some;
  for (size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

template <class Case, class In, class Out>
std::unique_ptr<UnitVectors> read(const spec::Contract& contract, const std::string& file,
                                  size_t cases) {
  return std::make_unique<VectorsOf<Case, In, Out>>(contract,
                                                    spread(vectors::read<Case>(file).cases, cases));
}

/// The committed file of a unit in the formats of the design.
std::string committed_file(const spec::Contract& contract, const std::string& unit) {
  const fs::path folder = files::data_folder() / "vectors" / unit;
  std::set<std::string> designs;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = vectors::read_header(entry.path().string()).contract.design.name;
    const spec::Design* design = spec::find_design(name);
    if (design == nullptr) continue;
    if (spec::formats_hash(spec::contract(*design)) == spec::formats_hash(contract)) {
      return entry.path().string();
    }
    designs.insert(name);
  }
  throw AreaError(fmt::format("{}: expected vectors in the formats of {}, they are in those of {}",
                              folder.string(), contract.design.name, fmt::join(designs, ", ")));
}

}  // namespace

std::unique_ptr<UnitVectors> committed_vectors(const spec::Contract& contract,
                                               const std::string& unit, size_t cases) {
  const std::string file = committed_file(contract, unit);
  if (unit == "setup") {
    return read<vectors::SetupCase, spec::Triangle, spec::SetupPrim>(contract, file, cases);
  }
  if (unit == "traversal") {
    return read<vectors::TraversalCase, spec::SetupPrim, spec::Stamp>(contract, file, cases);
  }
  return read<vectors::InterpZtestCase, spec::Stamp, spec::ColorWrite>(contract, file, cases);
}

}  // namespace pineda::studies
