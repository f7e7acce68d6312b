// The enumerations of raster state and their words, as .tri lines, options, reports and the RTL
// package use them. The order of the values gives their codes in the RTL.
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

/// The comparison of a new depth with the stored one under which a sample passes. kOff neither
/// tests nor writes depth.
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

/// With which clear depths a depth function hides everything: no sample passes on a freshly cleared
/// frame, or only samples exactly at the clear depth. Most likely a mistake in the scene's state.
enum class Barred : uint8_t { kNone, kAll, kClearedToNearest, kClearedToFarthest };

struct DepthFuncName {
  DepthFunc value;
  const char* word;
  Barred barred = Barred::kNone;
  const char* why = "";
};
inline constexpr DepthFuncName kDepthFuncNames[] = {
    {DepthFunc::kLess, "less", Barred::kClearedToNearest,
     "nothing is less than what depth is cleared to; cleardepth 1 or --clear-depth 1 clears it to "
     "the farthest"},
    {DepthFunc::kLequal, "lequal", Barred::kClearedToNearest,
     "only samples at the near end are not greater than what depth is cleared to; cleardepth 1 or "
     "--clear-depth 1 clears it to the farthest"},
    {DepthFunc::kOff, "off"},
    {DepthFunc::kNever, "never", Barred::kAll, "no sample passes"},
    {DepthFunc::kEqual, "equal"},
    {DepthFunc::kGreater, "greater", Barred::kClearedToFarthest,
     "nothing is greater than what depth is cleared to; cleardepth 0 or --clear-depth 0 clears it "
     "to the nearest"},
    {DepthFunc::kNotequal, "notequal"},
    {DepthFunc::kGequal, "gequal", Barred::kClearedToFarthest,
     "only samples at the far end are not less than what depth is cleared to; cleardepth 0 or "
     "--clear-depth 0 clears it to the nearest"},
    {DepthFunc::kAlways, "always"},
};
constexpr const auto& names(DepthFunc) { return kDepthFuncNames; }

}  // namespace pineda::spec
