// The node graph of a glTF file: the world transform of each node.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/readers/gltf/document.h"
#include "model/scene/vec.h"

namespace pineda::scene {

/// p -> linear * p + offset
struct Affine {
  std::array<Vec3, 3> linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // rows
  Vec3 offset{0, 0, 0};

  Vec3 point(const Vec3& p) const;
  /// Transforms a surface normal, by the inverse transposed matrix; the result has unit length.
  Vec3 normal(const Vec3& n) const;
  double determinant() const;
};
Affine operator*(const Affine& a, const Affine& b);  // applies b first

struct PlacedNode {
  size_t index;  // of the document's nodes
  const GltfNode* node;
  Affine world;
  bool is_visible = true;  // it and all its ancestors are
};

/// The nodes of the file's scene in depth-first order, children in the order of the file. The scene
/// is the file's default one, else its first; if the file has no scenes, all root nodes are used.
/// Errors   InputError, "nodes[3]: ...": an index out of range, a node reached twice (a cycle, or
///          two parents), a matrix that is not affine, a rotation of length 0.
std::vector<PlacedNode> place_nodes(const std::string& file, const GltfDocument& document);

/// The camera of a node that has one, in world space.
///
/// Out      it looks along the node's -Z axis with +Y up, both transformed by the node and its
///          ancestors and normalized. If they are not perpendicular (shear), +Y is corrected. The
///          third axis is computed from these two, so a mirroring node does not mirror the picture.
///          FileCamera::wrong is set if +Y and -Z are parallel or zero, or the camera is invalid.
/// Source   Khronos glTF 2.0 specification, 3.10: the view matrix, "with the scaling ignored".
FileCamera place_camera(const GltfDocument& document, const PlacedNode& placed);

}  // namespace pineda::scene
