#include <algorithm>
#include <cmath>
#include <string>

#include "studies/picture/ramp.h"
#include "studies/seeing/heat_map.h"

namespace pineda::studies {
namespace {

using timing::Cycle;

// Lightness grows throughout, so that the map can be read without hues.
constexpr std::array<Stop, 5> kRamp{{{0, {28, 16, 68}},
                                     {.25, {104, 20, 108}},
                                     {.5, {190, 56, 84}},
                                     {.75, {249, 142, 9}},
                                     {1, {252, 255, 164}}}};
constexpr Rgb kNothing{0, 0, 0};
constexpr Rgb kGround{255, 255, 255};
constexpr Rgb kInk{28, 36, 48};

// px
constexpr int kLeastWidth = 320;
constexpr int kMargin = 8;
constexpr int kBar = 12;
constexpr int kTick = 3;
constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 7;
constexpr int kLetter = kGlyphWidth + 1;
constexpr int kLegendHeight =
    kMargin + kGlyphHeight + 4 + kBar + kTick + 3 + kGlyphHeight + kMargin;

// The letters that the legend needs: rows of five pixels, the left one in the highest bit.
struct Glyph {
  char letter;
  std::array<uint8_t, kGlyphHeight> rows;
};
constexpr std::array<Glyph, 18> kGlyphs{{{'0', {0x0e, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0e}},
                                         {'1', {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e}},
                                         {'2', {0x0e, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1f}},
                                         {'3', {0x1f, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0e}},
                                         {'4', {0x02, 0x06, 0x0a, 0x12, 0x1f, 0x02, 0x02}},
                                         {'5', {0x1f, 0x10, 0x1e, 0x01, 0x01, 0x11, 0x0e}},
                                         {'6', {0x06, 0x08, 0x10, 0x1e, 0x11, 0x11, 0x0e}},
                                         {'7', {0x1f, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08}},
                                         {'8', {0x0e, 0x11, 0x11, 0x0e, 0x11, 0x11, 0x0e}},
                                         {'9', {0x0e, 0x11, 0x11, 0x0f, 0x01, 0x02, 0x0c}},
                                         {'c', {0x00, 0x00, 0x0e, 0x10, 0x10, 0x11, 0x0e}},
                                         {'e', {0x00, 0x00, 0x0e, 0x11, 0x1f, 0x10, 0x0e}},
                                         {'i', {0x04, 0x00, 0x0c, 0x04, 0x04, 0x04, 0x0e}},
                                         {'l', {0x0c, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0e}},
                                         {'s', {0x00, 0x00, 0x0e, 0x10, 0x0e, 0x01, 0x1e}},
                                         {'t', {0x08, 0x08, 0x1c, 0x08, 0x08, 0x09, 0x06}},
                                         {'y', {0x00, 0x00, 0x11, 0x11, 0x0f, 0x01, 0x0e}},
                                         {'/', {0x00, 0x01, 0x02, 0x04, 0x08, 0x10, 0x00}}}};

class Canvas {
 public:
  Canvas(int width, int height) {
    picture_.width = width;
    picture_.height = height;
    picture_.rgb.assign(3 * static_cast<size_t>(width) * static_cast<size_t>(height), kGround[0]);
  }

  void pixel(int x, int y, const Rgb& color) {
    const auto at =
        3 * (static_cast<size_t>(y) * static_cast<size_t>(picture_.width) + static_cast<size_t>(x));
    std::copy(color.begin(), color.end(), picture_.rgb.begin() + static_cast<std::ptrdiff_t>(at));
  }

  /// Letters without a glyph are blank.
  void text(int x, int y, const std::string& text) {
    for (const char letter : text) {
      for (const Glyph& glyph : kGlyphs) {
        if (glyph.letter == letter) draw(x, y, glyph);
      }
      x += kLetter;
    }
  }

  Picture take() { return std::move(picture_); }

 private:
  void draw(int x, int y, const Glyph& glyph) {
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        const int bit = kGlyphWidth - 1 - column;
        if ((glyph.rows[static_cast<size_t>(row)] >> bit & 1) != 0) {
          pixel(x + column, y + row, kInk);
        }
      }
    }
  }

  Picture picture_;
};

double place(Cycle cycles, Cycle most) {
  return std::sqrt(static_cast<double>(cycles) / static_cast<double>(std::max<Cycle>(most, 1)));
}

int text_width(const std::string& text) { return kLetter * static_cast<int>(text.size()) - 1; }

// The scale from 0 to `most`, at `top`.
void draw_legend(Canvas* canvas, int top, Cycle most) {
  constexpr int kLeft = kMargin;
  constexpr int kWidth = kLeastWidth - 2 * kMargin;
  const int bar = top + kMargin + kGlyphHeight + 4;
  canvas->text(kLeft, top + kMargin, "cycles/tile");
  for (int x = 0; x < kWidth; ++x) {
    const Rgb color = color_along(kRamp, (x + .5) / kWidth);
    for (int y = 0; y < kBar; ++y) canvas->pixel(kLeft + x, bar + y, color);
  }
  constexpr int kTicks = 4;
  int free = 0;  // the first column without text
  for (int i = 0; i <= kTicks; ++i) {
    const Cycle cycles = most * i / kTicks * i / kTicks;
    const int x = static_cast<int>(std::lround((kWidth - 1) * place(cycles, most)));
    const std::string text = std::to_string(cycles);
    const int left = kLeft + std::clamp(x - text_width(text) / 2, 0, kWidth - text_width(text));
    if (left < free) continue;
    free = left + text_width(text) + kLetter;
    for (int y = 0; y < kTick; ++y) canvas->pixel(kLeft + x, bar + kBar + y, kInk);
    canvas->text(left, bar + kBar + kTick + 3, text);
  }
}

}  // namespace

Picture heat_map_picture(const HeatMap& map, const spec::Contract& contract,
                         const spec::FrameState& frame) {
  const int zoom = (std::max(kLeastWidth - frame.width, 0) + frame.width - 1) / frame.width + 1;
  const int width = frame.width * zoom;
  const int height = frame.height * zoom;
  const int tile_px = zoom << contract.design.tile_log2;
  const Cycle most = map.hottest().cycles;
  Canvas canvas(width, height + kLegendHeight);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cycle cycles = map.cycles(x / tile_px, y / tile_px);
      canvas.pixel(x, y, cycles == 0 ? kNothing : color_along(kRamp, place(cycles, most)));
    }
  }
  draw_legend(&canvas, height, most);
  return canvas.take();
}

}  // namespace pineda::studies
