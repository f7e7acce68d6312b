// What the commands of pineda vectors share.
#pragma once

#include <optional>
#include <string>

#include "cli/output.h"
#include "model/spec/package.h"
#include "vectors/grammar/file.h"

namespace pineda::cli {

/// What vectors are exported as.
enum class VectorForm { kReadmemh, kCsv, kJson, kPortable, kTri };
inline constexpr spec::Name<VectorForm> kVectorFormNames[] = {{VectorForm::kReadmemh, "readmemh"},
                                                              {VectorForm::kCsv, "csv"},
                                                              {VectorForm::kJson, "json"},
                                                              {VectorForm::kPortable, "portable"},
                                                              {VectorForm::kTri, "tri"}};
constexpr const auto& names(VectorForm) { return kVectorFormNames; }

struct VectorOptions : Options {
  std::string file;
  std::string unit;
  int level = 1;
  std::optional<uint64_t> count;
  std::string on = "rtl";
  std::string command;                         // of shrink, in place of the RTL
  std::string result;                          // of shrink and export
  std::string form;                            // of export
  std::optional<double> depth_ulp, color_lsb;  // of portable cases
  // Of score
  std::vector<std::string> files;
  int mutants = 1000;  // of all units together
  bool all = false;    // printed, not only those that live
  bool no_proofs = false;
};

/// Calls work(Case{}) with the case of a unit.
template <class Work>
auto with_case(vectors::Unit unit, Work&& work) {
  switch (unit) {
    case vectors::Unit::kSetup:
      return work(vectors::SetupCase{});
    case vectors::Unit::kTraversal:
      return work(vectors::TraversalCase{});
    case vectors::Unit::kInterpZtest:
      return work(vectors::InterpZtestCase{});
    case vectors::Unit::kFrame:
      break;
  }
  return work(vectors::FrameCase{});
}

inline Json header_json(const VectorOptions& options, const vectors::Header& header) {
  return {{"file", options.file},
          {"unit", spec::name_of(header.unit)},
          {"design", header.contract.design.name},
          {"level", header.level},
          {"seed", header.seed},
          {"formats", fmt::format("{:016x}", spec::formats_hash(header.contract))}};
}

/// The first case that fails, made smaller.
int shrink_vectors(const VectorOptions& options);

/// How many mutants of the RTL die.
int score_vectors(const VectorOptions& options);

/// The streams in another form.
int export_vectors(const VectorOptions& options);

/// Frames as cases for any rasterizer.
void export_portable(const VectorOptions& options, const Output& output);
/// Portable cases as a folder of .tri files.
void export_scenes(const VectorOptions& options, const Output& output);
/// What a file of portable cases holds.
int portable_info(const VectorOptions& options);

/// Code coverage of the RTL.
void add_coverage(CLI::App* parent, int* exit_code);

/// Everything on one page.
void add_report(CLI::App* parent, int* exit_code);

}  // namespace pineda::cli
