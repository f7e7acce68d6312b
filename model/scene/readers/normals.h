// Computes normals for meshes that lack them.
#pragma once

#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// For each position the area-weighted mean of the normals of its triangles, with unit length; zero
/// where no triangle has a normal.
std::vector<Vec3> mean_normals(const std::vector<Vec3>& position,
                               const std::vector<std::array<uint32_t, 3>>& triangle);

/// Normalizes the normals, one for each position; those that are no directions (zero or not finite)
/// are replaced by mean_normals().
///
/// Out      the number of replaced normals that triangles use.
uint64_t mend_normals(const std::vector<Vec3>& position,
                      const std::vector<std::array<uint32_t, 3>>& triangle,
                      std::vector<Vec3>* normal);

}  // namespace pineda::scene
