#include "model/files/data_folder.h"

#include <dlfcn.h>

namespace pineda::files {
namespace {

namespace fs = std::filesystem;

// The dynamic linker calls the program by the name that it was started with.
fs::path own_file() {
  Dl_info info{};
  const bool is_known = dladdr(reinterpret_cast<const void*>(&own_folder), &info) != 0;
  const fs::path named = is_known && info.dli_fname != nullptr ? info.dli_fname : "";
  std::error_code none;
  if (named.extension() == ".so" || named.string().find(".so.") != std::string::npos) {
    return fs::canonical(named, none);
  }
  return fs::read_symlink("/proc/self/exe");
}

}  // namespace

fs::path own_folder() { return own_file().parent_path(); }

fs::path data_folder() {
  const fs::path installed = own_folder().parent_path() / "share/pineda";
  return fs::exists(installed / "rtl/files.f") ? installed : fs::path(PINEDA_SOURCE_DIR);
}

}  // namespace pineda::files
