// The judge: coverage, depth and attributes of a triangle in exact integers and rationals.
// A third opinion, written apart: it includes nothing of the rest of the project.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace exact {

/// A snapped vertex. x, y in units of 2^-subpixel_bits px, y down; z in units of 2^-8 codes.
struct Vertex {
  int64_t x = 0;
  int64_t y = 0;
  int64_t z = 0;
  std::vector<int> attr;
};
using Triangle = std::array<Vertex, 3>;

enum class Cull { kNone, kBack, kFront };

/// Pixels first..last of one row; empty when first > last.
struct Span {
  int first = 0;
  int last = -1;
};

/// One triangle in one frame, judged sample by sample. All answers are exact; an error is computed
/// exactly and divided and rounded once at the end (within .501 ulp of a double).
///
/// In       |x|, |y| <= 2^26 subpixels, 0 <= z <= 2^60, 1 to 12 subpixel bits.
/// Errors   std::out_of_range beyond that; std::domain_error where the sample lies outside.
class Judge {
 public:
  Judge(Triangle triangle, int subpixel_bits, int width, int height, Cull cull);

  /// Doubled area in units of 2^-2S px^2, positive when clockwise on screen.
  int64_t doubled_area() const;
  /// Nothing is drawn: zero area, or culled by facing.
  bool culled() const;
  /// Does the sample of pixel (x, y) belong to the triangle, by the top-left rule?
  bool covers(int x, int y) const;
  /// The covered samples of a row, found by division, not by stepping.
  Span span(int y) const;
  /// First and last row that may hold covered samples; empty when first > last.
  Span rows() const;
  /// Covered samples of the frame.
  int64_t samples() const;

  /// `code` minus the exact depth at the sample of (x, y), in codes. The sample must be covered.
  double depth_error(int x, int y, int64_t code) const;
  /// `value` minus the exact attribute, interpolated affinely, in LSB.
  double attribute_error(int x, int y, int attribute, int64_t value) const;

 private:
  Triangle v_;  // clockwise on screen
  int subpixel_bits_;
  int width_;
  int height_;
  int64_t area2_;
  bool culled_;
};

/// The snapped coordinate of a float in px: to the nearest multiple of 2^-subpixel_bits, halves to
/// even, in units of 2^-subpixel_bits px, saturated to [-2^guard_bits, 2^guard_bits -
/// 2^-subpixel_bits]. *saturated says whether the rounded value lay outside. Denormals count as 0.
/// NaN must not come here.
int64_t snap(float value, int subpixel_bits, int guard_bits, bool* saturated);

/// z*(2^depth_bits - 1) in units of 2^-8 codes, halves up, z clamped to [0, 1]; *clamped says
/// whether it lay outside. depth_bits <= 32. NaN must not come here.
int64_t depth_input(float z, int depth_bits, bool* clamped);

}  // namespace exact
