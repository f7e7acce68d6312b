#include "model/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pineda::scene {
namespace {

constexpr double kFilled = .92;         // part of the frame that framing_view() fills with the mesh
constexpr double kTangent = .3;         // tangent of half the vertical angle: 33.4 degrees in all
constexpr double kGreatestRatio = 1e4;  // far / near

void look_along(const Vec3& back, const Vec3& up, View* view) {
  view->back = normalized(back);
  view->right = normalized(cross(up, view->back));
  view->up = cross(view->back, view->right);
}

void set_scale(double tangent, int width, int height, View* view) {
  view->scale_y = 1 / tangent;
  view->scale_x = view->scale_y * height / width;
}

template <class Visit>
void for_each_used(const Mesh& mesh, Visit&& visit) {
  for (const auto& t : mesh.triangle) {
    if (!mesh.is_finite(t)) continue;
    for (const uint32_t i : t) visit(mesh.position[i]);
  }
}

// Bounds of u + k*back and -u + k*back over the mesh, where u is the coordinate along the right or
// up axis. They give the least distance of the eye from which the mesh lies within the half-angle
// of tangent k, and the eye's u that centres it.
struct Wedge {
  double k;
  double low = -std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double u, double back) {
    high = std::max(high, u + k * back);
    low = std::max(low, -u + k * back);
  }
  double distance() const { return (high + low) / (2 * k); }
  double middle() const { return (high - low) / 2; }
};

void set_planes(const Mesh& mesh, View* view) {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0;
  for_each_used(mesh, [&](const Vec3& p) {
    const double w = dot(view->back, view->eye - p);
    nearest = std::min(nearest, w);
    farthest = std::max(farthest, w);
  });
  // With nothing in front of the eye any planes will do: every triangle is clipped away.
  view->far = farthest > 0 ? 1.001 * farthest : 1;
  view->near = std::max(.999 * nearest, view->far / kGreatestRatio);
  if (!(view->near < view->far)) view->near = view->far / kGreatestRatio;
}

}  // namespace

std::array<double, 4> View::clip(const Vec3& world) const {
  const Vec3 p = world - eye;
  const double x = scale_x * dot(right, p), y = scale_y * dot(up, p);
  const double along = -dot(back, p), w = is_orthographic ? 1 : along;
  double z = (along - near) * (far / (far - near));
  if (std::isinf(far)) z = along - near;
  if (is_orthographic) z = (along - near) / (far - near);
  return {x, y, is_reversed ? w - z : z, w};
}

View framing_view(const Mesh& mesh, int width, int height) {
  View view;
  look_along({.5, .42, 1}, {0, 1, 0}, &view);
  set_scale(kTangent, width, height, &view);
  Wedge horizontal{kFilled / view.scale_x};
  Wedge vertical{kFilled / view.scale_y};
  double front = -std::numeric_limits<double>::infinity();
  double rear = std::numeric_limits<double>::infinity();
  for_each_used(mesh, [&](const Vec3& p) {
    const double back = dot(view.back, p);
    horizontal.add(dot(view.right, p), back);
    vertical.add(dot(view.up, p), back);
    front = std::max(front, back);
    rear = std::min(rear, back);
  });
  if (front < rear) return view;  // nothing that could be drawn
  // The eye must lie in front of the mesh even if width and height are 0. The gap is relative to
  // the mesh's depth, or to its coordinates if the depth is 0.
  const double depth = front - rear;
  const double gap = depth > 0 ? .1 * depth : 1 + 1e-6 * std::abs(front);
  const double distance = std::max({horizontal.distance(), vertical.distance(), front + gap});
  view.eye = horizontal.middle() * view.right + vertical.middle() * view.up + distance * view.back;
  set_planes(mesh, &view);
  return view;
}

View camera_view(const Camera& camera, const Mesh& mesh, int width, int height) {
  View view;
  view.eye = camera.eye;
  look_along(camera.eye - camera.target, camera.up, &view);
  if (!(length(view.back) > .5) || !(length(view.right) > .5)) {
    throw std::invalid_argument("expected a camera with eye, target and up apart");
  }
  if (!(camera.fovy_deg > 0 && camera.fovy_deg < 180)) {
    throw std::invalid_argument("expected a camera angle between 0 and 180 degrees");
  }
  set_scale(std::tan(camera.fovy_deg * (M_PI / 360)), width, height, &view);
  set_planes(mesh, &view);
  return view;
}

View file_view(const FileCamera& camera, int width, int height) {
  if (!camera.wrong.empty()) throw std::invalid_argument(camera.wrong);
  View view;
  view.eye = camera.eye;
  view.right = camera.right;
  view.up = camera.up;
  view.back = camera.back;
  set_scale(camera.is_orthographic ? camera.ymag : std::tan(camera.yfov / 2), width, height, &view);
  view.near = camera.near;
  view.far = camera.far.value_or(std::numeric_limits<double>::infinity());
  view.is_orthographic = camera.is_orthographic;
  view.far_cuts = camera.far.has_value();
  const double depth_scale = view.is_orthographic ? 1 / (view.far - view.near) : 1;
  if (!std::isfinite(view.scale_x) || !std::isfinite(view.scale_y) || !std::isfinite(depth_scale)) {
    throw std::invalid_argument("expected a camera that sees more than a point");
  }
  return view;
}

}  // namespace pineda::scene
