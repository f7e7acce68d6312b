#include "tests/cli/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

#include "model/exact/exact.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

constexpr int kSubpixelBits = 8;
constexpr int kGuardBits = 14;
constexpr int kDepthBits = 24;

exact::Judge judge_of(const Scene& scene, const Triangle& triangle) {
  exact::Triangle snapped;
  for (size_t i = 0; i < 3; ++i) {
    const Vertex& v = triangle[i];
    bool ignored = false;
    snapped[i] = {exact::snap(v.x, kSubpixelBits, kGuardBits, &ignored),
                  exact::snap(v.y, kSubpixelBits, kGuardBits, &ignored),
                  exact::depth_input(v.z, kDepthBits, &ignored),
                  {v.rgba.begin(), v.rgba.end()}};
  }
  return exact::Judge(snapped, kSubpixelBits, scene.width, scene.height,
                      static_cast<exact::Cull>(scene.cull));
}

/// Calls visit(x, y) for each sample that the triangle covers.
template <class Visit>
void for_each_sample(const exact::Judge& judge, Visit visit) {
  const exact::Span rows = judge.rows();
  for (int y = rows.first; y <= rows.last; ++y) {
    const exact::Span row = judge.span(y);
    for (int x = row.first; x <= row.last; ++x) visit(x, y);
  }
}

bool color_fits(const exact::Judge& judge, int x, int y, const std::array<uint8_t, 4>& color) {
  for (int channel = 0; channel < 4; ++channel) {
    const int value = color[static_cast<size_t>(channel)];
    if (std::abs(judge.attribute_error(x, y, channel, value)) > kColorBoundLsb) return false;
  }
  return true;
}

/// What the judge knows of one sample.
struct Sample {
  int hits = 0;
  double nearest = kClearedDepth;  // least exact depth of the triangles here
  bool color_fits = false;
};

using Samples = std::vector<Sample>;

/// Hits and the least depth, triangle by triangle.
Samples judge_depths(const Scene& scene, const Dump& dump) {
  Samples samples(dump.depth.size());
  for (const Triangle& triangle : scene.triangles) {
    const exact::Judge judge = judge_of(scene, triangle);
    for_each_sample(judge, [&](int x, int y) {
      Sample& sample = samples[dump.index(x, y)];
      ++sample.hits;
      sample.nearest = std::min(sample.nearest, -judge.depth_error(x, y, 0));
    });
  }
  return samples;
}

/// Marks the samples whose colour is that of some triangle that may be in front: of two depths
/// within twice the bound either may win. Without a depth test only the last triangle counts.
void judge_colors(const Scene& scene, const Dump& dump, Samples* samples) {
  for (const Triangle& triangle : scene.triangles) {
    const exact::Judge judge = judge_of(scene, triangle);
    for_each_sample(judge, [&](int x, int y) {
      const size_t at = dump.index(x, y);
      Sample& sample = (*samples)[at];
      if (scene.depth == Depth::kOff) {
        sample.color_fits = color_fits(judge, x, y, dump.color[at]);
      } else if (-judge.depth_error(x, y, 0) <= sample.nearest + 2 * kDepthBoundUlp) {
        sample.color_fits = sample.color_fits || color_fits(judge, x, y, dump.color[at]);
      }
    });
  }
}

template <class Word>
std::vector<Word> words_of(const std::string& path, size_t count) {
  const std::string bytes = read_bytes(path);
  EXPECT_EQ(bytes.size(), count * sizeof(Word)) << path;
  std::vector<Word> words(count);
  for (size_t i = 0; i < std::min(bytes.size(), count * sizeof(Word)); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    words[i / sizeof(Word)] |= static_cast<Word>(Word{byte} << 8 * (i % sizeof(Word)));
  }
  return words;
}

}  // namespace

uint64_t Dump::covered() const { return std::accumulate(hits.begin(), hits.end(), uint64_t{0}); }

Dump read_dump(const std::string& folder, const Scene& scene) {
  Dump dump;
  dump.width = scene.width;
  dump.height = scene.height;
  const auto count = static_cast<size_t>(scene.width) * static_cast<size_t>(scene.height);
  dump.hits = words_of<uint16_t>(folder + "/hits.u16", count);
  dump.depth = words_of<uint32_t>(folder + "/depth.u32", count);
  const auto bytes = words_of<uint8_t>(folder + "/color.rgba", count * 4);
  dump.color.resize(count);
  for (size_t i = 0; i < count; ++i) std::copy_n(&bytes[4 * i], 4, dump.color[i].begin());
  return dump;
}

std::ostream& operator<<(std::ostream& to, const Verdict& v) {
  return to << v.wrong_hits << " wrong hits, " << v.wrong_depths << " wrong depths, "
            << v.wrong_colors << " wrong colours, " << v.covered << " covered; depth error at most "
            << v.max_depth_ulp << " ulp";
}

Verdict judge(const Scene& scene, const Dump& dump) {
  Samples samples = judge_depths(scene, dump);
  judge_colors(scene, dump, &samples);
  Verdict verdict;
  for (size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    verdict.covered += static_cast<uint64_t>(sample.hits);
    verdict.wrong_hits += sample.hits != dump.hits[i] ? 1 : 0;
    const bool is_cleared = sample.hits == 0 || scene.depth == Depth::kOff;
    const double error = dump.depth[i] - (is_cleared ? kClearedDepth : sample.nearest);
    verdict.max_depth_ulp = std::max(verdict.max_depth_ulp, std::abs(error));
    verdict.wrong_depths += std::abs(error) > (is_cleared ? 0 : kDepthBoundUlp) ? 1 : 0;
    // LESS draws nothing at the depth that the frame is cleared to.
    const bool may_be_clear =
        sample.hits == 0 || (scene.depth == Depth::kLess && dump.depth[i] == kClearedDepth);
    const bool is_clear = dump.color[i] == std::array<uint8_t, 4>{};
    verdict.wrong_colors += sample.color_fits || (may_be_clear && is_clear) ? 0 : 1;
  }
  return verdict;
}

uint64_t saturated_coordinates(const Scene& scene) {
  uint64_t count = 0;
  for (const Triangle& t : scene.triangles) {
    for (const Vertex& v : t) {
      for (const float value : {v.x, v.y}) {
        bool saturated = false;
        exact::snap(value, kSubpixelBits, kGuardBits, &saturated);
        count += saturated ? 1 : 0;
      }
    }
  }
  return count;
}

}  // namespace pineda::test
