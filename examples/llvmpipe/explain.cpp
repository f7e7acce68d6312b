// Explains each sample of a frame of llvmpipe that is not as exact arithmetic has it:
//   explain_llvmpipe SCENE DIR [DEPTH_ULP [COLOR_LSB]]
//
// DIR has what draw_by_llvmpipe wrote of SCENE. A line is printed for each sample whose hits differ, or
// whose depth or colour does by more than DEPTH_ULP codes (1) or COLOR_LSB (1). It counts as explained where
// llvmpipe's arithmetic, redone step by step (arithmetic.h), gives the hits, depth and colour that stand
// there. Exit code 1 where one is not.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "examples/llvmpipe/arithmetic.h"
#include "examples/llvmpipe/exact_triangle.h"
#include "model/judge/visible_frame.h"
#include "model/spec/clear_depth.h"

namespace {

using namespace pineda;
using llvmpipe::Drawable;
using llvmpipe::ExactTriangle;
using Color = std::array<uint8_t, 4>;

/// A sample as llvmpipe's arithmetic or a dump has it, and as it should be.
struct Drawn {
  int hits = 0;
  uint32_t depth = 0;
  Color rgba{};
  int64_t triangle = -1;  // that is seen

  bool operator==(const Drawn& other) const {
    return hits == other.hits && depth == other.depth && rgba == other.rgba;
  }
};
struct Right {
  int hits = 0;
  llvmpipe::Values values;
  int64_t triangle = -1;
};

/// The samples of a file of the dump: each `bytes` long.
std::vector<uint32_t> read(const std::string& path, size_t samples, size_t bytes) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> content(samples * bytes + 1);
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (static_cast<size_t>(file.gcount()) != samples * bytes) {
    throw std::runtime_error(fmt::format("{}: expected {} bytes", path, samples * bytes));
  }
  std::vector<uint32_t> numbers(samples);
  for (size_t i = 0; i < samples * bytes; ++i) {
    numbers[i / bytes] |= static_cast<uint32_t>(static_cast<uint8_t>(content[i]))
                          << (8 * (i % bytes));
  }
  return numbers;
}

class Explanation {
 public:
  Explanation(scene::Scene* scene, const std::string& folder, double depth_ulp, double color_lsb)
      : scene_(scene), frame_(scene->frame), depth_ulp_(depth_ulp), color_lsb_(color_lsb) {
    const size_t samples = static_cast<size_t>(frame_.width) * static_cast<size_t>(frame_.height);
    const auto hits = read(folder + "/hits.u16", samples, 2);
    const auto depth = read(folder + "/depth.u32", samples, 4);
    const auto rgba = read(folder + "/color.rgba", samples, 4);
    const uint32_t clear = spec::depth_code(frame_.clear_depth, 24);
    for (size_t i = 0; i < samples; ++i) {
      dump_.push_back({static_cast<int>(hits[i]), depth[i], {}, -1});
      for (size_t k = 0; k < 4; ++k) dump_[i].rgba[k] = static_cast<uint8_t>(rgba[i] >> (8 * k));
    }
    redone_.resize(samples, {0, clear, {}, -1});
    right_.resize(samples, {0, {static_cast<double>(clear), {}}, -1});
  }

  /// Prints the samples; true if all are explained.
  bool print() {
    const llvmpipe::DenormalsAreZero as_in_mesa;
    for_each([&](int64_t id, const ExactTriangle& exact, const std::vector<Drawable>& pieces) {
      draw(id, exact);
      for (const Drawable& piece : pieces) draw(id, piece);
    });
    size_t wrong_hits = 0, wrong_values = 0, unexplained = 0;
    listed_.resize(dump_.size());
    for (size_t i = 0; i < dump_.size(); ++i) {
      const bool is_wrong_hit = dump_[i].hits != right_[i].hits;
      if (!is_wrong_hit && is_within(i)) continue;
      ++(is_wrong_hit ? wrong_hits : wrong_values);
      unexplained += dump_[i] == redone_[i] ? 0 : 1;
      listed_[i] = true;
    }
    why_.resize(dump_.size());
    for_each([&](int64_t id, const ExactTriangle& exact, const std::vector<Drawable>& pieces) {
      explain(id, exact, pieces);
    });
    for (size_t i = 0; i < dump_.size(); ++i) {
      if (listed_[i]) print_sample(i);
    }
    fmt::print("{} samples: {} with other hits, {} with other depth or colour, {} not explained\n",
               dump_.size(), wrong_hits, wrong_values, unexplained);
    return unexplained == 0;
  }

