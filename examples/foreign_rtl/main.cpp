// Draws a scene with the RTL of box_scan.sv and writes the frame for pineda judge:
//   draw_by_box_scan BUG SCENE DIR
//
// BUG: 0 none; 1 samples on any edge are drawn; 2 a box lacks its last column; 3 the other faces are
// culled; 4 the scissor has no lower border; 5 equal depths pass; 6 every depth passes; 7 depths lack
// their low four bits; 8 red and blue are swapped.
#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "Vbox_scan.h"
#include "model/judge/visible_frame.h"
#include "model/scene/scene.h"
#include "model/scene/writers.h"
#include "model/spec/clear_depth.h"

namespace {

using namespace pineda;

constexpr int kBugs = 8;
constexpr size_t kSamples = 1 << 16;

/// The RTL and the frame that it has written.
class Bench {
 public:
  Bench(const spec::FrameState& frame, int bug) {
    picture_.width = frame.width;
    picture_.height = frame.height;
    picture_.clear_depth = spec::depth_code(frame.clear_depth, 24);
    const size_t samples = static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
    if (samples > kSamples) throw std::runtime_error("expected a frame of 65536 samples at most");
    picture_.hits.resize(samples);
    picture_.depth.resize(samples, picture_.clear_depth);
    picture_.color.resize(4 * samples);
    top_.bug_i = static_cast<uint8_t>(bug);
    top_.width_i = static_cast<uint16_t>(frame.width);
    top_.height_i = static_cast<uint16_t>(frame.height);
    top_.cull_i = static_cast<uint8_t>(frame.cull);
    for (int order = -1; order <= 1; ++order) {
      if (judge::passes(frame.depth, order)) top_.pass_i |= static_cast<uint8_t>(1 << (order + 1));
    }
    top_.write_i = frame.depth_write && frame.depth != spec::DepthFunc::kOff;
    const std::array<int, 4> scissor{frame.scissor_x0, frame.scissor_y0, frame.scissor_x1,
                                     frame.scissor_y1};
    for (size_t i = 0; i < 4; ++i) top_.scissor_i[i] = static_cast<uint32_t>(scissor[i]);
    clock();
    top_.rst_ni = 1;
    top_.clear_i = 1;
    top_.clear_depth_i = picture_.clear_depth;
    for (size_t i = 0; i < samples; ++i) {
      top_.clear_address_i = static_cast<uint16_t>(i);
      clock();
    }
    top_.clear_i = 0;
  }

  void draw(const spec::Triangle& triangle) {
    for (size_t i = 0; i < 3; ++i) {
      const spec::Vertex& v = triangle.v[i];
      top_.x_i[i] = static_cast<uint32_t>(v.x);
      top_.y_i[i] = static_cast<uint32_t>(v.y);
      top_.z_i[i] = static_cast<uint32_t>(v.z);
      top_.rgba_i[i] = 0;
      for (size_t k = 0; k < 4; ++k) top_.rgba_i[i] |= static_cast<uint32_t>(v.attr[k]) << (8 * k);
    }
    top_.tri_valid_i = 1;
    clock();
    top_.tri_valid_i = 0;
    while (top_.tri_ready_o == 0) {
      take();
      clock();
    }
  }

  const scene::Frame& picture() const { return picture_; }

 private:
  void clock() {
    top_.clk_i = 0;
    top_.eval();
    top_.clk_i = 1;
    top_.eval();
    top_.clk_i = 0;
    top_.eval();
  }
  void take() {
    if (top_.hit_o == 0) return;
    const size_t at = top_.address_o;
    ++picture_.hits[at];
    if (top_.drawn_o == 0) return;
    picture_.depth[at] = top_.depth_o;
    for (size_t k = 0; k < 4; ++k) {
      picture_.color[4 * at + k] = static_cast<uint16_t>(top_.rgba_o >> (8 * k) & 0xff);
    }
  }

  Vbox_scan top_;
  scene::Frame picture_;
};

}  // namespace

int main(int argc, char** argv) {
  const int bug = argc == 4 ? std::atoi(argv[1]) : -1;
  if (bug < 0 || bug > kBugs) {
    fmt::print(stderr, "usage: draw_by_box_scan BUG SCENE DIR, BUG from 0 (none) to {}\n", kBugs);
    return 2;
  }
  try {
    const auto contract = spec::contract(*spec::find_design("high_tile"));
    const scene::Scene scene = scene::open_scene(contract, argv[2], {});
    Bench bench(scene.frame, bug);
    for (spec::Triangle triangle; scene.source->next(&triangle);) bench.draw(triangle);
    scene::write_dump(argv[3], bench.picture());
  } catch (const std::exception& error) {
    fmt::print(stderr, "draw_by_box_scan: {}\n", error.what());
    return 2;
  }
  return 0;
}
