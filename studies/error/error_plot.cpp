#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/error/error_pictures.h"
#include "studies/picture/labels.h"
#include "studies/picture/numbers.h"
#include "studies/picture/svg.h"

namespace pineda::studies {
namespace {

constexpr double kWidthPx = 900;
constexpr double kHeightPx = 600;
constexpr Box kField{72, 86, 804, 432};
constexpr double kMarkerPx = 5.5;
constexpr double kNamePx = 12;
constexpr double kRemarkPx = 10.5;
constexpr double kLeaderPx = 6;  // nearer labels need no line
constexpr size_t kLongestScene = 40;

constexpr Paint kRoundingLine{"none", kInk, 1, "5 4"};

// A subject as it is drawn.
struct Dot {
  const Subject* subject;
  double pace;
  double error;
  std::string remark;  // below its name
};

struct Words {
  std::string title;
  std::string unit;
  std::string error;
  std::string pace;
};

Words words(Quantity quantity, Pace pace) {
  const bool depth = quantity == Quantity::kDepth;
  return {fmt::format("{} against {} error", pace == Pace::kHost ? "Speed" : "Hardware speed",
                      depth ? "depth" : "colour"),
          depth ? "ulp" : "LSB",
          depth ? "largest depth error, ulp (1 ulp = 1 depth code)"
                : "largest colour error, LSB of a channel",
          pace == Pace::kHost ? "speed of the software: covered samples a second"
                              : "speed of hardware: covered samples a clock cycle"};
}

double pace_of(const ErrorStudy& study, const Subject& s, Pace pace) {
  const double time = pace == Pace::kHost ? s.seconds : s.cycles.value_or(s.visited.value_or(0));
  return time > 0 ? static_cast<double>(study.samples) / time : 0;
}

std::string remark_of(const Subject& s, double error, const std::string& unit) {
  const uint64_t wrong = s.missing + s.extra;
  std::string remark;
  if (error == 0) remark = "0 " + unit;
  if (wrong != 0) {
    remark += fmt::format("{}{} sample{} wrong", remark.empty() ? "" : ", ", count_figure(wrong),
                          wrong == 1 ? "" : "s");
  }
  return remark;
}

// "2.00e6" as an axis wants it: "2 M".
std::string with_prefix(double value) {
  static constexpr const char* kPrefixes[] = {"", " k", " M", " G", " T"};
  size_t i = 0;
  for (; value > 999.5 && i < 4; ++i) value /= 1000;
  return fmt::format("{:g}{}", value, kPrefixes[i]);
}

void draw_marker(Svg* svg, Point at, bool is_design, bool hollow) {
  const char* color = is_design ? kDesignColor : kBaselineColor;
  const Paint paint{hollow ? kPaper : color, hollow ? color : kPaper, hollow ? 1.8 : 1};
  if (is_design) {
    svg->circle(at, kMarkerPx, paint);
  } else {
    const double r = kMarkerPx * 1.15;
    svg->polygon({{at.x, at.y - r}, {at.x + r, at.y + .75 * r}, {at.x - r, at.y + .75 * r}}, paint);
  }
}

class Plot {
 public:
  Plot(const ErrorStudy& study, const std::string& scene, Quantity quantity, Pace pace)
      : study_(study),
        words_(words(quantity, pace)),
        svg_(kWidthPx, kHeightPx, words_.title + ": " + scene),
        x_(LogAxis::around({}, 0, 1)),
        y_(x_) {
    for (const Subject& s : study.subjects) {
      const Distribution& errors = quantity == Quantity::kDepth ? s.depth : s.color;
      const double speed = pace_of(study, s, pace);
      if (errors.count() == 0 || speed == 0) {
        left_out_ += (left_out_.empty() ? "" : ", ") + s.name;
      } else {
        dots_.push_back({&s, speed, errors.max(), remark_of(s, errors.max(), words_.unit)});
      }
    }
    std::vector<double> paces;
    std::vector<double> errors{.5};  // the line of final rounding, 1/2, is always shown
    for (const Dot& dot : dots_) {
      paces.push_back(dot.pace);
      errors.push_back(dot.error);
    }
    x_ = LogAxis::around(paces, kField.left, kField.right());
    y_ = LogAxis::around(errors, kField.bottom() - 64, kField.top + 8);
    draw_titles(scene);
    draw_axes();
    draw_rounding();
    draw_dots();
  }

