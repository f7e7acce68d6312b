// The node graph of a glTF file: where each mesh stands.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <string>
#include <vector>

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
  const tinygltf::Node* node;
  Affine world;
};

/// The nodes of the file's scene in depth-first order, children in the order of the file. The scene
/// is the file's default, else its first; in a file without scenes all root nodes.
/// Errors   InputError, "nodes[3]: ...": an index out of range, a node reached twice (a cycle, or
/// two
///          parents), a matrix that is not affine, a rotation of length 0.
std::vector<PlacedNode> place_nodes(const std::string& file, const tinygltf::Model& model);

}  // namespace pineda::scene
