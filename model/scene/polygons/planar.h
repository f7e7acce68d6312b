// A polygon's corners projected exactly onto the plane of its mean normal.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/scene/vec.h"

namespace pineda::scene {

/// A polygon seen along its Newell normal n, the sum of the cross products of neighbouring corners.
///
/// Bits     every result is exact, whatever the exponents: a corner is projected along n onto two
///          integer coordinates (u, v), right-handed as seen against n. Doubles decide where their
///          error bound suffices, integers elsewhere.
class PlanarPolygon {
 public:
  /// All corners are finite; there are three or more.
  explicit PlanarPolygon(const std::vector<Vec3>& corner);

  /// True if n is not zero; otherwise the functions below are meaningless.
  bool has_plane() const { return has_plane_; }
  uint32_t size() const { return static_cast<uint32_t>(u_.size()); }

  /// The sign of n . ((b - a) x (c - a)): 1 where a, b, c turn left.
  int turn(uint32_t a, uint32_t b, uint32_t c) const;

  /// The rank of a corner's coordinate in sorted order; equal coordinates have equal ranks.
  uint32_t u_rank(uint32_t i) const { return u_rank_[i]; }
  uint32_t v_rank(uint32_t i) const { return v_rank_[i]; }
  /// The rank of a corner's point (u, v), ordered by u, then by v; equal points have equal ranks.
  /// places() is the number of different points.
  uint32_t place(uint32_t i) const { return place_[i]; }
  uint32_t places() const { return places_; }

 private:
  // Without expression templates, whose temporaries cost more than they save at this size.
  using Int = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                            boost::multiprecision::et_off>;

  void project(const std::vector<Vec3>& corner);
  void rank_places();

  bool has_plane_ = false;
  uint32_t places_ = 0;
  std::vector<Int> u_, v_;
  std::vector<double> u_near_, v_near_;  // scaled to at most 1 in magnitude, to 52 bits or better
  std::vector<uint32_t> u_rank_, v_rank_, place_;
};

}  // namespace pineda::scene
