// Where the program finds what it reads at run time, in a build tree and installed.
#pragma once

#include <filesystem>

namespace pineda::files {

/// The folder of the program or of the shared library that this function is linked into.
std::filesystem::path own_folder();

/// The folder that has rtl/, tb/, vectors/ and studies/ as they lie in the sources: PREFIX/share/pineda
/// where own_folder() is PREFIX/bin or PREFIX/lib of an installed tree, moved or not; else the sources
/// that this was built from.
std::filesystem::path data_folder();

}  // namespace pineda::files
