#include "cli/simd_option.h"

#include <string>
#include <vector>

#include "model/fast/level.h"

namespace pineda::cli {

void add_simd_option(CLI::App* command) {
  std::vector<std::string> names;
  for (const fast::Level level : fast::levels()) names.emplace_back(fast::level_name(level));
  const auto choose = [](const std::string& name) {
    for (const fast::Level level : fast::levels()) {
      if (name == fast::level_name(level)) fast::set_level(level);
    }
  };
  command
      ->add_option_function<std::string>(
          "--simd", choose, "Vector unit, of those that this machine has; the best unless given")
      ->check(CLI::IsMember(names))
      ->type_name("NAME");
}

}  // namespace pineda::cli
