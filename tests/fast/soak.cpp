// fast_soak: random frames of the quick model on each vector unit, sample by sample equal to core.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "model/fast/level.h"
#include "model/spec/widths.h"
#include "tests/fast/random_frames.h"

namespace {

using namespace pineda;

// Two of three frames are the default design's, the third one is the next named design's.
const spec::Design& design_of(uint64_t frame) {
  const auto& all = spec::designs();
  return frame % 3 < 2 ? *spec::find_design("high_tile") : all[frame / 3 % all.size()];
}

// Exit code: 1 where a frame differs.
int soak(fast::Level level, uint64_t samples, uint64_t seed) {
  fast::set_level(level);
  uint64_t drawn = 0, frames = 0;
  for (; drawn < samples; ++frames) {
    const spec::Contract c = spec::contract(design_of(frames));
    const std::string differs = test::compare(c, c, seed + frames, &drawn);
    if (differs.empty()) continue;
    fmt::print("{}: {}, seed {}: {} differs\n", fast::level_name(level), c.design.name,
               seed + frames, differs);
    return 1;
  }
  fmt::print("{}: {} samples that passed in {} frames, equal\n", fast::level_name(level), drawn,
             frames);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random frames on each vector unit of this machine, compared with core");
  uint64_t samples = 1'000'000'000, seed = 1;
  app.add_option("--samples", samples, "That pass, on each vector unit")->capture_default_str();
  app.add_option("--seed", seed, "Of the first frame")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  int exit_code = 0;
  for (const fast::Level level : fast::levels()) exit_code |= soak(level, samples, seed);
  return exit_code;
}