  std::string file() const { return svg_.file(); }

 private:
  void draw_titles(std::string scene) {
    if (scene.size() > kLongestScene) {
      size_t at = scene.size() - kLongestScene;
      while (at < scene.size() && (scene[at] & 0xc0) == 0x80) ++at;  // not inside a UTF-8 character
      scene = "..." + scene.substr(at);
    }
    svg_.text({kField.left, 28}, words_.title + ": " + scene, {18, kInk, Anchor::kStart, true});
    svg_.text({kField.left, 48},
              fmt::format("{} × {} px, {} triangles, {} covered samples; each subject's worst "
                          "sample, by exact arithmetic",
                          study_.width, study_.height, grouped(study_.triangles),
                          grouped(study_.samples)),
              {12.5, kGrey});
    double x = kField.left + kMarkerPx;
    const auto entry = [&](bool is_design, bool hollow, const std::string& text) {
      draw_marker(&svg_, {x, 69}, is_design, hollow);
      svg_.text({x + 11, 73}, text, {12, kInk});
      x += 11 + text_width(text, 12) + 16;
    };
    entry(true, false, "design of Pineda");
    entry(false, false, "textbook baseline");
    entry(true, true, "");
    x -= 12;
    entry(false, true, "hollow: wrong coverage");
    svg_.line({x - 4, 69}, {x + 20, 69}, kRoundingLine);
    svg_.text({x + 26, 73}, fmt::format("½ {}: all are nearest", words_.unit), {12, kInk});
    svg_.text({kField.right() - 26, 73}, "better", {12, kInk, Anchor::kEnd, true});
    svg_.arrow({kField.right() - 19, 63}, {kField.right() - 4, 76}, {"none", kInk, 1.6});
  }

  void draw_axes() {
    for (const auto& tick : x_.ticks()) {
      const double x = x_.at(tick.value);
      const bool named = !tick.text.empty();
      if (named) svg_.line({x, kField.top}, {x, kField.bottom()}, {"none", kFaint});
      svg_.line({x, kField.bottom()}, {x, kField.bottom() + (named ? 6 : 3)}, {"none", kGrey});
      if (named) {
        const std::string text = tick.value < 1000 ? tick.text : with_prefix(tick.value);
        svg_.text({x, kField.bottom() + 20}, text, {12, kGrey, Anchor::kMiddle});
      }
    }
    for (const auto& tick : y_.ticks()) {
      const double y = y_.at(tick.value);
      const bool named = !tick.text.empty();
      if (named) svg_.line({kField.left, y}, {kField.right(), y}, {"none", kFaint});
      svg_.line({kField.left - (named ? 6 : 3), y}, {kField.left, y}, {"none", kGrey});
      if (named) svg_.text({kField.left - 9, y + 4}, tick.text, {12, kGrey, Anchor::kEnd});
    }
    svg_.rectangle(kField, {"none", kGrey});
    svg_.text({kField.left + kField.width / 2, kField.bottom() + 42}, words_.pace,
              {13, kInk, Anchor::kMiddle});
    svg_.text({20, kField.top + (kField.height - 90) / 2}, words_.error,
              {13, kInk, Anchor::kMiddle, false, true});
    svg_.text({kField.right() - 40, kField.bottom() + 42}, "faster", {12, kGrey, Anchor::kEnd});
    svg_.arrow({kField.right() - 34, kField.bottom() + 38},
               {kField.right() - 4, kField.bottom() + 38}, {"none", kGrey, 1.3});
    svg_.text({20, kField.bottom() - 38}, "closer", {12, kGrey, Anchor::kStart, false, true});
    svg_.arrow({16, kField.bottom() - 33}, {16, kField.bottom() - 4}, {"none", kGrey, 1.3});
  }

