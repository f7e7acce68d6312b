// The node graph of a glTF file: where each mesh stands.
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
  /// A surface's normal, turned like the surface (by the inverse transposed matrix); unit length.
  Vec3 normal(const Vec3& n) const;
  double determinant() const;
};
Affine operator*(const Affine& a, const Affine& b);  // b first

struct PlacedNode {
  size_t index;  // of the document's nodes
  const GltfNode* node;
  Affine world;
  bool is_visible = true;  // it and all above it
};

/// The nodes of the file's scene in depth-first order, children in the order of the file. The scene
/// is the file's default, else its first; in a file without scenes all root nodes.
/// Errors   InputError, "nodes[3]: ...": an index out of range, a node reached twice (a cycle, or
///          two parents), a matrix that is not affine, a rotation of length 0.
std::vector<PlacedNode> place_nodes(const std::string& file, const GltfDocument& document);

/// The camera of a node that has one, with its place in the world.
///
/// Out      it looks along the node's -Z with the node's +Y above, both turned by the node and all
///          above it. Their lengths have no meaning; where they are not perpendicular (shear), +Y
///          gives way. The third axis follows, so that a mirroring node mirrors no picture.
///          FileCamera::wrong where +Y and -Z span no plane, or the camera itself is wrong.
/// Source   Khronos glTF 2.0 specification, 3.10: the view matrix, "with the scaling ignored".
FileCamera place_camera(const GltfDocument& document, const PlacedNode& placed);

}  // namespace pineda::scene
