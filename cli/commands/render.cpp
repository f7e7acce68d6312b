// pineda render: the functional model alone.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/job.h"
#include "cli/report/pictures.h"
#include "cli/simd_option.h"
#include "cli/triangles.h"
#include "model/fast/band_renderer.h"

namespace pineda::cli {
namespace {

struct RenderOptions : Options {
  std::string out;
  std::string dump;
  int bench = 0;
  int threads = 1;
};

// As ChunkedTriangles, in the form in which they are drawn: what reads them packs them, too.
class TriangleLists {
 public:
  TriangleLists(const spec::Contract& contract, const scene::Scene& scene)
      : source_(scene.source.get()), own_(contract, scene.frame) {
    if (is_read_ahead(*source_, kRing * kSize)) {
      ahead_.emplace(
          kRing, [this](fast::TriangleList* list) { return read(list); }, own_);
    }
  }

  /// The next list; null at the end of the scene.
  const fast::TriangleList* next() {
    if (ahead_) return ahead_->next();
    return read(&own_) ? &own_ : nullptr;
  }

 private:
  static constexpr size_t kSize = 2048;  // 98 KB: they stay in a processor's own cache
  static constexpr size_t kRing = 3;

  // False at the end.
  bool read(fast::TriangleList* list) {
    triangles_.resize(kSize);
    const size_t count = source_->next_many(triangles_.data(), kSize);
    list->clear();
    for (size_t i = 0; i < count; ++i) list->push_back(triangles_[i]);
    return count > 0;
  }

  scene::SnappedSource* source_;
  fast::TriangleList own_;
  std::vector<spec::Triangle> triangles_;  // of the list that is read
  std::optional<scene::ReadAhead<fast::TriangleList>> ahead_;
};

FrameSeconds draw_once(const scene::Scene& scene, const spec::Contract& contract,
                       Progress* progress, fast::BandRenderer* renderer) {
  FrameSeconds seconds;
  seconds.stream = seconds_of([&] {
    TriangleLists lists(contract, scene);
    uint64_t drawn = 0;
    for (auto* list = lists.next(); list != nullptr; list = lists.next()) {
      seconds.drawing += seconds_of([&] { renderer->draw(*list); });
      drawn += list->size();
      progress->update("drawing", drawn);
    }
  });
  return seconds;
}

FrameSeconds draw_repeatedly(const scene::Scene& scene, const spec::Contract& contract, int runs,
                             Progress* progress, fast::BandRenderer* renderer) {
  fast::TriangleList triangles(contract, scene.frame);
  ChunkedTriangles source(scene.source.get(), progress, "loading");
  for (spec::Triangle triangle; source.next(&triangle);) triangles.push_back(triangle);
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    seconds.push_back(seconds_of([&] {
      renderer->clear();
      renderer->draw(triangles);
    }));
  }
  return {median(seconds), std::nullopt};
}

// A frame that nobody looks at takes no memory a second time.
void write_frame(const RenderOptions& options, const spec::Contract& contract,
                 const fast::BandRenderer& renderer) {
  if (options.out.empty() && options.dump.empty()) return;
  const scene::Frame frame = picture_of(contract, renderer.buffer());
  if (!options.out.empty()) write_pictures(options.out, frame);
  if (!options.dump.empty()) scene::write_dump(options.dump, frame);
}

int run(const RenderOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Job job = open_job(options, lacks_nothing, false, output, &progress);
  const spec::Contract& contract = job.contract;
  const scene::Scene& scene = job.scene;
  using Hits = fast::Renderer::Hits;
  fast::BandRenderer renderer(contract, scene.frame, options.threads,
                              options.dump.empty() ? Hits::kUncounted : Hits::kCounted);
  const FrameSeconds seconds =
      options.bench > 0 ? draw_repeatedly(scene, contract, options.bench, &progress, &renderer)
                        : draw_once(scene, contract, &progress, &renderer);
  progress.clear();
  print_notes(output, job);

  write_frame(options, contract, renderer);
  const core::FrameCounters counters = renderer.counters();
  Json json = header_json(scene, contract);
  json["seconds"] = seconds.drawing;
  json["triangles"] = scene.source->counters().triangles;
  json["threads"] = options.threads;
  json["input"] = input_json(scene.source->counters());
  json["counters"] = counters_json(counters);
  output.line("{}: {}x{}, {}", scene.name, scene.frame.width, scene.frame.height,
              contract.design.name);
  print_state(output, scene);
  print_counters(output, counters);
  output.row("seconds",
             fmt::format("{:.6f}{}", seconds.drawing,
                         options.bench > 1 ? fmt::format(" (median of {})", options.bench)
                                           : std::string()));
  report_stream(scene, seconds, output, &json);
  if (!options.out.empty()) output.row("pictures", options.out + "/color.png, depth.png");
  if (!options.dump.empty()) {
    output.row("dump", options.dump + "/hits.u16, depth.u32, color.rgba");
  }
  output.json(json);
  return kHolds;
}

}  // namespace

void add_render(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<RenderOptions>();
  auto* command = program->add_subcommand("render", "The functional model alone: pictures, dumps");
  add_scene_options(command, options.get());
  allow_auto(command);
  add_simd_option(command);
  command->add_option("-o,--out", options->out, "Folder for color.png and depth.png")
      ->type_name("DIR");
  command->add_option("--dump", options->dump, "Folder for hits.u16, depth.u32 and color.rgba")
      ->type_name("DIR");
  command->add_option("--bench", options->bench, "Median seconds of N renders in memory")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  command
      ->add_option("--threads", options->threads,
                   "Threads that draw; the frame is the same with any number")
      ->check(CLI::Range(1, 256))
      ->type_name("T")
      ->capture_default_str();
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
