// emit_schemes FOLDER: writes FOLDER/NAME/pineda_pkg.sv of each design in schemes.h, and of the
// named ones.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "model/spec/package.h"
#include "tests/spec/schemes.h"

int main(int argc, char** argv) {
  using namespace pineda::spec;
  if (argc != 2) {
    std::cerr << "usage: emit_schemes FOLDER\n";
    return 2;
  }
  std::vector<Design> all(std::begin(kSchemes), std::end(kSchemes));
  all.insert(all.end(), std::begin(kSetups), std::end(kSetups));
  all.insert(all.end(), designs().begin(), designs().end());
  for (const Design& design : all) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / design.name;
    std::filesystem::create_directories(folder);
    std::ofstream file(folder / "pineda_pkg.sv", std::ios::binary);
    file << package_text(contract(design));
    file.close();
    if (!file) {
      std::cerr << "emit_schemes: cannot write into " << folder << '\n';
      return 2;
    }
  }
  return 0;
}
