#include "model/scene/normals.h"

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

}  // namespace pineda::scene
