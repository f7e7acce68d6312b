#include "vectors/generator/scenes.h"

#include <algorithm>

#include "model/spec/package.h"
#include "vectors/generator/draw.h"

namespace pineda::vectors {

using spec::Vertex;

int64_t Draw::far() const {
  return ((int64_t{1} << contract_.design.depth_bits) - 1) << spec::kDepthInputFractionBits;
}

Vertex Draw::vertex(Point p) {
  Vertex v;
  v.x = static_cast<int32_t>(p.x);
  v.y = static_cast<int32_t>(p.y);
  v.z = random().between(0, far());
  for (int i = 0; i < spec::channels(contract_.design); ++i) {
    v.attr[static_cast<size_t>(i)] = static_cast<int32_t>(random().between(0, full()));
  }
  if (!contract_.design.perspective) return v;
  const int32_t half = 1 << (contract_.design.inverse_w_bits - 1);
  v.inverse_w = static_cast<int32_t>(random().between(half, 2 * int64_t{half} - 1));
  const int64_t kind = random().between(0, 7);
  v.inverse_w_shift = static_cast<int32_t>(kind == 0   ? random().between(0, 253)
                                           : kind <= 3 ? 0
                                                       : random().between(0, 20));
  return v;
}

void Draw::add_shuffled(std::array<Vertex, 3> v) {
  std::rotate(v.begin(), v.begin() + random().between(0, 2), v.end());
  if (random().coin()) std::swap(v[1], v[2]);
  add_ordered(v);
}

void Draw::add_ordered(const std::array<Vertex, 3>& v) {
  scene_.triangles.push_back({static_cast<uint32_t>(scene_.triangles.size()), v});
  auto& added = scene_.triangles.back().v;  // the greatest 1/w has shift 0
  const int32_t least =
      std::min({added[0].inverse_w_shift, added[1].inverse_w_shift, added[2].inverse_w_shift});
  for (Vertex& vertex : added) vertex.inverse_w_shift -= least;
}

namespace {

// Every other scene has its ports stall, and every eighth frame is reset on the way.
void disturb(spec::Random* random, int index, Scene* scene) {
  if (index % 2 == 1) {
    constexpr memory::StallMode kModes[] = {memory::StallMode::kSource, memory::StallMode::kSink,
                                            memory::StallMode::kBoth};
    scene->ports.mode = kModes[random->between(0, 2)];
    scene->ports.seed = random->bits();
  }
  if (index % 8 == 5) scene->reset_cycle = static_cast<uint64_t>(random->between(1, 200));
}

Scene drawn(const spec::Contract& contract, const SceneClass& kind, uint64_t seed, int index) {
  spec::Random mix(seed ^ spec::text_hash(kind.name));
  spec::Random scene_seed(mix.bits() + static_cast<uint64_t>(index));
  Draw draw(contract, scene_seed.bits(), index);
  kind.draw(draw);
  Scene& scene = draw.scene();
  scene.name = std::string(kind.name) + "." + std::to_string(index);
  disturb(&scene_seed, index, &scene);
  return scene;
}

int scenes_of(const SceneClass& kind, int level) {
  return level == 1 ? kind.scenes : 8 * kind.scenes;
}

}  // namespace

void for_each_scene(const spec::Contract& contract, int level, uint64_t seed,
                    const std::function<bool(const Scene&)>& visit) {
  for (const auto& classes :
       {coverage_classes(), value_classes(), state_classes(), bit_classes(), random_classes()}) {
    for (const SceneClass& kind : classes) {
      for (int i = 0; i < scenes_of(kind, level); ++i) {
        if (!visit(drawn(contract, kind, seed, i))) return;
      }
    }
  }
}

void for_each_further_scene(const spec::Contract& contract, uint64_t seed,
                            const std::function<bool(const Scene&)>& visit) {
  const std::vector<SceneClass> classes = any_classes();
  for (int i = 0;; ++i) {
    // A crowd is eight times as large.
    const SceneClass& kind = classes[i % 8 == 7 ? 1 : 0];
    if (!visit(drawn(contract, kind, seed, i))) return;
  }
}

std::vector<Scene> scenes(const spec::Contract& contract, int level, uint64_t seed) {
  std::vector<Scene> all;
  for_each_scene(contract, level, seed, [&](const Scene& scene) {
    all.push_back(scene);
    return true;
  });
  return all;
}

}  // namespace pineda::vectors
