// A mesh's triangles as a camera and a design see them.
#pragma once

#include <memory>

#include "model/scene/mesh_reader.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {

inline std::unique_ptr<MeshReader> mesh_reader(const Mesh& mesh, const View& view, int width,
                                               int height,
                                               const spec::Contract& contract = kContract,
                                               spec::Shade shade = spec::Shade::kSmooth) {
  spec::FrameState frame;
  frame.width = width;
  frame.height = height;
  frame.shade = shade;
  return std::make_unique<MeshReader>(std::make_shared<const ClipMesh>(clip_mesh(mesh, view)),
                                      frame, contract);
}

}  // namespace pineda::scene
