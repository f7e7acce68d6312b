#include "studies/area/area_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "studies/picture/svg.h"

namespace pineda::studies {
namespace {

constexpr double kWidth = 860;
constexpr double kNames = 300;  // px for the names on the left
constexpr double kFigures = 150;
constexpr double kRow = 20;
constexpr double kHead = 56;
constexpr double kLeastShare = .005;

struct Bar {
  std::string name;
  double area_um2;
  bool is_memory;
};

std::string name_of(const AreaPart& part) { return part.path.empty() ? part.module : part.path; }

// The bars of a unit, the largest first, the small ones together at the end.
std::vector<Bar> bars_of(const AreaStudy& study, const std::string& unit) {
  std::vector<Bar> bars;
  Bar rest{"others", 0, false};
  for (const AreaPart& part : study.parts) {
    if (part.unit != unit) continue;
    if (part.area_um2 < kLeastShare * study.area_um2) {
      rest.area_um2 += part.area_um2;
    } else {
      bars.push_back({name_of(part), part.area_um2, part.memory_bits > 0});
    }
  }
  std::stable_sort(bars.begin(), bars.end(),
                   [](const Bar& a, const Bar& b) { return a.area_um2 > b.area_um2; });
  if (rest.area_um2 > 0) bars.push_back(rest);
  return bars;
}

}  // namespace

std::string area_picture(const AreaStudy& study, const std::string& title) {
  double greatest = 0;
  double height = kHead + kRow;
  for (const auto& [unit, area] : study.units) {
    const auto bars = bars_of(study, unit);
    height += kRow * (1.5 + static_cast<double>(bars.size()));
    for (const Bar& bar : bars) greatest = std::max(greatest, bar.area_um2);
  }
  Svg svg(kWidth, height, title);
  TextStyle head;
  head.size_px = 15;
  head.bold = true;
  svg.text({16, 26}, title, head);
  TextStyle plain;
  TextStyle grey;
  grey.color = kGrey;
  svg.text({16, 44}, "Cells in um^2, every stored bit as a flip-flop; memories in another colour",
           grey);
  TextStyle bold;
  bold.bold = true;
  TextStyle right;
  right.anchor = Anchor::kEnd;
  double y = kHead;
  for (const auto& [unit, area] : study.units) {
    y += kRow * .5;
    svg.text({16, y + 14}, unit, bold);
    svg.text(
        {kWidth - 16, y + 14},
        fmt::format("{:.0f} um^2, {:.1f} %", area.area_um2, 100 * area.area_um2 / study.area_um2),
        right);
    y += kRow;
    for (const Bar& bar : bars_of(study, unit)) {
      svg.text({32, y + 14}, bar.name, plain);
      const double width = (kWidth - kNames - kFigures) * bar.area_um2 / greatest;
      Paint paint;
      paint.fill = bar.is_memory ? kBaselineColor : kDesignColor;
      svg.rectangle({kNames, y + 3, width, kRow - 6}, paint);
      svg.text({kNames + width + 6, y + 14}, fmt::format("{:.0f}", bar.area_um2), grey);
      y += kRow;
    }
  }
  return svg.file();
}

}  // namespace pineda::studies
