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

/// Which freshly cleared frames no sample passes, or only one at the end of the range that depth is
/// cleared to. Nobody draws so on purpose.
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
