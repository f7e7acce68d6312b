// The part of SVG that plots need: shapes, text, logarithmic axes.
#pragma once

#include <string>
#include <vector>

namespace pineda::studies {

/// `text` escaped for HTML, SVG and attributes, so that nothing in it is taken for markup. Control
/// characters become spaces.
std::string escaped(const std::string& text);

// Positions and lengths are in px, x to the right, y down.
struct Point {
  double x = 0;
  double y = 0;
};

struct Box {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
  bool overlaps(const Box& other) const;
  /// Lies `inner` in it whole?
  bool holds(const Box& inner) const;
};

// Colours used in all pictures; they differ for readers with red-green colour blindness, too.
inline constexpr const char* kInk = "#1c2430";
inline constexpr const char* kGrey = "#5a6573";
inline constexpr const char* kFaint = "#e3e6ea";
inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kDesignColor = "#0069a8";
inline constexpr const char* kBaselineColor = "#c2500a";

struct Paint {
  const char* fill = "none";
  const char* stroke = "none";
  double stroke_px = 1;
  const char* dashes = "";  // as of stroke-dasharray
};

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  double size_px = 12;
  const char* color = kInk;
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  bool upwards = false;  // a quarter turn to the left
  bool halo = false;     // a background-coloured outline hides lines behind the letters
};

/// Width of `text`, in px, in the widest of the usual sans-serif fonts; others run shorter.
double text_width(const std::string& text, double size_px);

/// A self-contained picture on a light ground: no script, no style sheet, no font file.
class Svg {
 public:
  /// `title`: for screen readers.
  Svg(double width, double height, const std::string& title);

  void line(Point from, Point to, const Paint& paint);
  /// A line with a head at `to`.
  void arrow(Point from, Point to, const Paint& paint);
  void rectangle(const Box& box, const Paint& paint);
  void circle(Point center, double radius, const Paint& paint);
  /// Closed; corners in order.
  void polygon(const std::vector<Point>& corners, const Paint& paint);
  /// `at` is on the base line of the text.
  void text(Point at, const std::string& text, const TextStyle& style);

  /// The file. In a page it goes through inlined().
  std::string file() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

/// A picture's file as part of an HTML page: without the SVG name space, which HTML implies.
std::string inlined(std::string svg);

/// Maps values from low to high (0 < low < high) to positions on a logarithmic scale.
class LogAxis {
 public:
  struct Tick {
    double value;
    std::string text;  // empty: a tick without a label
  };

  LogAxis(double low, double high, double low_px, double high_px);
  /// An axis for all positive `values`, with some margin around them; from .5 to 50 if there are
  /// none.
  static LogAxis around(const std::vector<double>& values, double low_px, double high_px);

  /// Position of a value; those beyond the ends (0, too) are on the ends.
  double at(double value) const;
  /// Decades, at most nine of them with a text; 2 to 9 between them where there is room.
  std::vector<Tick> ticks() const;

 private:
  double low_;
  double high_;
  double low_px_;
  double high_px_;
};

/// "0.01", "1", "1000", "10⁴".
std::string power_of_ten(int exponent);
/// "2⁻⁸"; 0 to 9 as "1" to "512".
std::string power_of_two(int exponent);

}  // namespace pineda::studies
