// The scenes that studies compare designs on.
#pragma once

#include <string>
#include <vector>

#include "cli/options.h"

namespace pineda::cli {

/// Where Debian's glmark2-data has the scene "bunny".
inline constexpr const char* kBunnyFile = "/usr/share/glmark2/models/bunny.obj";

/// The names asked for; if there are none, the five default ones, without the bunny if its file is
/// not there: it is then in *left_out.
std::vector<std::string> study_scenes(const std::vector<std::string>& asked,
                                      const std::string& bunny_file,
                                      std::vector<std::string>* left_out);

/// Opens one of them, "bunny" or a scene as commands take it. The bunny is 1920x1080 if `options`
/// say no size and the design's frames are large enough.
scene::Scene open_study_scene(Options options, const std::string& bunny_file,
                              const std::string& name, const spec::Contract& contract);

}  // namespace pineda::cli
