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

/// A camera made ready: clip = (x, y, z, w) with w the distance along the view, or 1 in an
/// orthographic one; 0 <= z <= w between the near and the far plane, and |x|, |y| <= w inside the
/// frame. With far infinite z = w - near. Reversed, z is w less that.
struct View {
  Vec3 eye;
  Vec3 right, up, back;  // orthonormal; back points from the scene to the eye
  double scale_x = 1, scale_y = 1;
  double near = 1, far = 2;
  bool is_orthographic = false;
  bool far_cuts = false;     // what lies beyond far is not drawn; else far is behind everything
  bool is_reversed = false;  // z = w at the near plane and 0 at the far one

  std::array<double, 4> clip(const Vec3& world) const;
};

/// A view from the front, a little from the right and above, as close as the frame allows: the mesh
/// spans .92 of it in one direction, centred there, and less in the other.
View framing_view(const Mesh& mesh, int width, int height);

/// The view of a given camera. Near and far enclose the part of the mesh in front of it; far is
/// never so near that it cuts.
/// Errors   std::invalid_argument when the camera looks nowhere: eye = target, up along the view,
///          or an angle outside (0, 180).
View camera_view(const Camera& camera, const Mesh& mesh, int width, int height);

/// The view of a camera that came with the mesh: near and far are its own, and what lies beyond far
/// is cut. The frame's aspect wins: what it spans from top to bottom stays.
/// Errors   std::invalid_argument, what FileCamera::wrong says.
View file_view(const FileCamera& camera, int width, int height);

}  // namespace pineda::scene
