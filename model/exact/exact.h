// The judge: coverage, depth and attributes of a triangle in exact integers and rationals, from its
// snapped vertices (Judge) or from a scene's floats (ScreenJudge). An independent reference for
// model and RTL: it includes nothing of the rest of the project.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
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

/// The frame and its raster state.
struct Frame {
  int width = 0;
  int height = 0;
  Cull cull = Cull::kNone;
  // Scissor: only columns [x0, x1) and rows [y0, y1) are drawn. It may reach beyond the frame.
  int x0 = 0;
  int y0 = 0;
  int x1 = INT32_MAX;
  int y1 = INT32_MAX;
  bool flat = false;  // the first vertex gives the attributes of all samples
  // Depth bias = constant + slope * max(|dz/dx|, |dz/dy|), with z in codes and x, y in px.
  int64_t bias_constant = 0;  // codes, within 2^32
  int bias_slope = 0;         // units of 2^-8, within 2^15
};

/// Pixels first..last of one row; empty when first > last.
struct Span {
  int first = 0;
  int last = -1;
};

/// One snapped triangle in one frame, judged sample by sample. All results are exact, except that
/// errors are rounded to a double once, at the end (within .501 ulp).
///
/// In       |x|, |y| <= 2^26 subpixels, 0 <= z <= 2^60, 1 to 12 subpixel bits.
/// Errors   std::out_of_range beyond that; std::domain_error where a sample is not covered.
class Judge {
 public:
  Judge(Triangle triangle, int subpixel_bits, int width, int height, Cull cull)
      : Judge(std::move(triangle), subpixel_bits, Frame{width, height, cull}) {}
  /// Uses only the frame's size, scissor and culling; ScreenJudge handles shading and depth bias.
  Judge(Triangle triangle, int subpixel_bits, const Frame& frame);

  /// The triangle as it was given.
  const Triangle& vertices() const { return v_; }
  /// Doubled area in units of 2^-2S px^2, positive when clockwise on screen.
  int64_t doubled_area() const;
  /// True if nothing is drawn: zero area, or culled by facing.
  bool culled() const;
  /// Does the sample of pixel (x, y) belong to the triangle, by the top-left rule?
  bool covers(int x, int y) const;
  /// The covered samples of a row, computed by division, not by stepping.
  Span span(int y) const;
  /// First and last row that may hold covered samples; empty when first > last.
  Span rows() const;
  /// Number of covered samples in the frame.
  int64_t samples() const;
  /// Barycentric weights of the sample of pixel (x, y), in units of 2^-2S px^2: for each vertex, in
  /// the order given, the doubled area of the sample and the opposite edge. None is negative, and
  /// their sum is |doubled_area()|. The sample must be covered.
  std::array<int64_t, 3> weights(int x, int y) const;

  /// `code` minus the exact depth at the sample of (x, y), in codes. The sample must be covered.
  double depth_error(int x, int y, int64_t code) const;
  /// `value` minus the exact attribute, interpolated affinely, in LSB.
  double attribute_error(int x, int y, int attribute, int64_t value) const;

 private:
  Triangle v_;
  int subpixel_bits_;
  Frame frame_;
  int64_t area2_;
  bool culled_;
};

/// A vertex as a scene states it: x, y in px, y down; z in [0, 1]; the clip-space w; colour with 8
/// bits a component, not premultiplied.
struct ScreenVertex {
  float x = 0;
  float y = 0;
  float z = 0;
  float w = 1;
  std::array<int, 4> rgba{};
};
using ScreenTriangle = std::array<ScreenVertex, 3>;

/// The formats that a triangle is snapped to.
struct Format {
  int subpixel_bits = 8;   // 1 to 12
  int guard_bits = 14;     // up to 26 together with subpixel_bits
  int depth_bits = 24;     // up to 32
  int attributes = 4;      // up to 16: r, g, b, a; all after the fourth are 0
  int attribute_bits = 8;  // up to 16
};

