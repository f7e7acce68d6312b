// Which lines of the RTL ran and which bits changed, by file.
#pragma once

#include "cli/output.h"
#include "studies/vectors/code_waivers.h"

namespace pineda::cli {

/// What must be hit at least, %.
inline constexpr double kLeastLines = 100, kLeastToggles = 95;

/// Points of one kind.
struct CodeTally {
  uint64_t hit = 0;
  uint64_t missed = 0;  // and not waived
  uint64_t waived = 0;  // and not hit

  uint64_t points() const { return hit + missed; }
  double percent() const;
};

/// A missed or waived block, or the bits of a signal that stand side by side.
struct CodeGap {
  int line = 0;
  bool is_bits = false;
  std::string what;  // "else: if (accept)", "prim.e[0][38:36]"
  uint64_t points = 1;
  const vectors::CodeWaiver* waiver = nullptr;
};

struct FileCoverage {
  std::string file;  // in rtl/
  CodeTally lines, toggles;
  std::vector<CodeGap> gaps;
};

struct CodeCoverage {
  std::vector<vectors::CodeWaiver> waivers;
  std::vector<FileCoverage> files;
  CodeTally lines, toggles;  // of all

  bool holds() const {
    return lines.percent() >= kLeastLines && toggles.percent() >= kLeastToggles;
  }
};

/// Waivers of the project: a file.
std::string default_code_waivers();

/// Errors   vectors::Refused: a waiver that waives nothing.
CodeCoverage code_coverage(const vectors::CodeCounts& counts,
                           std::vector<vectors::CodeWaiver> waivers,
                           const spec::Contract& contract);

void print_code_coverage(const Output& output, const CodeCoverage& coverage);
Json code_coverage_json(const CodeCoverage& coverage);

}  // namespace pineda::cli
