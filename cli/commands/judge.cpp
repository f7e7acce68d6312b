// pineda judge: the frame of any rasterizer against exact arithmetic.
#include "cli/commands/judge.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "model/scene/resnap.h"
#include "model/scene/tri_writer.h"
#include "vectors/grammar/text.h"

namespace pineda::cli {

Json diagnosis_json(const studies::Diagnosis& first) {
  Json json{{"x", first.x}, {"y", first.y}, {"triangle", -1}};
  if (first.triangle) json["triangle"] = *first.triangle;
  json["rule"] = spec::name_of(first.rule);
  json["what"] = first.what;
  return json;
}

std::string diagnosis_text(const studies::Diagnosis& first) {
  return fmt::format(
      "({}, {}), {}{}", first.x, first.y, spec::name_of(first.rule),
      first.triangle ? fmt::format(", triangle {}", *first.triangle) : std::string());
}

void write_smallest_scene(const JudgeOptions& options, const spec::FrameState& frame,
                          const studies::Diagnosis& first, ReservedFile* out,
                          const Output& output) {
  const std::string text = scene::tri_text(frame, first.scene);
  out->keep(std::fputs(text.c_str(), out->file()) >= 0);
  output.row("smallest scene",
             fmt::format("{}: {} of its triangles", options.out, first.scene.size()));
}

namespace {

using studies::FrameTolerance;
using studies::FrameVerdict;

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

int judge_scene(const JudgeOptions& options) {
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
  tolerance.depth_ulp = options.depth_ulp.value_or(tolerance.depth_ulp);
  tolerance.color_lsb = options.color_lsb.value_or(tolerance.color_lsb);
  const FrameVerdict verdict = studies::judge_frame(
      scene.frame, tolerance, dump, scene.mesh.get(), [&](const char* phase, const auto& visit) {
        for_each_triangle(scene, phase, &progress, visit);
      });
  const scene::Counters input = scene.source->counters();
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
            {"verdict", verdict.holds() ? "holds" : "fails"},
            {"samples_wrong", verdict.wrong.size()}};
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
  output.row("samples wrong",
             fmt::format("{} of {}", grouped(verdict.wrong.size()), grouped(samples)));
  if (verdict.first) {
    json["first"] = diagnosis_json(*verdict.first);
    output.row("first", diagnosis_text(*verdict.first));
    output.row("", verdict.first->what);
    if (out) write_smallest_scene(options, scene.frame, *verdict.first, &*out, output);
  }
  output.line("{}", verdict.holds() ? "It holds." : "IT DOES NOT HOLD.");
  output.json(json);
  return verdict.holds() ? kHolds : kMismatch;
}

}  // namespace

void add_judge(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<JudgeOptions>();
  auto* command =
      program->add_subcommand("judge", "The frame of any rasterizer against exact arithmetic");
  add_scene_options(command, options.get());
  command->get_option("scene")->required(false);
  command
      ->add_option("--subpixel-bits", options->subpixel_bits,
                   "Positions are snapped to 2^-S px; default: the design's, 8")
      ->type_name("S");
  command
      ->add_option("--depth-bits", options->depth_bits,
                   "Of a depth code; default: the design's, 24")
      ->type_name("N");
  auto* portable = command->add_option("--portable", options->portable,
                                       "A file of portable cases, in place of a scene");
  portable->type_name("FILE");
  for (CLI::Option* of_a_scene : command->get_options()) {
    const std::string& name = of_a_scene->get_single_name();
    const bool is_of_both =
        name == "help" || name == "json" || name == "quiet" || name == "portable";
    if (!is_of_both) portable->excludes(of_a_scene);
  }
  command
      ->add_flag("--drawn-only", options->drawn_only,
                 "With --portable: cases that have no folder are left out")
      ->needs(portable);
  command
      ->add_option("--dump", options->dump,
                   "Folder with those of hits.u16, depth.u32 and color.rgba that there are; with "
                   "--portable it has such a folder for each case, by its name")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--depth-ulp", options->depth_ulp,
                   "Greatest error of a depth, codes; default: 1, of portable cases their file's")
      ->check(CLI::Range(0., 4294967296.))
      ->type_name("E");
  command
      ->add_option("--color-lsb", options->color_lsb,
                   "Greatest error of a colour, of 255; default: 1, of portable cases their file's")
      ->check(CLI::Range(0., 255.))
      ->type_name("E");
  command->add_option("-o,--out", options->out, "The triangles that show the first wrong sample")
      ->type_name("FILE.tri");
  command->callback([options, exit_code] {
    if (options->scene.empty() && options->portable.empty()) {
      throw UsageError("expected a SCENE or --portable FILE");
    }
    try {
      *exit_code = options->portable.empty() ? judge_scene(*options) : judge_portable(*options);
    } catch (const vectors::Refused& error) {
      throw UsageError(error.what());
    }
  });
}

}  // namespace pineda::cli