  void draw_rounding() {
    const double y = y_.at(.5);
    svg_.line({kField.left, y}, {kField.right(), y}, kRoundingLine);
  }

  void draw_dots() {
    std::vector<Label> labels;
    for (const Dot& dot : dots_) {
      labels.push_back(
          {{x_.at(dot.pace), y_.at(dot.error)},
           std::max(text_width(dot.subject->name, kNamePx), text_width(dot.remark, kRemarkPx)),
           dot.remark.empty() ? kNamePx + 2 : kNamePx + kRemarkPx + 3});
    }
    const auto boxes = place_labels(labels, kField, kMarkerPx + 2.5);
    for (size_t i = dots_.size(); i-- > 0;) {  // backwards: designs are drawn over baselines
      const Subject& s = *dots_[i].subject;
      draw_marker(&svg_, labels[i].at, s.is_design, s.missing + s.extra != 0);
    }
    std::string unnamed;
    for (size_t i = 0; i < dots_.size(); ++i) {
      if (boxes[i]) {
        draw_label(dots_[i], labels[i].at, *boxes[i]);
        draw_leader(labels, i, *boxes[i]);
      } else {
        unnamed += (unnamed.empty() ? "" : ", ") + dots_[i].subject->name;
      }
    }
    std::string note;
    if (!left_out_.empty()) note = "Not shown, nothing judged or timed: " + left_out_ + ". ";
    if (!unnamed.empty()) note += "Without room for a name: " + unnamed + ".";
    svg_.text({kField.left, kHeightPx - 12}, note, {11, kGrey});
  }

  // Draws the line from a label to its marker. Where markers overlap, it ends at the marker's
  // centre.
  void draw_leader(const std::vector<Label>& labels, size_t i, const Box& box) {
    const Point at = labels[i].at;
    const Point end = nearest_point(box, at);
    const double length = std::hypot(end.x - at.x, end.y - at.y);
    const auto near = [&](const Label& other) {
      return std::hypot(other.at.x - at.x, other.at.y - at.y) < 2 * kMarkerPx;
    };
    const bool crowded = std::count_if(labels.begin(), labels.end(), near) > 1;
    if (length <= kMarkerPx + kLeaderPx) return;
    const double rest = crowded ? 0 : (kMarkerPx + 1.5) / length;
    const Point start{at.x + rest * (end.x - at.x), at.y + rest * (end.y - at.y)};
    svg_.line(start, end, {"none", kInk, .8});
    if (crowded) svg_.circle(at, 1.6, {kInk});
  }

  // The text is aligned to the side of the box that faces its point.
  void draw_label(const Dot& dot, Point at, const Box& box) {
    const char* color = dot.subject->is_design ? kDesignColor : kBaselineColor;
    TextStyle name{kNamePx, color, Anchor::kMiddle, dot.subject->is_design, false, true};
    double x = box.left + box.width / 2;
    if (box.left >= at.x) {
      name.anchor = Anchor::kStart;
      x = box.left;
    } else if (box.right() <= at.x) {
      name.anchor = Anchor::kEnd;
      x = box.right();
    }
    svg_.text({x, box.top + kNamePx - 1}, dot.subject->name, name);
    if (dot.remark.empty()) return;
    svg_.text({x, box.bottom() - 2.5}, dot.remark,
              {kRemarkPx, kGrey, name.anchor, false, false, true});
  }

  const ErrorStudy& study_;
  Words words_;
  Svg svg_;
  LogAxis x_;
  LogAxis y_;
  std::vector<Dot> dots_;
  std::string left_out_;
};

}  // namespace

std::string speed_error_svg(const ErrorStudy& study, const std::string& scene, Quantity quantity,
                            Pace pace) {
  return Plot(study, scene, quantity, pace).file();
}

}  // namespace pineda::studies
