// Normals for meshes that come without.
#pragma once

#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// Per position: the mean of the normals of the faces around it, weighted by their areas; of unit
/// length, or zero where no face has one.
std::vector<Vec3> mean_normals(const std::vector<Vec3>& position,
                               const std::vector<std::array<uint32_t, 3>>& triangle);

/// Makes the normals, one a position, of unit length; those that are no directions become the mean.
///
/// Out      how many of those the triangles use.
uint64_t mend_normals(const std::vector<Vec3>& position,
                      const std::vector<std::array<uint32_t, 3>>& triangle,
                      std::vector<Vec3>* normal);

}  // namespace pineda::scene
