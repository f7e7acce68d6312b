// pineda judge: the frame of any rasterizer against exact arithmetic.
#include <memory>

#include "cli/output.h"
#include "cli/reserved_file.h"
#include "model/scene/resnap.h"
#include "studies/judge/frame_diagnosis.h"

namespace pineda::cli {
namespace {

using studies::Diagnosis;
using studies::FrameTolerance;

struct JudgeOptions : Options {
  std::string dump;
  std::optional<int> subpixel_bits, depth_bits;
  double depth_ulp = 1;
  double color_lsb = 1;
  std::string out;  // the smallest scene
};

/// A design with perspective, since a scene's colours have it, and with the positions and depths of the
/// rasterizer that is judged.
spec::Contract contract_of_frame(const JudgeOptions& options) {
  const spec::Design formats = contract_of(options).design;
  spec::Design design = *spec::find_design("persp");
  design.guard_bits = formats.guard_bits;
  design.subpixel_bits = options.subpixel_bits.value_or(formats.subpixel_bits);
  design.depth_bits = options.depth_bits.value_or(formats.depth_bits);
  const std::string why = spec::invalid_reason(design);
  if (!why.empty()) throw UsageError(why);
  return spec::contract(design);
}

/// Calls visit(ScreenTriangle) for each triangle, from the start.
template <class Visit>
void for_each_triangle(const scene::Scene& scene, const char* phase, Progress* progress,
                       Visit&& visit) {
  scene.source->rewind();
  scene::Unsnapped triangles(scene.source.get());
  scene::Counters counters;
  scene::ScreenTriangle triangle;
  for (uint64_t n = 0; triangles.read(&triangle, &counters); ++n) {
    progress->update(phase, n);
    visit(triangle);
  }
}

/// The scene as .tri, its raster state with these triangles alone.
std::string tri_text(const scene::Scene& scene,
                     const std::vector<scene::ScreenTriangle>& triangles) {
  const spec::FrameState& f = scene.frame;
  std::string text = fmt::format("pineda-tri 1\nsize {} {}\ncull {}\ndepth {}\n", f.width, f.height,
                                 spec::name_of(f.cull), spec::name_of(f.depth));
  if (f.scissor_x1 != spec::kNoScissorPx || f.scissor_y1 != spec::kNoScissorPx ||
      f.scissor_x0 != 0 || f.scissor_y0 != 0) {
    text += fmt::format("scissor {} {} {} {}\n", f.scissor_x0, f.scissor_y0,
                        f.scissor_x1 - f.scissor_x0, f.scissor_y1 - f.scissor_y0);
  }
  text += fmt::format("depthwrite {}\n", spec::name_of(f.depth_write));
  if (f.has_bias()) text += fmt::format("depthbias {} {}\n", f.bias_constant, f.bias_slope / 256.);
  if (f.clear_depth != 1) text += fmt::format("cleardepth {:a}\n", f.clear_depth);
  text += fmt::format("shade {}\n", spec::name_of(f.shade));
  for (const scene::ScreenTriangle& triangle : triangles) {
    for (const scene::ScreenVertex& v : triangle.v) {
      text += fmt::format("v {:a} {:a} {:a} {:a} {} {} {} {}\n", v.x, v.y, v.z, v.w, v.rgba[0],
                          v.rgba[1], v.rgba[2], v.rgba[3]);
    }
  }
  return text;
}

Json diagnosis_json(const Diagnosis& first) {
  Json json{{"x", first.x}, {"y", first.y}, {"triangle", -1}};
  if (first.triangle) json["triangle"] = *first.triangle;
  json["rule"] = spec::name_of(first.rule);
  json["what"] = first.what;
  return json;
}

int run(const JudgeOptions& options) {
  const Output output(options);
  Progress progress(options);
  require_ending("-o", options.out, {".tri"});
  const spec::Contract contract = contract_of_frame(options);
  const scene::Scene scene = open(options, contract, true);
  std::optional<ReservedFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  const auto dump = studies::read_dump(options.dump, scene.frame.width, scene.frame.height);
  FrameTolerance tolerance;
  tolerance.format = {contract.design.subpixel_bits, contract.design.guard_bits,
                      contract.design.depth_bits, 4, 8};
  tolerance.depth_ulp = options.depth_ulp;
  tolerance.color_lsb = options.color_lsb;
  studies::FrameJudge judge(scene.frame, tolerance, dump);
  for_each_triangle(scene, "judging", &progress,
                    [&](const scene::ScreenTriangle& triangle) { judge.triangle(triangle); });
  const scene::Counters input = scene.source->counters();
  const std::vector<size_t> wrong = judge.wrong();
  std::optional<Diagnosis> first;
  if (!wrong.empty()) {
    studies::FrameDiagnosis diagnosis(scene.frame, tolerance, dump, wrong.front(),
                                      scene.mesh.get());
    for_each_triangle(scene, "explaining", &progress,
                      [&](const scene::ScreenTriangle& triangle) { diagnosis.triangle(triangle); });
    first = diagnosis.result();
  }
  progress.clear();
  print_notes(output, scene);

  const size_t samples =
      static_cast<size_t>(scene.frame.width) * static_cast<size_t>(scene.frame.height);
  Json json{{"scene", scene.name},
            {"width", scene.frame.width},
            {"height", scene.frame.height},
            {"subpixel_bits", tolerance.format.subpixel_bits},
            {"depth_bits", tolerance.format.depth_bits},
            {"depth_ulp", tolerance.depth_ulp},
            {"color_lsb", tolerance.color_lsb},
            {"triangles", input.triangles},
            {"samples", samples},
            {"verdict", wrong.empty() ? "holds" : "fails"},
            {"samples_wrong", wrong.size()}};
  std::vector<std::string> judged;
  if (dump.hits) judged.emplace_back("hits");
  if (dump.depth) judged.emplace_back("depth");
  if (dump.color) judged.emplace_back("colour");
  json["judged"] = judged;
  output.line("{}: {}x{}, {} in {}", scene.name, scene.frame.width, scene.frame.height,
              fmt::join(judged, ", "), options.dump);
  print_state(output, scene);
  output.row("triangles", grouped(input.triangles));
  output.row("tolerance", fmt::format("{} subpixel bits, {} depth bits, {} ulp, {} LSB",
                                      tolerance.format.subpixel_bits, tolerance.format.depth_bits,
                                      tolerance.depth_ulp, tolerance.color_lsb));
  output.row("samples wrong", fmt::format("{} of {}", grouped(wrong.size()), grouped(samples)));
  if (first) {
    json["first"] = diagnosis_json(*first);
    output.row("first",
               fmt::format("({}, {}), {}{}", first->x, first->y, spec::name_of(first->rule),
                           first->triangle ? fmt::format(", triangle {}", *first->triangle)
                                           : std::string()));
    output.row("", first->what);
    if (out) {
      const std::string text = tri_text(scene, first->scene);
      out->keep(std::fputs(text.c_str(), out->file()) >= 0);
      output.row("smallest scene",
                 fmt::format("{}: {} of its triangles", options.out, first->scene.size()));
    }
  }
  output.line("{}", wrong.empty() ? "It holds." : "IT DOES NOT HOLD.");
  output.json(json);
  return wrong.empty() ? kHolds : kMismatch;
}

}  // namespace

void add_judge(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<JudgeOptions>();
  auto* command =
      program->add_subcommand("judge", "The frame of any rasterizer against exact arithmetic");
  add_scene_options(command, options.get());
  command
      ->add_option("--dump", options->dump,
                   "Folder with those of hits.u16, depth.u32 and color.rgba that there are")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--subpixel-bits", options->subpixel_bits,
                   "Positions are snapped to 2^-S px; default: the design's, 8")
      ->type_name("S");
  command
      ->add_option("--depth-bits", options->depth_bits,
                   "Of a depth code; default: the design's, 24")
      ->type_name("N");
  command->add_option("--depth-ulp", options->depth_ulp, "Greatest error of a depth, codes")
      ->check(CLI::Range(0., 4294967296.))
      ->type_name("E")
      ->capture_default_str();
  command->add_option("--color-lsb", options->color_lsb, "Greatest error of a colour, of 255")
      ->check(CLI::Range(0., 255.))
      ->type_name("E")
      ->capture_default_str();
  command->add_option("-o,--out", options->out, "The triangles that show the first wrong sample")
      ->type_name("FILE.tri");
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
