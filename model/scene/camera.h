// The camera: world space to clip space.
#pragma once

#include <array>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// World space is right-handed with y up.
struct Camera {
  Vec3 eye{0, 0, 1};
  Vec3 target{0, 0, 0};
  Vec3 up{0, 1, 0};
  double fovy_deg = 33;  // full vertical angle
};

/// The transform from world space to clip space (x, y, z, w). w is the distance along the viewing
/// direction, or 1 if orthographic. |x|, |y| <= w inside the frame, and 0 <= z <= w between the
/// near and the far plane. With an infinite far plane z = w - near. Reversed z is w - z.
struct View {
  Vec3 eye;
  Vec3 right, up, back;  // orthonormal; back points from the scene to the eye
  double scale_x = 1, scale_y = 1;
  double near = 1, far = 2;
  bool is_orthographic = false;
  bool far_cuts = false;     // clip at the far plane; false: it lies behind the whole mesh
  bool is_reversed = false;  // z = w at the near plane and 0 at the far one

  std::array<double, 4> clip(const Vec3& world) const;
};

/// A view from the front, slightly from the right and from above, at the least distance from which
/// the mesh fits: it spans at most .92 of the frame's width and height.
View framing_view(const Mesh& mesh, int width, int height);

/// The view of a given camera. Near and far enclose the part of the mesh in front of it; the far
/// plane never cuts the mesh.
/// Errors   std::invalid_argument: eye = target, up parallel to the viewing direction, or an angle
///          outside (0, 180).
View camera_view(const Camera& camera, const Mesh& mesh, int width, int height);

/// The view of a camera from the mesh's file, with its own near and far; the mesh is clipped at far
/// if there is one. The vertical extent is the camera's, the aspect ratio is the frame's.
/// Errors   std::invalid_argument, what FileCamera::wrong says.
View file_view(const FileCamera& camera, int width, int height);

}  // namespace pineda::scene
