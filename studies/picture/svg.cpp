#include "studies/picture/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace pineda::studies {
namespace {

constexpr const char* kNameSpace = " xmlns=\"http://www.w3.org/2000/svg\"";
constexpr int kMostTexts = 9;       // along an axis
constexpr int kFewDecades = 3;      // up to this many, 2 and 5 are labelled, too
constexpr int kManyDecades = 8;     // from this many on, no ticks between decades
constexpr double kAirDecades = .1;  // margin beyond the least and the greatest value

std::string attributes(const Paint& paint) {
  std::string text = fmt::format("fill=\"{}\"", paint.fill);
  if (std::string(paint.stroke) != "none") {
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{:g}\"", paint.stroke, paint.stroke_px);
  }
  if (*paint.dashes != '\0') text += fmt::format(" stroke-dasharray=\"{}\"", paint.dashes);
  return text;
}

// In units of the font's size.
double width_of(char c) {
  if (std::string_view("ijlI.,:;'|!").find(c) != std::string_view::npos) return .36;
  if (std::string_view("ftr ()-/1").find(c) != std::string_view::npos) return .44;
  if (std::string_view("mwMW%@").find(c) != std::string_view::npos) return .98;
  return c >= 'A' && c <= 'Z' ? .72 : .64;
}

std::string superscript(int number) {
  static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c >= 0 && c < ' ' ? ' ' : c;
    }
  }
  return result;
}

bool Box::overlaps(const Box& other) const {
  return left < other.right() && other.left < right() && top < other.bottom() &&
         other.top < bottom();
}

bool Box::holds(const Box& inner) const {
  return left <= inner.left && inner.right() <= right() && top <= inner.top &&
         inner.bottom() <= bottom();
}

double text_width(const std::string& text, double size_px) {
  double width = 0;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // UTF-8
    if (!continues) width += width_of(c);
  }
  return width * size_px;
}

Svg::Svg(double width, double height, const std::string& title) {
  body_ = fmt::format(
      "<svg{0} viewBox=\"0 0 {1:g} {2:g}\" width=\"{1:g}\" height=\"{2:g}\" role=\"img\" "
      "font-family=\"system-ui,-apple-system,'Segoe UI',Roboto,Helvetica,Arial,sans-serif\">\n"
      "<title>{3}</title>\n",
      kNameSpace, width, height, escaped(title));
  rectangle({0, 0, width, height}, {kPaper});
}

void Svg::line(Point from, Point to, const Paint& paint) {
  body_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n",
                       from.x, from.y, to.x, to.y, attributes(paint));
}

void Svg::arrow(Point from, Point to, const Paint& paint) {
  constexpr double kHeadPx = 6;
  line(from, to, paint);
  const double angle = std::atan2(to.y - from.y, to.x - from.x);
  for (const double turn : {-.45, .45}) {
    line(to, {to.x - kHeadPx * std::cos(angle + turn), to.y - kHeadPx * std::sin(angle + turn)},
         paint);
  }
}

void Svg::rectangle(const Box& box, const Paint& paint) {
  body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n",
                       box.left, box.top, box.width, box.height, attributes(paint));
}

void Svg::circle(Point center, double radius, const Paint& paint) {
  body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" {}/>\n", center.x, center.y,
                       radius, attributes(paint));
}

void Svg::polygon(const std::vector<Point>& corners, const Paint& paint) {
  std::string points;
  for (const Point& p : corners) points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  body_ += fmt::format("<polygon points=\"{}\" {}/>\n", points, attributes(paint));
}

void Svg::text(Point at, const std::string& text, const TextStyle& style) {
  static constexpr const char* kAnchors[] = {"start", "middle", "end"};
  std::string more;
  if (style.bold) more += " font-weight=\"600\"";
  if (style.halo) {
    more += fmt::format(" stroke=\"{}\" stroke-width=\"3.5\" paint-order=\"stroke\"", kPaper);
  }
  if (style.upwards) more += fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at.x, at.y);
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}"
      "</text>\n",
      at.x, at.y, style.size_px, style.color, kAnchors[static_cast<int>(style.anchor)], more,
      escaped(text));
}

std::string inlined(std::string svg) {
  const size_t at = svg.find(kNameSpace);
  if (at != std::string::npos) svg.erase(at, std::string_view(kNameSpace).size());
  return svg;
}

LogAxis::LogAxis(double low, double high, double low_px, double high_px)
    : low_(low), high_(high), low_px_(low_px), high_px_(high_px) {}

LogAxis LogAxis::around(const std::vector<double>& values, double low_px, double high_px) {
  double least = 0;
  double greatest = 0;
  for (const double v : values) {
    if (!(v > 0) || !std::isfinite(v)) continue;
    least = least == 0 ? v : std::min(least, v);
    greatest = std::max(greatest, v);
  }
  if (least == 0) return {.5, 50, low_px, high_px};
  // One value, or nearly so, still gets an axis with ticks on it.
  const double missing = std::max(0., 1 - std::log10(greatest / least)) / 2;
  const double air = kAirDecades + missing;
  return {least / std::pow(10, air), greatest * std::pow(10, air), low_px, high_px};
}

double LogAxis::at(double value) const {
  const double clamped = std::clamp(value, low_, high_);
  return low_px_ + (high_px_ - low_px_) * std::log(clamped / low_) / std::log(high_ / low_);
}

std::vector<LogAxis::Tick> LogAxis::ticks() const {
  const int first = static_cast<int>(std::floor(std::log10(low_)));
  const int last = static_cast<int>(std::floor(std::log10(high_)));
  const int decades = last - first + 1;
  const int every = (decades + kMostTexts - 1) / kMostTexts;
  std::vector<Tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit <= (decades >= kManyDecades ? 1 : 9); ++digit) {
      const double value = digit * std::pow(10, exponent);
      if (value < low_ || value > high_) continue;
      std::string text;
      if (digit == 1 && exponent % every == 0) text = power_of_ten(exponent);
      if (decades <= kFewDecades && (digit == 2 || digit == 5)) text = fmt::format("{:g}", value);
      ticks.push_back({value, text});
    }
  }
  return ticks;
}

std::string power_of_ten(int exponent) {
  if (exponent < -3 || exponent > 3) return "10" + superscript(exponent);
  return fmt::format("{:g}", std::pow(10, exponent));
}

std::string power_of_two(int exponent) {
  if (exponent >= 0 && exponent <= 9) return std::to_string(1 << exponent);
  return "2" + superscript(exponent);
}

}  // namespace pineda::studies
