#include "studies/picture/numbers.h"

#include <fmt/format.h>

namespace pineda::studies {
namespace {

// "1.2e5" for 123456.
std::string scientific(double value) {
  const std::string text = fmt::format("{:.1e}", value);
  const size_t e = text.find('e');
  if (e == std::string::npos) return text;  // infinite
  return fmt::format("{}e{}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

}  // namespace

std::string figure(double value) {
  if (value == 0) return "0";
  if (value < .0005) return "<.001";
  if (value < .9995) return fmt::format("{:.3f}", value);
  if (value < 9.995) return fmt::format("{:.2f}", value);
  if (value < 99.95) return fmt::format("{:.1f}", value);
  if (value < 99999.5) return fmt::format("{:.0f}", value);
  return scientific(value);
}

std::string count_figure(uint64_t count) {
  return count < 1'000'000 ? grouped(count) : scientific(static_cast<double>(count));
}

std::string grouped(uint64_t count) {
  std::string text = std::to_string(count);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3) {
    text.insert(static_cast<size_t>(i), ",");
  }
  return text;
}

}  // namespace pineda::studies
