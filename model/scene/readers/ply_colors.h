// Finds the properties of a PLY element that are its colour.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/readers/ply_file.h"

namespace pineda::scene {

/// The colour of an element, from the first of these sets of properties that is complete: red green
/// blue [alpha], r g b [a], diffuse_red diffuse_green diffuse_blue [diffuse_alpha]; of 8 or 16 bits
/// unsigned, or floats from 0 to 1.
class PlyColors {
 public:
  explicit PlyColors(const PlyElement& element);

  bool are_there() const { return are_there_; }
  /// The channel of property `i`: 0 to 3 for red to alpha, -1 if it is no colour.
  int channel(size_t i) const { return channel_[i]; }
  /// Sets the channel of property `i` in *color; the channel must not be -1.
  /// Errors   InputError unless the number is from 0 to its type's full scale.
  void set(size_t i, double number, const PlyFile& file, Rgba* color) const;

  /// Names the properties that look like a colour but are not used, in one line; else empty.
  const std::string& note() const { return note_; }

 private:
  bool are_there_ = false;
  std::vector<int> channel_;        // of each property
  std::vector<double> full_scale_;  // of each property: the number that means 1
  std::string note_;
};

}  // namespace pineda::scene
