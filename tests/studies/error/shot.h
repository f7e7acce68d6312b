// A mesh before a camera, judged.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/scene/polygons/triangulate.h"
#include "studies/judge/front_end.h"
#include "studies/judge/scene_truth.h"

namespace pineda::studies {

/// A mesh before a camera, on a frame, for a design.
struct Shot {
  scene::Mesh mesh;
  scene::Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 33};
  spec::FrameState frame;
  spec::Design design = spec::kHighTile;

  scene::ClipMesh seen() const {
    return clip_mesh(mesh, camera_view(camera, mesh, frame.width, frame.height));
  }
};

inline Shot shot_of(scene::Mesh mesh, int width, int height) {
  Shot shot;
  shot.mesh = std::move(mesh);
  shot.frame.width = width;
  shot.frame.height = height;
  return shot;
}

inline std::vector<SceneTriangle> snapped(const spec::Contract& contract,
                                          std::unique_ptr<scene::ScreenReader> reader) {
  scene::SnappedSource source(contract, std::move(reader));
  std::vector<SceneTriangle> pieces;
  for (SceneTriangle t; source.next(&t.snapped); pieces.push_back(t)) {
    t.screen = stated(source.screen());
  }
  return pieces;
}

inline std::vector<SceneTriangle> pieces_of(const Shot& shot, const scene::ClipMesh& seen) {
  const auto contract = spec::contract(shot.design);
  return snapped(contract,
                 std::make_unique<scene::MeshReader>(std::make_shared<const scene::ClipMesh>(seen),
                                                     shot.frame, contract));
}

inline MeshJudgement judged(const Shot& shot) {
  const scene::ClipMesh seen = shot.seen();
  return judge_front_end(seen, shot.frame, pieces_of(shot, seen), shot.design);
}

inline std::string what(const MeshJudgement& j) { return j.first ? j.first->what : ""; }

inline scene::Mesh mesh_of(std::vector<scene::Vec3> position, std::vector<scene::Rgba> color) {
  scene::Mesh mesh;
  mesh.normal.assign(position.size(), {0, 0, 1});
  mesh.position = std::move(position);
  mesh.color = std::move(color);
  return mesh;
}

inline scene::Mesh polygon_mesh(const std::vector<scene::Vec3>& position) {
  std::vector<scene::Rgba> color(position.size(), {50, 100, 150, 255});
  scene::Mesh mesh = mesh_of(position, color);
  std::vector<uint32_t> all;
  for (uint32_t i = 0; i < position.size(); ++i) all.push_back(i);
  scene::PolygonCutter(&mesh).add(all.data(), all.size());
  return mesh;
}

}  // namespace pineda::studies
