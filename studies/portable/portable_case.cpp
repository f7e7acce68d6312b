#include "studies/portable/portable_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/judge/exact_terms.h"
#include "model/scene/error.h"
#include "model/scene/tri_writer.h"
#include "studies/judge/stated.h"

namespace pineda::studies {
namespace {

constexpr int64_t kColorTop = 255;

/// w with the 1/w of a vertex, up to the triangle's common factor.
float w_of(const spec::Vertex& v, int greatest_shift, int inverse_w_bits) {
  // binary32 has 253 powers of two, and a few are kept free; only the most distant w lose by it.
  constexpr int kMost = 250, kLow = -124;
  const int scale = greatest_shift > -kLow ? kLow : 0;
  const double unit = std::ldexp(1., inverse_w_bits - 1) / v.inverse_w;
  return static_cast<float>(std::ldexp(unit, std::min(v.inverse_w_shift, kMost) + scale));
}

uint8_t color_of(const spec::Design& d, const spec::Triangle& triangle, size_t corner,
                 size_t channel) {
  if (channel >= static_cast<size_t>(spec::channels(d))) return 0;
  // Those that are not interpolated are the first corner's.
  const size_t from = channel < static_cast<size_t>(d.attributes) ? corner : 0;
  const int64_t top = (int64_t{1} << d.attribute_bits) - 1;
  return static_cast<uint8_t>((triangle.v[from].attr[channel] * kColorTop + top / 2) / top);
}

/// A value in decimal, to a millionth.
std::string decimal(const exact::Value& value) {
  constexpr int64_t kUnit = 1000000;
  const auto millionths = static_cast<int64_t>(std::llround(value.fraction * kUnit));
  return fmt::format("{}.{:06}", value.whole + millionths / kUnit, millionths % kUnit);
}

std::string snapped_line(size_t number, const exact::Triangle& triangle) {
  std::string text = fmt::format("snapped {}", number);
  for (const exact::Vertex& v : triangle) text += fmt::format(" {} {} {}", v.x, v.y, v.z);
  return text + "\n";
}

std::string fragment_lines(size_t number, const exact::ScreenJudge& judge) {
  std::string text;
  std::vector<exact::Sample> row;
  const exact::Span rows = judge.rows();
  for (int y = rows.first; y <= rows.last; ++y) {
    row.clear();
    judge.row(y, !judge.affine(), &row);
    for (const exact::Sample& sample : row) {
      const Fragment fragment = fragment_of(sample, judge.affine());
      text += fmt::format("fragment {} {} {} {}", number, sample.x, y, decimal(fragment.z));
      for (const exact::Value& value : fragment.color) text += " " + decimal(value);
      text += "\n";
    }
  }
  return text;
}

}  // namespace

PortableCase portable_case(const spec::Contract& c, const vectors::FrameCase& vector) {
  const spec::Design& d = c.design;
  PortableCase value{vector.name, vector.frame, {}};
  spec::FrameState& f = value.frame;
  if (!d.depth_test) f.depth = spec::DepthFunc::kOff;
  const bool is_whole =
      f.clip_x0() <= 0 && f.clip_y0() <= 0 && f.clip_x1() >= f.width && f.clip_y1() >= f.height;
  f.scissor_x1 = is_whole ? spec::kNoScissorPx : std::max(f.clip_x1(), f.scissor_x0);
  f.scissor_y1 = is_whole ? spec::kNoScissorPx : std::max(f.clip_y1(), f.scissor_y0);
  if (is_whole) f.scissor_x0 = f.scissor_y0 = 0;
  f.clear_depth = static_cast<float>(f.clear_depth);
  const int64_t top_code = (int64_t{1} << d.depth_bits) - 1;
  f.bias_constant = std::clamp(f.bias_constant, -top_code, top_code);
  const auto far =
      static_cast<double>(((int64_t{1} << d.depth_bits) - 1) << spec::kDepthInputFractionBits);
  for (const spec::Triangle& triangle : vector.in) {
    scene::ScreenTriangle screen{static_cast<uint32_t>(value.triangles.size()), {}};
    const int greatest_shift =
        std::max({triangle.v[0].inverse_w_shift, triangle.v[1].inverse_w_shift,
                  triangle.v[2].inverse_w_shift});
    for (size_t i = 0; i < 3; ++i) {
      const spec::Vertex& v = triangle.v[i];
      scene::ScreenVertex& to = screen.v[i];
      to.x = std::ldexp(static_cast<float>(v.x), -d.subpixel_bits);
      to.y = std::ldexp(static_cast<float>(v.y), -d.subpixel_bits);
      to.z = d.depth_test ? static_cast<float>(static_cast<double>(v.z) / far) : 0;
      to.w = d.perspective ? w_of(v, greatest_shift, d.inverse_w_bits) : 1;
      for (size_t k = 0; k < to.rgba.size(); ++k) to.rgba[k] = color_of(d, triangle, i, k);
    }
    value.triangles.push_back(screen);
  }
  return value;
}

spec::Contract portable_contract(const exact::Format& format, const std::string& file,
                                 uint64_t line) {
  spec::Design design = *spec::find_design("persp");
  design.guard_bits = format.guard_bits;
  design.subpixel_bits = format.subpixel_bits;
  design.depth_bits = format.depth_bits;
  const std::string why = spec::invalid_reason(design);
  if (!why.empty()) throw scene::InputError(file, line, why);
  return spec::contract(design);
}

std::string portable_text(const PortableCase& value, const FrameTolerance& tolerance) {
  std::string text = "case " + value.name + "\n" + scene::tri_state(value.frame);
  for (const scene::ScreenTriangle& triangle : value.triangles) {
    text += scene::tri_vertices(triangle);
  }
  // Depths make it follow what may be seen; nothing is compared with them.
  FrameDump any;
  any.depth.emplace(value.samples());
  FrameJudge frame(value.frame, tolerance, any);
  std::string fragments;
  for (size_t i = 0; i < value.triangles.size(); ++i) {
    const exact::ScreenJudge judge(stated(value.triangles[i]), tolerance.format,
                                   judge::exact_frame(value.frame));
    text += snapped_line(i, judge.snapped().vertices());
    fragments += fragment_lines(i, judge);
    frame.triangle(value.triangles[i]);
  }
  text += fragments;
  for (size_t i = 0; i < value.samples(); ++i) {
    if (frame.hits(i) == 0) continue;
    const auto width = static_cast<size_t>(value.frame.width);
    text += fmt::format("pixel {} {} {}", i % width, i / width, frame.hits(i));
    for (const auto& triangle : frame.seen(i)) {
      text += triangle ? fmt::format(" {}", *triangle) : std::string(" -");
    }
    text += "\n";
  }
  return text + "end\n";
}

}  // namespace pineda::studies
