#include "model/scene/readers/ply_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace pineda::scene {
namespace {

using Names = std::array<std::string_view, 4>;
constexpr std::array<Names, 3> kNames{
    Names{"red", "green", "blue", "alpha"}, Names{"r", "g", "b", "a"},
    Names{"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}};
constexpr size_t kShort = 1;  // index in kNames: single letters, which may mean something else

// The number that means 1 in a colour of this type; 0 if the type cannot be a colour.
double full_scale(const PlyProperty& property) {
  if (property.count) return 0;
  switch (property.type) {
    case PlyType::kU8:
      return 255;
    case PlyType::kU16:
      return 65535;
    case PlyType::kF32:
    case PlyType::kF64:
      return 1;
    default:
      return 0;
  }
}

int channel_of(const Names& names, const std::string& name) {
  const auto* at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? -1 : static_cast<int>(at - names.begin());
}

// Does the element have red, green and blue, and maybe alpha, each once and of a usable type?
bool has_all(const PlyElement& element, const Names& names) {
  std::array<int, 4> count{};
  for (const PlyProperty& property : element.properties) {
    const int channel = channel_of(names, property.name);
    if (channel < 0) continue;
    if (full_scale(property) == 0) return false;
    ++count[static_cast<size_t>(channel)];
  }
  return count[0] == 1 && count[1] == 1 && count[2] == 1 && count[3] <= 1;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// True for names like ambient_red, specular_blue, vertex_color, RGB, f_dc_0.
bool looks_like_color(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const char* end :
       {"red", "green", "blue", "alpha", "gray", "grey", "luminance", "intensity"}) {
    if (ends_with(name, end)) return true;
  }
  for (const char* part : {"color", "colour", "rgb", "f_dc_"}) {
    if (name.find(part) != std::string::npos) return true;
  }
  return false;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr size_t kMost = 4;
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (i > 0 ? ", " : "") + quoted(names[i]);
  }
  return names.size() > kMost ? text + fmt::format(" and {} more", names.size() - kMost) : text;
}

}  // namespace

PlyColors::PlyColors(const PlyElement& element) {
  size_t chosen = 0;
  while (chosen < kNames.size() && !has_all(element, kNames[chosen])) ++chosen;
  are_there_ = chosen < kNames.size();
  std::vector<std::string> others;
  for (const PlyProperty& property : element.properties) {
    channel_.push_back(are_there_ ? channel_of(kNames[chosen], property.name) : -1);
    full_scale_.push_back(full_scale(property));
    if (channel_.back() >= 0) continue;
    const bool is_short = channel_of(kNames[kShort], property.name) >= 0;
    if (looks_like_color(property.name) ||
        (is_short && (!are_there_ || has_all(element, kNames[kShort])))) {
      others.push_back(property.name);
    }
  }
  if (others.empty()) return;
  note_ = are_there_ ? fmt::format("left out beside the colours of {}: {}", quoted(element.name),
                                   listed(others))
                     : fmt::format(
                           "colours not used: {} has {}, expected red, green and blue as uchar, "
                           "ushort or float",
                           quoted(element.name), listed(others));
}

void PlyColors::set(size_t i, double number, const PlyFile& file, Rgba* color) const {
  const double value = number / full_scale_[i];
  if (!(value >= 0 && value <= 1)) file.fail("a colour from 0 to 1", fmt::format("{}", value));
  (*color)[static_cast<size_t>(channel_[i])] = static_cast<uint8_t>(std::lround(value * 255));
}

}  // namespace pineda::scene