 private:
  template <class Visit>
  void for_each(Visit&& visit) {
    scene_->source->rewind();
    for (spec::Triangle triangle; scene_->source->next(&triangle);) {
      const ExactTriangle exact(triangle, scene_->source->screen(), frame_);
      std::vector<Drawable> pieces;
      for (const auto& piece :
           llvmpipe::pieces_of(llvmpipe::clip_vertices(*scene_, triangle), frame_)) {
        const Drawable drawable(piece, frame_);
        if (drawable.is_drawn()) pieces.push_back(drawable);
      }
      visit(triangle.id, exact, pieces);
    }
  }
  template <class Triangle, class Visit>
  void for_each_sample(const Triangle& triangle, Visit&& visit) const {
    const auto& [x0, x1, y0, y1] = triangle.box();
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        visit(x, y,
              static_cast<size_t>(y) * static_cast<size_t>(frame_.width) + static_cast<size_t>(x));
      }
    }
  }
  bool writes_depth() const { return frame_.depth_write && frame_.depth != spec::DepthFunc::kOff; }
  template <class Depth>
  bool passes(Depth depth, Depth stored) const {
    return judge::passes(frame_.depth, depth < stored ? -1 : depth > stored ? 1 : 0);
  }

  void draw(int64_t id, const ExactTriangle& triangle) {
    if (!triangle.is_drawn()) return;
    for_each_sample(triangle, [&](int x, int y, size_t i) {
      if (!triangle.covers(x, y)) return;
      Right& sample = right_[i];
      ++sample.hits;
      llvmpipe::Values values = triangle.values(x, y);
      if (!passes(values.depth, sample.values.depth)) return;
      if (!writes_depth()) values.depth = sample.values.depth;
      sample.values = values;
      sample.triangle = id;
    });
  }
  void draw(int64_t id, const Drawable& piece) {
    for_each_sample(piece, [&](int x, int y, size_t i) {
      if (!piece.covers(x, y)) return;
      Drawn& sample = redone_[i];
      ++sample.hits;
      const uint32_t depth = piece.depth(x, y);
      if (!passes(depth, sample.depth)) return;
      if (writes_depth()) sample.depth = depth;
      sample.rgba = piece.color(x, y);
      sample.triangle = id;
    });
  }

  bool is_within(size_t i) const {
    if (std::fabs(dump_[i].depth - right_[i].values.depth) > depth_ulp_) return false;
    for (size_t k = 0; k < 4; ++k) {
      if (std::fabs(dump_[i].rgba[k] - right_[i].values.rgba[k]) > color_lsb_) return false;
    }
    return true;
  }

  // Adds what a triangle has to do with the samples that are listed.
  void explain(int64_t id, const ExactTriangle& exact, const std::vector<Drawable>& pieces) {
    if (!exact.is_drawn()) return;
    for_each_sample(exact, [&](int x, int y, size_t i) {
      if (!listed_[i]) return;
      int hits = 0;
      for (const Drawable& piece : pieces) {
        if (!piece.covers(x, y)) continue;
        ++hits;
        if (redone_[i].triangle == id) why_[i] += value_text(id, piece);
      }
      const int expected = exact.covers(x, y) ? 1 : 0;
      if (hits == expected) return;
      const auto [inside, corner] = exact.inside_px(x, y);
      why_[i] += fmt::format(
          "\n  triangle {}: drawn {} times, expected {}: the sample is {:.6f} px {} of the edge "
          "from corner {}; {} pieces are left after clipping, which have it",
          id, hits, expected, std::fabs(inside), side_of(inside), corner, pieces.size());
      for (const Drawable& piece : pieces) {
        const double distance = piece.inside_px(x, y);
        why_[i] += fmt::format(" {:.6f} px {}", std::fabs(distance), side_of(distance));
      }
    });
  }
  static const char* side_of(double distance) { return distance >= 0 ? "inside" : "outside"; }
  static std::string value_text(int64_t id, const Drawable& piece) {
    constexpr double kCodes = 0xffffff;
    const float origin = piece.z().origin;
    return fmt::format(
        "\n  triangle {}: its depth has {:.0f} and {:.0f} codes a px and starts from {:.0f} at "
        "pixel (0, 0), where binary32 has steps of {:.3g} codes",
        id, double{piece.z().dx} * kCodes, double{piece.z().dy} * kCodes, double{origin} * kCodes,
        double{std::nextafter(std::fabs(origin), HUGE_VALF) - std::fabs(origin)} * kCodes);
  }

  void print_sample(size_t i) const {
    const Drawn& d = dump_[i];
    const Right& r = right_[i];
    const auto& c = r.values.rgba;
    fmt::print(
        "({}, {}){}: hits {}, expected {}; depth {}, expected {:.3f}; colour {} {} {} {}, expected "
        "{:.2f} {:.2f} {:.2f} {:.2f}; triangle {} is seen, expected {}{}\n",
        i % static_cast<size_t>(frame_.width), i / static_cast<size_t>(frame_.width),
        d == redone_[i] ? "" : " NOT EXPLAINED", d.hits, r.hits, d.depth, r.values.depth, d.rgba[0],
        d.rgba[1], d.rgba[2], d.rgba[3], c[0], c[1], c[2], c[3], redone_[i].triangle, r.triangle,
        why_[i]);
  }

  scene::Scene* scene_;
  spec::FrameState frame_;
  double depth_ulp_, color_lsb_;
  std::vector<Drawn> dump_, redone_;
  std::vector<Right> right_;
  std::vector<bool> listed_;
  std::vector<std::string> why_;
};

double tolerance_of(const char* word) {
  char* end = nullptr;
  const double value = std::strtod(word, &end);
  if (end == word || *end != 0 || !(value >= 0)) {
    throw std::runtime_error(fmt::format("expected a tolerance of 0 or more, got '{}'", word));
  }
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) {
    std::fputs("usage: explain_llvmpipe SCENE DIR [DEPTH_ULP [COLOR_LSB]]\n", stderr);
    return 2;
  }
  try {
    const auto contract = spec::contract(*spec::find_design("persp"));
    scene::Options options;
    options.multi_pass = true;
    scene::Scene scene = scene::open_scene(contract, argv[1], options);
    const double depth_ulp = argc > 3 ? tolerance_of(argv[3]) : 1;
    const double color_lsb = argc > 4 ? tolerance_of(argv[4]) : 1;
    return Explanation(&scene, argv[2], depth_ulp, color_lsb).print() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "explain_llvmpipe: %s\n", error.what());
    return 2;
  }
}
