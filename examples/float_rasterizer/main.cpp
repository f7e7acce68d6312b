// Draws a scene with a textbook rasterizer in floats, and writes the frame for pineda judge:
//   draw_in_floats ALGORITHM SCENE DIR
#include <cstdio>
#include <exception>

#include "model/baseline/baseline.h"
#include "model/judge/visible_frame.h"
#include "model/scene/scene.h"
#include "model/scene/writers.h"
#include "model/spec/clear_depth.h"

namespace {

using namespace pineda;

/// Counts and depth-tests what the algorithm draws.
class Frame final : public baseline::Sink {
 public:
  Frame(const spec::Design& design, const spec::FrameState& frame)
      : frame_(frame), visible_(design, frame), hits_(visible_.size()) {}

  void sample(const baseline::Sample& s) override {
    ++hits_[static_cast<size_t>(s.y) * static_cast<size_t>(frame_.width) +
            static_cast<size_t>(s.x)];
    visible_.write(s.x, s.y, s.z, s.rgba);
  }

  scene::Frame finished(const spec::Design& design) const {
    scene::Frame frame;
    frame.width = frame_.width;
    frame.height = frame_.height;
    frame.clear_depth = spec::depth_code(frame_.clear_depth, design.depth_bits);
    frame.hits = hits_;
    for (size_t i = 0; i < visible_.size(); ++i) {
      frame.depth.push_back(static_cast<uint32_t>(visible_.z(i)));
      frame.color.insert(frame.color.end(), visible_.rgba(i).begin(), visible_.rgba(i).end());
    }
    return frame;
  }

 private:
  spec::FrameState frame_;
  judge::VisibleFrame visible_;
  std::vector<uint16_t> hits_;
};

int draw(const std::string& name, const std::string& scene_name, const std::string& folder) {
  const spec::Contract contract = spec::contract(*spec::find_design("high_tile"));
  for (const baseline::Baseline& algorithm : baseline::baselines()) {
    if (name != algorithm.name) continue;
    const scene::Scene scene = scene::open_scene(contract, scene_name, {});
    Frame frame(contract.design, scene.frame);
    const auto rasterizer = algorithm.make(contract, scene.frame);
    for (spec::Triangle triangle; scene.source->next(&triangle);) {
      rasterizer->draw(triangle, &frame);
    }
    scene::write_dump(folder, frame.finished(contract.design));
    return 0;
  }
  std::fputs("draw_in_floats: expected one of", stderr);
  for (const baseline::Baseline& algorithm : baseline::baselines()) {
    std::fprintf(stderr, " %s", algorithm.name);
  }
  std::fputs("\n", stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: draw_in_floats ALGORITHM SCENE DIR\n", stderr);
    return 2;
  }
  try {
    return draw(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_in_floats: %s\n", error.what());
    return 2;
  }
}
