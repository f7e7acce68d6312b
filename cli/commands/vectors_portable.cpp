// Portable cases: made of frame vectors, counted, and written as scenes.
#include <filesystem>

#include "cli/commands/vectors.h"
#include "model/scene/tri_writer.h"
#include "model/scene/writers.h"
#include "studies/portable/portable_file.h"

namespace pineda::cli {
namespace {

using studies::PortableCase;

std::string class_of(const PortableCase& value) {
  return value.name.substr(0, value.name.rfind('.'));
}

}  // namespace

void export_portable(const VectorOptions& options, const Output& output) {
  if (vectors::read_header(options.file).unit != vectors::Unit::kFrame) {
    throw UsageError(options.file + ": expected vectors of the unit frame");
  }
  vectors::Reader<vectors::FrameCase> reader(options.file);
  const vectors::Header& from = reader.header();
  const spec::Design& design = from.contract.design;
  studies::PortableHeader header{{}, design.name, from.level, from.seed};
  header.tolerance.format = {design.subpixel_bits, design.guard_bits, design.depth_bits, 4, 8};
  header.tolerance.depth_ulp = options.depth_ulp.value_or(header.tolerance.depth_ulp);
  header.tolerance.color_lsb = options.color_lsb.value_or(header.tolerance.color_lsb);
  vectors::WholeFile file(options.result);
  *file.stream() << studies::portable_header(header);
  uint64_t cases = 0, large = 0;
  for (vectors::FrameCase vector; reader.next(&vector);) {
    const PortableCase value = studies::portable_case(from.contract, vector);
    if (value.samples() > studies::kPortableSamples) {
      ++large;
      continue;
    }
    *file.stream() << studies::portable_text(value, header.tolerance);
    ++cases;
  }
  *file.stream() << studies::portable_end(cases);
  file.keep();
  output.line("{}: {} portable cases, formats of {}", options.result, grouped(cases), design.name);
  output.row("left out", fmt::format("{} frames of more than {} samples", grouped(large),
                                     grouped(studies::kPortableSamples)));
}

void export_scenes(const VectorOptions& options, const Output& output) {
  // Read to its end before anything is written.
  studies::PortableReader reader(options.file);
  std::vector<PortableCase> cases;
  for (PortableCase value; reader.next(&value);) cases.push_back(value);
  for (const PortableCase& value : cases) {
    const auto path = std::filesystem::path(options.result) / (value.name + ".tri");
    scene::write_file(path.string(), scene::tri_text(value.frame, value.triangles));
  }
  output.line("{}: {} scenes", options.result, grouped(cases.size()));
}

int portable_info(const VectorOptions& options) {
  const Output output(options);
  studies::PortableReader reader(options.file);
  const studies::PortableHeader& header = reader.header();
  uint64_t cases = 0, triangles = 0;
  std::map<std::string, size_t> classes;
  for (PortableCase value; reader.next(&value); ++cases) {
    triangles += value.triangles.size();
    ++classes[class_of(value)];
  }
  const studies::FrameTolerance& t = header.tolerance;
  output.line("{}: {} portable cases, of {}, level {}, seed {}", options.file, grouped(cases),
              header.design, header.level, header.seed);
  output.row("triangles", grouped(triangles));
  output.row("tolerance",
             fmt::format("{} subpixel bits, {} depth bits, {} ulp, {} LSB", t.format.subpixel_bits,
                         t.format.depth_bits, t.depth_ulp, t.color_lsb));
  output.line("\n{:<24}{:>8}", "class", "cases");
  for (const auto& [name, count] : classes) output.line("{:<24}{:>8}", name, count);
  output.json({{"file", options.file},
               {"design", header.design},
               {"level", header.level},
               {"seed", header.seed},
               {"subpixel_bits", t.format.subpixel_bits},
               {"depth_bits", t.format.depth_bits},
               {"depth_ulp", t.depth_ulp},
               {"color_lsb", t.color_lsb},
               {"cases", cases},
               {"triangles", triangles},
               {"classes", classes}});
  return kHolds;
}

}  // namespace pineda::cli
