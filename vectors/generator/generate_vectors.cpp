// generate_vectors --unit U --level L --seed N -o FILE [--design NAME]
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <map>

#include "vectors/generator/generate.h"

namespace {

using namespace pineda;

std::string usage() {
  return fmt::format(
      "usage: generate_vectors --unit {} --level 1|2 --seed N\n"
      "                        -o FILE [--design NAME]\n",
      spec::joined(spec::word_list<vectors::Unit>(), "|", "|"));
}

/// Bad usage; what() says in one line what was expected.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The options, each with a value and given once.
std::map<std::string, std::string> parse(int argc, char** argv) {
  std::map<std::string, std::string> options{{"--design", "high_tile"}};
  std::map<std::string, int> seen;
  for (int i = 1; i < argc; i += 2) {
    const std::string option = argv[i];
    const bool known = option == "--unit" || option == "--level" || option == "--seed" ||
                       option == "-o" || option == "--design";
    if (!known) throw UsageError("unknown option '" + option + "'");
    if (i + 1 == argc) throw UsageError("expected a value after " + option);
    if (++seen[option] > 1) throw UsageError(option + " is given twice");
    options[option] = argv[i + 1];
  }
  for (const char* option : {"--unit", "--level", "--seed", "-o"}) {
    if (options.count(option) == 0) throw UsageError(std::string("expected ") + option);
  }
  return options;
}

uint64_t number(const std::string& option, const std::string& text) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw UsageError("expected a number after " + option + ", got '" + text + "'");
  }
  return value;
}

void run(int argc, char** argv) {
  const auto options = parse(argc, argv);
  const auto unit = spec::named<vectors::Unit>(options.at("--unit"));
  if (!unit) throw UsageError("unknown unit '" + options.at("--unit") + "'");
  const uint64_t level = number("--level", options.at("--level"));
  if (level < 1 || level > vectors::kMaxLevel) throw UsageError("expected --level 1 or 2");
  const spec::Design* design = spec::find_design(options.at("--design"));
  if (design == nullptr) throw UsageError("unknown design '" + options.at("--design") + "'");
  const vectors::Tally tally = vectors::generate_file(
      *unit, spec::contract(*design), static_cast<int>(level),
      number("--seed", options.at("--seed")), spec::error_bounds(*design), options.at("-o"));
  fmt::print(stderr,
             "{}: {} cases; of the scenes, {} reach the unit with nothing, {} are too large\n",
             options.at("-o"), tally.cases, tally.empty, tally.large);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--help") {
    fmt::print("{}", usage());
    return 0;
  }
  try {
    run(argc, argv);
    return 0;
  } catch (const UsageError& error) {
    fmt::print(stderr, "generate_vectors: {}; see --help\n", error.what());
    return 2;
  } catch (const vectors::Refused& error) {
    fmt::print(stderr, "generate_vectors: {}\n", error.what());
    return 2;
  } catch (const vectors::Misjudged& error) {
    fmt::print(stderr, "generate_vectors: {}\n", error.what());
    return 1;
  }
}
