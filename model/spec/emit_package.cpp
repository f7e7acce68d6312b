// emit_package DESIGN FOLDER [--bench]: writes pineda_pkg.sv of a design, given by name or as a
// .toml file. --bench also writes the sources that the test bench's plug-in is built from:
// loopback.sv, loopback_ports.inc, package_hash.inc.
#include <fmt/format.h>

#include <fstream>
#include <string>

#include "model/spec/design_file.h"
#include "model/spec/package.h"

namespace {

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) fmt::print(stderr, "emit_package: cannot write {}\n", path);
  return static_cast<bool>(file);
}

int emit(const std::string& name, const std::string& folder, bool bench) {
  using namespace pineda::spec;
  const bool is_file = name.size() > 5 && name.substr(name.size() - 5) == ".toml";
  const Design* named = find_design(name);
  if (!is_file && named == nullptr) {
    fmt::print(stderr, "emit_package: unknown design '{}'\n", name);
    return 2;
  }
  const Design design = is_file ? read_design(name) : *named;
  if (const std::string reason = no_rtl_reason(design); !reason.empty()) {
    fmt::print(stderr, "emit_package: {}: {}\n", design.name, reason);
    return 2;
  }
  const Contract c = contract(design);
  bool good = write(folder + "/pineda_pkg.sv", package_text(c));
  if (bench) {
    good = write(folder + "/package_hash.inc", fmt::format("{:#x}u\n", package_hash(c))) && good;
    good = write(folder + "/loopback.sv", loopback_text(c)) && good;
    good = write(folder + "/loopback_ports.inc", loopback_ports(c)) && good;
  }
  return good ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  const bool bench = argc == 4 && std::string(argv[3]) == "--bench";
  if (argc != 3 && !bench) {
    fmt::print(stderr, "usage: emit_package DESIGN FOLDER [--bench]\n");
    return 2;
  }
  try {
    return emit(argv[1], argv[2], bench);
  } catch (const std::exception& error) {
    fmt::print(stderr, "emit_package: {}\n", error.what());
    return 2;
  }
}
