// Closed meshes, and cameras inside and outside of them.
#pragma once

#include <string>
#include <vector>

#include "model/scene/camera.h"
#include "model/spec/random.h"

namespace pineda::studies {

struct ClosedMesh {
  std::string name;
  scene::Mesh mesh;
};

/// A cube of quads, a prism over a star, a torus of triangles, a prickly ball; about 2 across.
/// Random colours of vertices.
std::vector<ClosedMesh> closed_meshes();

/// A camera inside or outside, close to a surface or far from it, 5 to 178 degrees.
scene::Camera random_camera(spec::Random* random);

}  // namespace pineda::studies
