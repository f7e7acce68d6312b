// A rasterizer of one's own, judged in memory: barycentric, in floats, with the fill rule that its line
// in covers() has. Exact arithmetic says which samples are wrong, and why.
#include <pineda/golden.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

void must(pineda_status status) {
  if (status != PINEDA_OK) throw std::runtime_error(pineda_last_error());
}

struct Frame {
  explicit Frame(int width_px, int height_px)
      : width(width_px),
        height(height_px),
        hits(static_cast<size_t>(width * height)),
        depth(hits.size(), 0xffffff),
        rgba(4 * hits.size()) {}

  int width, height;
  std::vector<uint16_t> hits;
  std::vector<uint32_t> depth;
  std::vector<uint8_t> rgba;
};

// Twice the area of p, q and the sample; above 0 where it lies to the right of pq, on screen.
double edge(const pineda_screen_vertex& p, const pineda_screen_vertex& q, double x, double y) {
  return (double{q.x} - p.x) * (y - p.y) - (double{q.y} - p.y) * (x - p.x);
}

bool covers(double e, const pineda_screen_vertex& p, const pineda_screen_vertex& q,
            bool inclusive) {
  if (e != 0) return e > 0;
  const bool top_left = q.y < p.y || (q.y == p.y && q.x > p.x);
  return inclusive || top_left;  // a sample on an edge belongs to one of its two triangles
}

void draw(pineda_screen_triangle t, bool inclusive, Frame* frame) {
  double area = edge(t.v[0], t.v[1], t.v[2].x, t.v[2].y);
  if (area == 0) return;
  if (area < 0) {
    std::swap(t.v[1], t.v[2]);
    area = -area;
  }
  for (int y = 0; y < frame->height; ++y) {
    for (int x = 0; x < frame->width; ++x) {
      std::array<double, 3> weight{};
      bool inside = true;
      for (size_t i = 0; i < 3; ++i) {
        const auto& p = t.v[(i + 1) % 3];
        const auto& q = t.v[(i + 2) % 3];
        weight[i] = edge(p, q, x + .5, y + .5);
        inside = inside && covers(weight[i], p, q, inclusive);
      }
      if (!inside) continue;
      const auto sample = static_cast<size_t>(y * frame->width + x);
      ++frame->hits[sample];
      const auto value = [&](auto of) {
        return (weight[0] * of(t.v[0]) + weight[1] * of(t.v[1]) + weight[2] * of(t.v[2])) / area;
      };
      const auto z = static_cast<uint32_t>(
          std::floor(value([](const auto& v) { return double{v.z}; }) * 0xffffff + .5));
      if (z >= frame->depth[sample]) continue;
      frame->depth[sample] = z;
      for (size_t c = 0; c < 4; ++c) {
        frame->rgba[4 * sample + c] =
            static_cast<uint8_t>(value([c](const auto& v) { return double{v.rgba[c]}; }) + .5);
      }
    }
  }
}

// A square of two triangles on whole pixels, whose diagonal runs through samples, and some others.
std::vector<pineda_screen_triangle> scene() {
  std::mt19937 random(1);
  const auto vertex = [&](int x, int y, float z) {
    const auto byte = [&] { return static_cast<uint8_t>(random()); };
    return pineda_screen_vertex{
        static_cast<float>(x), static_cast<float>(y), z, 1, {byte(), byte(), byte(), 255}};
  };
  std::vector<pineda_screen_triangle> all{
      {0, {vertex(0, 0, .5f), vertex(0, 64, .5f), vertex(64, 64, .5f)}},
      {1, {vertex(0, 0, .5f), vertex(64, 64, .5f), vertex(64, 0, .5f)}}};
  const auto px = [&] { return static_cast<int>(random() % 96); };
  for (uint32_t id = 2; id < 20; ++id) {
    const float z = static_cast<float>(id) / 64;
    all.push_back({id, {vertex(px(), px(), z), vertex(px(), px(), z), vertex(px(), px(), z)}});
  }
  return all;
}

// The samples that are wrong.
uint64_t judged(bool inclusive) {
  const auto triangles = scene();
  Frame drawn(96, 96);
  for (const auto& triangle : triangles) draw(triangle, inclusive, &drawn);
  const pineda_frame frame = pineda_default_frame(drawn.width, drawn.height);
  const pineda_tolerance tolerance = pineda_default_tolerance();
  const pineda_dump dump{drawn.hits.data(), drawn.depth.data(), drawn.rgba.data(),
                         drawn.hits.size()};
  pineda_verdict verdict{};
  must(pineda_judge(&frame, &tolerance, triangles.data(), triangles.size(), &dump, &verdict,
                    nullptr));
  std::printf("%-16s %llu samples wrong", inclusive ? "inclusive edges" : "top-left rule",
              static_cast<unsigned long long>(verdict.samples_wrong));
  if (verdict.samples_wrong > 0) {
    std::printf("; (%d, %d), triangle %lld: %s", verdict.x, verdict.y,
                static_cast<long long>(verdict.triangle), verdict.what);
  }
  std::printf("\n");
  return verdict.samples_wrong;
}

}  // namespace

int main() {
  try {
    return judged(false) == 0 && judged(true) > 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
