// Which properties of a PLY element are its colour.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/readers/ply_file.h"

namespace pineda::scene {

/// The colour of an element, by the first of these names that it has all of: red green blue
/// [alpha], r g b [a], diffuse_red diffuse_green diffuse_blue [diffuse_alpha]; 8 or 16 bits
/// unsigned, or floats from 0 to 1.
class PlyColors {
 public:
  explicit PlyColors(const PlyElement& element);

  bool are_there() const { return are_there_; }
  /// Of property `i`: 0 to 3 for red to alpha, or -1.
  int channel(size_t i) const { return channel_[i]; }
  /// Takes the number of property `i`, whose channel is not -1, as a part of *color.
  /// Errors   InputError unless it is from 0 to 1 of its type's full scale.
  void set(size_t i, double number, const PlyFile& file, Rgba* color) const;

  /// What looks like a colour and is not used, in one line; "" if nothing does.
  const std::string& note() const { return note_; }

 private:
  bool are_there_ = false;
  std::vector<int> channel_;        // of each property
  std::vector<double> full_scale_;  // its number for 1
  std::string note_;
};

}  // namespace pineda::scene
