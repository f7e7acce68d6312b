#include "cli/study_scenes.h"

#include <filesystem>

namespace pineda::cli {
namespace {

constexpr const char* kBunny = "bunny";
constexpr int kBunnyGuardBits = 11;  // 2^11 px, for 1920x1080
constexpr const char* kScenes[] = {kBunny, "teapot", "random/px1", "random/px1000",
                                   "random/screen"};

}  // namespace

std::vector<std::string> study_scenes(const std::vector<std::string>& asked,
                                      const std::string& bunny_file,
                                      std::vector<std::string>* left_out) {
  if (!asked.empty()) return asked;
  std::vector<std::string> scenes;
  for (const char* name : kScenes) {
    const bool there = std::string(name) != kBunny || std::filesystem::exists(bunny_file);
    (there ? scenes : *left_out).emplace_back(name);
  }
  return scenes;
}

scene::Scene open_study_scene(Options options, const std::string& bunny_file,
                              const std::string& name, const spec::Contract& contract) {
  const bool is_bunny = name == kBunny;
  options.scene = is_bunny ? bunny_file : name;
  const bool fits = contract.design.guard_bits >= kBunnyGuardBits;
  if (is_bunny && options.size.empty() && fits) options.size = "1920x1080";
  return open(options, contract, false);
}

}  // namespace pineda::cli
