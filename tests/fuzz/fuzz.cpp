// One reader of files under libFuzzer: for any bytes it gives a scene or a message of one clear
// line.
//
// FUZZ_ENDING is the ending of the file that the bytes become, ".obj" for instance.
#include <stdlib.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model/scene/scene.h"
#include "model/spec/design_file.h"

namespace {

using namespace pineda;

/// A folder of this process's own, and the input in it.
class InputFile {
 public:
  InputFile() {
    std::string folder = (std::filesystem::temp_directory_path() / "pineda-fuzz-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) std::abort();
    folder_ = folder;
  }
  ~InputFile() {
    std::remove(path().c_str());
    rmdir(folder_.c_str());
  }
  std::string path() const { return folder_ + "/input" FUZZ_ENDING; }
  void write(const uint8_t* bytes, size_t size) const {
    std::ofstream file(path(), std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    if (!file.flush()) std::abort();
  }

 private:
  std::string folder_;
};

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

/// The message must be one line, short, and printable.
void check_message(const std::string& message) {
  require(!message.empty() && message.size() < 1500, "a message of one line");
  for (const char c : message) require(c >= ' ' && c <= '~', "a message that can be printed");
}

void read_design(const std::string& path) {
  try {
    const spec::Contract contract = spec::contract(spec::read_design(path));
    require(spec::invalid_reason(contract.design).empty(), "a design that was read is valid");
  } catch (const spec::DesignFileError& error) {
    check_message(error.what());
  }
}

/// Options that the input does not state, derived from its bytes, so that a finding can be
/// repeated.
scene::Options options_of(std::string_view bytes) {
  constexpr std::string_view kEnding = FUZZ_ENDING;
  scene::Options options;
  if (kEnding == ".tri" || kEnding == ".ptrb") return options;
  options.size = scene::Size{64, 48};
  uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  hash >>= 32;
  options.reverse_z = hash % 2 == 1;
  const auto camera = static_cast<int>(hash / 2 % 3);
  if ((kEnding == ".gltf" || kEnding == ".glb") && camera < 2) options.camera_number = camera;
  return options;
}

void read_scene(const std::string& path, const scene::Options& options) {
  constexpr int kMostTriangles = 20000;
  const spec::Contract contract = spec::contract(spec::kHighTile);
  try {
    const scene::Scene scene = scene::open_scene(contract, path, options);
    for (const std::string& warning : scene.warnings) check_message(warning);
    spec::Triangle triangle;
    for (int n = 0; n < kMostTriangles && scene.source->next(&triangle); ++n) {
      const int32_t limit = 1 << (contract.design.guard_bits + contract.design.subpixel_bits);
      for (const spec::Vertex& v : triangle.v) {
        require(v.x >= -limit && v.x < limit && v.y >= -limit && v.y < limit, "the guard band");
      }
    }
    for (const std::string& note : scene::notes(scene)) check_message(note);
  } catch (const scene::InputError& error) {
    check_message(error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  static const InputFile input;
  input.write(bytes, size);
  if (std::string(FUZZ_ENDING) == ".toml") {
    read_design(input.path());
  } else {
    read_scene(input.path(), options_of({reinterpret_cast<const char*>(bytes), size}));
  }
  return 0;
}
