// pineda render: the functional model alone.
#include <memory>
#include <thread>

#include "cli/job.h"
#include "cli/report/pictures.h"
#include "cli/triangles.h"

namespace pineda::cli {
namespace {

struct RenderOptions : Options {
  std::string out;
  std::string dump;
  int bench = 0;
  int threads = 1;
};

/// Draws a frame in bands of tile rows, one thread a band. Every band sets every triangle up again,
/// so that no thread waits for another; bits do not depend on the number of bands.
class BandRenderer {
 public:
  BandRenderer(const spec::Contract& contract, const spec::FrameState& frame, int threads) {
    const int tile = contract.design.tile_log2;
    const int rows = ((frame.height - 1) >> tile) + 1;
    const int bands = std::min(threads, rows);
    for (int i = 0; i < bands; ++i) {
      const core::TileRows band{rows * i / bands, rows * (i + 1) / bands - 1};
      bands_.push_back(std::make_unique<core::Renderer>(contract, frame, band));
    }
  }

  void clear() {
    for_each_band([](core::Renderer* band) { band->clear(); });
  }
  void draw(const std::vector<spec::Triangle>& triangles) {
    for_each_band([&triangles](core::Renderer* band) {
      for (const auto& triangle : triangles) band->draw(triangle);
    });
  }

  core::FrameCounters counters() const {
    core::FrameCounters sum = bands_[0]->counters();  // each band sets up every triangle
    for (size_t i = 1; i < bands_.size(); ++i) {
      for (const core::FrameCounter& row : core::kFrameCounters) {
        const bool of_triangles = row.is_drop() || row.member == &core::FrameCounters::triangles;
        if (!of_triangles) row.of(sum) += row.of(bands_[i]->counters());
      }
    }
    return sum;
  }

  core::FrameBuffer buffer() const {
    core::FrameBuffer frame(bands_[0]->contract(), bands_[0]->frame());
    for (const auto& band : bands_) band->copy_rows(&frame);
    return frame;
  }

 private:
  template <class Work>
  void for_each_band(Work work) {
    std::vector<std::thread> others;
    for (size_t i = 1; i < bands_.size(); ++i) others.emplace_back(work, bands_[i].get());
    work(bands_[0].get());
    for (auto& thread : others) thread.join();
  }

  std::vector<std::unique_ptr<core::Renderer>> bands_;
};

double draw_once(const scene::Scene& scene, Progress* progress, BandRenderer* renderer) {
  ChunkedTriangles triangles(scene.source.get(), progress, "drawing");
  double seconds = 0;
  for (auto* chunk = &triangles.next_chunk(); !chunk->empty(); chunk = &triangles.next_chunk()) {
    seconds += seconds_of([&] { renderer->draw(*chunk); });
  }
  return seconds;
}

double draw_repeatedly(const scene::Scene& scene, int runs, Progress* progress,
                       BandRenderer* renderer) {
  const auto triangles = load_all(scene.source.get(), progress);
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    seconds.push_back(seconds_of([&] {
      renderer->clear();
      renderer->draw(triangles);
    }));
  }
  return median(seconds);
}

int run(const RenderOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Job job = open_job(options, lacks_nothing, false, output, &progress);
  const spec::Contract& contract = job.contract;
  const scene::Scene& scene = job.scene;
  BandRenderer renderer(contract, scene.frame, options.threads);
  const double seconds = options.bench > 0
                             ? draw_repeatedly(scene, options.bench, &progress, &renderer)
                             : draw_once(scene, &progress, &renderer);
  progress.clear();
  print_notes(output, job);

  const scene::Frame frame = picture_of(contract, renderer.buffer());
  if (!options.out.empty()) write_pictures(options.out, frame);
  if (!options.dump.empty()) scene::write_dump(options.dump, frame);

  const core::FrameCounters counters = renderer.counters();
  Json json = header_json(scene, contract);
  json["seconds"] = seconds;
  json["triangles"] = scene.source->counters().triangles;
  json["threads"] = options.threads;
  json["input"] = input_json(scene.source->counters());
  json["counters"] = counters_json(counters);
  output.line("{}: {}x{}, {}", scene.name, scene.frame.width, scene.frame.height,
              contract.design.name);
  print_state(output, scene);
  print_counters(output, counters);
  output.row("seconds",
             fmt::format("{:.6f}{}", seconds,
                         options.bench > 1 ? fmt::format(" (median of {})", options.bench)
                                           : std::string()));
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
  command->add_option("-o,--out", options->out, "Folder for color.png and depth.png")
      ->type_name("DIR");
  command->add_option("--dump", options->dump, "Folder for hits.u16, depth.u32 and color.rgba")
      ->type_name("DIR");
  command->add_option("--bench", options->bench, "Median seconds of N renders in memory")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  command->add_option("--threads", options->threads, "Bands of tile rows drawn side by side")
      ->check(CLI::Range(1, 256))
      ->type_name("T")
      ->capture_default_str();
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
