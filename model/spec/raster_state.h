// The choices of raster state, with their words: as .tri lines, options, reports and the package
// of the RTL say them, and in the order of its codes.
#pragma once

#include <cstdint>

#include "model/spec/names.h"

namespace pineda::spec {

enum class Cull : uint8_t { kNone, kBack, kFront };

inline constexpr Name<Cull> kCullNames[] = {
    {Cull::kNone, "none"}, {Cull::kBack, "back"}, {Cull::kFront, "front"}};
constexpr const auto& names(Cull) { return kCullNames; }

/// flat: the first vertex gives the attributes.
enum class Shade : uint8_t { kSmooth, kFlat };

inline constexpr Name<Shade> kShadeNames[] = {{Shade::kSmooth, "smooth"}, {Shade::kFlat, "flat"}};
constexpr const auto& names(Shade) { return kShadeNames; }

/// A new sample passes if it compares so with the stored one. kOff neither tests nor writes.
enum class DepthFunc : uint8_t {
  kLess,
  kLequal,
  kOff,
  kNever,
  kEqual,
  kGreater,
  kNotequal,
  kGequal,
  kAlways,
};

inline constexpr Name<DepthFunc> kDepthFuncNames[] = {
    {DepthFunc::kLess, "less"},         {DepthFunc::kLequal, "lequal"},
    {DepthFunc::kOff, "off"},           {DepthFunc::kNever, "never"},
    {DepthFunc::kEqual, "equal"},       {DepthFunc::kGreater, "greater"},
    {DepthFunc::kNotequal, "notequal"}, {DepthFunc::kGequal, "gequal"},
    {DepthFunc::kAlways, "always"},
};
constexpr const auto& names(DepthFunc) { return kDepthFuncNames; }

}  // namespace pineda::spec
