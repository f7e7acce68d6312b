// emit_package DESIGN FOLDER: writes pineda_pkg.sv of a named design; with --bench also what its
// plug-in is built from: loopback.sv, loopback_ports.inc, package_hash.inc.
#include <fmt/format.h>

#include <fstream>
#include <string>

#include "model/spec/package.h"

namespace {

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) fmt::print(stderr, "emit_package: cannot write {}\n", path);
  return static_cast<bool>(file);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace pineda::spec;
  const bool bench = argc == 4 && std::string(argv[3]) == "--bench";
  if (argc != 3 && !bench) {
    fmt::print(stderr, "usage: emit_package DESIGN FOLDER [--bench]\n");
    return 2;
  }
  const Design* design = find_design(argv[1]);
  if (design == nullptr) {
    fmt::print(stderr, "emit_package: unknown design '{}'\n", argv[1]);
    return 2;
  }
  if (const std::string reason = no_rtl_reason(*design); !reason.empty()) {
    fmt::print(stderr, "emit_package: {}: {}\n", design->name, reason);
    return 2;
  }
  const Contract c = contract(*design);
  const std::string folder = argv[2];
  bool good = write(folder + "/pineda_pkg.sv", package_text(c));
  if (bench) {
    good = write(folder + "/package_hash.inc", fmt::format("{:#x}u\n", package_hash(c))) && good;
    good = write(folder + "/loopback.sv", loopback_text(c)) && good;
    good = write(folder + "/loopback_ports.inc", loopback_ports(c)) && good;
  }
  return good ? 0 : 2;
}
