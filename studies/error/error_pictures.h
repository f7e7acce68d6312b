// What `pineda error` draws: speed against error, histograms, where the error is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studies/error/error.h"

namespace pineda::studies {

/// The error that is shown: depth in ulp or colour in LSB.
enum class Quantity { kDepth, kColor };

/// The speed that is shown: of this program, covered samples a second; or of hardware, covered
/// samples a clock (the cycle model's; for baselines one visited pixel a clock).
enum class Pace { kHost, kClock };

/// An SVG file of 900 x 600: a point for each subject, its pace against its largest error, both on
/// logarithmic axes. Subjects that miss samples, or draw wrong ones, are hollow and say how many.
/// Those without a figure (nothing judged, or not timed) are named below the axis.
std::string speed_error_svg(const ErrorStudy& study, const std::string& scene,
                            Quantity quantity = Quantity::kDepth, Pace pace = Pace::kHost);

/// An SVG file, 900 wide: for each subject the share of its errors in each octave, depth and
/// colour, with the 1/2 of the final rounding, the design's bound and the largest error.
std::string histogram_svg(const ErrorStudy& study);

/// The colours of error maps, the same for all subjects of a study. Errors up to 1/2, which the
/// final rounding alone can make, are blue. Greater ones run from purple to a light yellow on a
/// logarithmic scale.
class ErrorScale {
 public:
  ErrorScale(const ErrorStudy& study, Quantity quantity);

  /// Place on the ramp, 0 to 1; errors beyond greatest() get its end.
  double at(double error) const;
  /// The greatest error that the ramp distinguishes: a power of ten, 10 at least.
  double greatest() const { return greatest_; }
  Quantity quantity() const { return quantity_; }

 private:
  double greatest_ = 10;
  Quantity quantity_;
};

/// Red, green and blue of every pixel. Black where nothing is drawn: the map's error is negative.
/// Cyan where a sample is missing, magenta where there is one too many (and none missing).
std::vector<uint8_t> error_map_rgb(const ErrorMap& map, const ErrorScale& scale);

/// The legend of error_map_rgb(): an SVG file.
std::string error_scale_svg(const ErrorScale& scale);

/// "maps/NAME.png", relative to the page, for any name.
std::string map_file(const Subject& subject);

}  // namespace pineda::studies
