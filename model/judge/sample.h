// A drawn sample, and the errors of its values against the exact ones.
#pragma once

#include <array>

#include "model/spec/structs.h"

namespace pineda::judge {

/// A sample as a rasterizer draws it.
struct Drawn {
  int x = 0, y = 0;         // px
  int64_t z = 0;            // depth code
  spec::Attributes attr{};  // the interpolated ones first, then the flat ones
};

/// Which values a sample has, and how they are interpolated.
struct Values {
  bool depth = true;
  int smooth = 4;            // attributes that are interpolated
  int channels = 4;          // all attributes: interpolated, then flat ones of the first vertex
  bool perspective = false;  // interpolated with perspective, else affinely
};
inline Values values_of(const spec::Design& d) {
  return {d.depth_test, d.attributes, spec::channels(d), d.perspective};
}

/// A value minus the exact one.
struct Error {
  double units = 0;            // in units of the last place
  bool is_misrounded = false;  // not the nearest code
};

/// The errors of a sample's values; 0 for values that it does not have.
struct Errors {
  Error depth;
  std::array<Error, spec::kMaxAttributes> attr{};
};

/// Calls visit(x, y, lane) for each covered sample of a stamp.
template <class Visit>
void for_each_lane(const spec::Design& d, const spec::Stamp& stamp, Visit&& visit) {
  int lane = 0;
  for (uint32_t mask = stamp.mask; mask != 0; mask >>= 1, ++lane) {
    if ((mask & 1) == 0) continue;
    visit((stamp.x << d.stamp_width_log2) + (lane & ((1 << d.stamp_width_log2) - 1)),
          (stamp.y << d.stamp_height_log2) + (lane >> d.stamp_width_log2),
          static_cast<size_t>(lane));
  }
}

/// Calls visit(Drawn) for each covered sample of a stamp.
template <class Visit>
void for_each_sample(const spec::Design& d, const spec::Stamp& stamp,
                     const spec::Fragment& fragment, Visit&& visit) {
  const auto smooth = static_cast<size_t>(d.attributes);
  const auto channels = static_cast<size_t>(spec::channels(d));
  for_each_lane(d, stamp, [&](int x, int y, size_t lane) {
    Drawn drawn{x, y, fragment.z[lane], {}};
    for (size_t i = 0; i < channels; ++i) {
      drawn.attr[i] = i < smooth ? fragment.attr[lane][i] : stamp.planes.flat[i - smooth];
    }
    visit(drawn);
  });
}

}  // namespace pineda::judge
