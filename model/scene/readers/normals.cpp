#include "model/scene/readers/normals.h"

namespace pineda::scene {

std::vector<Vec3> mean_normals(const std::vector<Vec3>& position,
                               const std::vector<std::array<uint32_t, 3>>& triangle) {
  std::vector<Vec3> sum(position.size());
  for (const auto& v : triangle) {
    const Vec3 n = cross(position[v[1]] - position[v[0]], position[v[2]] - position[v[0]]);
    if (!is_finite(n)) continue;
    for (const size_t k : v) sum[k] = sum[k] + n;
  }
  for (Vec3& n : sum) n = normalized(n);
  return sum;
}

uint64_t mend_normals(const std::vector<Vec3>& position,
                      const std::vector<std::array<uint32_t, 3>>& triangle,
                      std::vector<Vec3>* normal) {
  std::vector<bool> is_bad(normal->size());
  bool has_bad = false;
  for (size_t i = 0; i < normal->size(); ++i) {
    is_bad[i] = !is_direction((*normal)[i]);
    has_bad = has_bad || is_bad[i];
    (*normal)[i] = normalized((*normal)[i]);
  }
  if (!has_bad) return 0;
  const auto mean = mean_normals(position, triangle);
  std::vector<bool> is_used(normal->size());
  for (const auto& t : triangle) {
    for (const uint32_t vertex : t) is_used[vertex] = true;
  }
  uint64_t mended = 0;
  for (size_t i = 0; i < normal->size(); ++i) {
    if (!is_bad[i]) continue;
    (*normal)[i] = mean[i];
    mended += is_used[i] ? 1 : 0;
  }
  return mended;
}

}  // namespace pineda::scene
