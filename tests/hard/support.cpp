#include "tests/hard/support.h"

#include <memory>
#include <stdexcept>

#include "model/scene/snap.h"

namespace pineda::hard {

namespace {

const spec::Contract kContract = spec::contract(spec::kHighTile);

}  // namespace

const scene::HardCase& hard_case(const std::string& name) {
  const scene::HardCase* found = scene::find_hard_case(name);
  if (found == nullptr) throw std::invalid_argument("no hard case " + name);
  return *found;
}

Snapped snapped(const scene::HardCase& hard_case, const spec::Contract& contract) {
  scene::SnappedSource source(contract, std::make_unique<scene::ListReader>(hard_case.make()));
  Snapped scene{hard_case.frame, {}, {}};
  for (spec::Triangle t; source.next(&t);) scene.triangles.push_back(t);
  scene.counters = source.counters();
  return scene;
}

Snapped snapped(const std::string& name) { return snapped(hard_case(name), kContract); }

std::vector<uint16_t> judged_hits(const spec::Contract& contract, const Snapped& scene) {
  const auto width = static_cast<size_t>(scene.frame.width);
  std::vector<uint16_t> hits(width * static_cast<size_t>(scene.frame.height));
  for (const auto& t : scene.triangles) {
    const exact::Judge exact = judge(contract, scene.frame, t);
    if (exact.culled()) continue;
    for (int y = exact.rows().first; y <= exact.rows().last; ++y) {
      const exact::Span span = exact.span(y);
      for (int x = span.first; x <= span.last; ++x) {
        ++hits[static_cast<size_t>(y) * width + static_cast<size_t>(x)];
      }
    }
  }
  return hits;
}

core::Renderer drawn(const Snapped& scene) { return drawn(scene, 0, scene.triangles.size()); }

core::Renderer drawn(const Snapped& scene, size_t first, size_t count) {
  core::Renderer renderer(kContract, scene.frame);
  for (size_t i = first; i < first + count; ++i) renderer.draw(scene.triangles.at(i));
  return renderer;
}

}  // namespace pineda::hard
