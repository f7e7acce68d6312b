#include "studies/error/distribution.h"

#include <algorithm>
#include <cmath>

namespace pineda::studies {
namespace {

constexpr int kLowOctave = -40;
constexpr int kOctaves = 80;
constexpr int kBinsAnOctave = 64;
constexpr int kBins = kOctaves * kBinsAnOctave;

int bin_of(double size) {
  int exponent = 0;
  const double mantissa = std::frexp(size, &exponent);  // [1/2, 1)
  const int octave = exponent - 1 - kLowOctave;
  const int within = static_cast<int>((2 * mantissa - 1) * kBinsAnOctave);
  return std::clamp(octave * kBinsAnOctave + within, 0, kBins - 1);
}

double upper_edge(int bin) {
  const double within = 1 + (bin % kBinsAnOctave + 1.0) / kBinsAnOctave;
  return std::ldexp(within, bin / kBinsAnOctave + kLowOctave);
}

}  // namespace

void Distribution::add(double error, bool misrounded) {
  const double size = std::abs(error);
  ++count_;
  misrounded_ += misrounded ? 1 : 0;
  if (size == 0) {
    ++zeros_;
    return;
  }
  if (bins_.empty()) bins_.resize(kBins);
  ++bins_[static_cast<size_t>(bin_of(size))];
  max_ = std::max(max_, size);
  squares_ += size * size;
}

double Distribution::rms() const {
  return count_ == 0 ? 0 : std::sqrt(squares_ / static_cast<double>(count_));
}

double Distribution::quantile(double q) const {
  const auto wanted = static_cast<uint64_t>(std::ceil(q * static_cast<double>(count_)));
  uint64_t seen = zeros_;
  if (seen >= wanted) return 0;
  for (int bin = 0; bin < kBins; ++bin) {
    seen += bins_[static_cast<size_t>(bin)];
    if (seen >= wanted) return std::min(upper_edge(bin), max_);
  }
  return max_;
}

double Distribution::misrounded() const {
  return count_ == 0 ? 0 : static_cast<double>(misrounded_) / static_cast<double>(count_);
}

std::vector<Distribution::Octave> Distribution::octaves() const {
  std::vector<Octave> octaves;
  for (int octave = 0; octave < kOctaves && !bins_.empty(); ++octave) {
    uint64_t count = 0;
    for (int i = 0; i < kBinsAnOctave; ++i) {
      count += bins_[static_cast<size_t>(octave) * kBinsAnOctave + static_cast<size_t>(i)];
    }
    octaves.push_back({octave + kLowOctave, count});
  }
  const auto empty = [](const Octave& o) { return o.count == 0; };
  octaves.erase(octaves.begin(), std::find_if_not(octaves.begin(), octaves.end(), empty));
  octaves.erase(std::find_if_not(octaves.rbegin(), octaves.rend(), empty).base(), octaves.end());
  return octaves;
}

}  // namespace pineda::studies