/// A value v >= 0 in codes. whole = floor(v) and nearest = floor(v + 1/2) are exact; fraction = v -
/// whole, in [0, 1), is within 2^-53.
struct Value {
  int64_t whole = 0;
  double fraction = 0;
  int64_t nearest = 0;

  /// code - v, to within 2^-53 and the rounding of the result.
  double error_of(int64_t code) const;
  /// value * 2^-fraction_bits - v, for values before the final rounding; 0 to 52 fraction bits.
  double error_of(int64_t value, int fraction_bits) const;
};

/// A covered sample: depth with its bias, clamped to the range of codes; and the attributes r, g,
/// b, a, both interpolated affinely on the screen and with perspective correction. Attributes that
/// the format does not have are 0.
struct Sample {
  int x = 0;
  int y = 0;
  Value z;
  std::array<Value, 4> affine;
  std::array<Value, 4> perspective;
};

/// One triangle given in floats: snapped by the rules below, then judged row by row.
///
/// Bits     x, y by snap(), z by depth_input(), a colour c as c*(2^attribute_bits - 1)/255 to the
///          nearest. Values are interpolated between these snapped values at snapped positions; z
///          linearly on the screen; with perspective a = sum(E_i a_i/w_i) / sum(E_i/w_i), where w
///          is the binary32 w taken exactly and E_i is weights().
/// Drops    a NaN in x, y, z or w of any vertex drops the triangle.
/// Errors   std::out_of_range: a format or a bias beyond its range, a colour beyond 8 bits, w not a
///          positive normal float.
class ScreenJudge {
 public:
  ScreenJudge(const ScreenTriangle& triangle, const Format& format, const Frame& frame);

  /// A component is NaN, so there are no samples.
  bool dropped() const { return dropped_; }
  /// True if nothing is drawn: dropped, zero area after snapping, or culled by facing.
  bool culled() const { return snapped_.culled(); }
  /// All w are equal or shading is flat, so perspective and affine values are the same.
  bool affine() const { return affine_; }
  /// max(|dz/dx|, |dz/dy|) in codes per px, with a relative error of a few 2^-53; 0 without area.
  double depth_slope() const;
  /// The judge of the snapped triangle; if dropped(), that of a triangle without area.
  const Judge& snapped() const { return snapped_; }
  /// See Judge.
  Span rows() const { return snapped_.rows(); }
  Span span(int y) const { return snapped_.span(y); }

  /// Appends the covered samples of a row, left to right. Without `with_perspective` the
  /// perspective values are 0.
  void row(int y, bool with_perspective, std::vector<Sample>* out) const;

 private:
  /// Computes the biased depths of a row.
  void biased_row(const std::array<int64_t, 3>& at, const std::array<int64_t, 3>& next,
                  Sample* first, Sample* last) const;

  Judge snapped_;
  Format format_;
  Frame frame_;
  bool dropped_;
  bool affine_ = true;
  size_t attributes_;  // of the format, at most the 4 that a Sample has
  // E_i/w_i is proportional to E_i * product_[i] * 2^shift_[i].
  std::array<int64_t, 3> product_{};
  std::array<int, 3> shift_{};
  bool narrow_ = true;  // the perspective sums fit into 128 bits
};

/// The snapped coordinate of a float in px: to the nearest multiple of 2^-subpixel_bits, halves to
/// even, in units of 2^-subpixel_bits px, saturated to [-2^guard_bits, 2^guard_bits -
/// 2^-subpixel_bits]. *saturated says whether the rounded value lay outside. Denormals become 0.
/// `value` must not be NaN.
int64_t snap(float value, int subpixel_bits, int guard_bits, bool* saturated);

/// z*(2^depth_bits - 1) in units of 2^-8 codes, rounded half up, with z clamped to [0, 1]; *clamped
/// says whether z lay outside. depth_bits <= 32; z must not be NaN.
int64_t depth_input(float z, int depth_bits, bool* clamped);

}  // namespace exact
