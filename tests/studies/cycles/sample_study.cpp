#include "tests/studies/cycles/sample_study.h"

#include <algorithm>
#include <cmath>

#include "model/spec/random.h"

namespace pineda::studies {
namespace {

constexpr int kSidePx = 96;
constexpr int kValues = 4000;

using spec::Random;

// Errors up to `max`: most of them final rounding, a tail by the logarithm.
Distribution errors_up_to(double max, double tail, Random* random) {
  Distribution errors;
  for (int i = 0; i + 1 < kValues; ++i) {
    const double even = .5 * random->unit();
    const double far = .25 * std::pow(4 * max, random->unit());
    const double error = random->unit() < tail ? std::min(far, max) : even;
    errors.add(error, error > .5);
  }
  errors.add(max, max > .5);
  return errors;
}

ErrorMap map_of(const Subject& s, Random* random) {
  ErrorMap map;
  for (int y = 0; y < kSidePx; ++y) {
    for (int x = 0; x < kSidePx; ++x) {
      const double radius = std::hypot(x + .5 - kSidePx / 2., y + .5 - kSidePx / 2.) / kSidePx * 2;
      const bool drawn = radius < .95;
      const double far = std::pow(s.depth.max() / .3, radius) * .3;
      const double near = .5 * random->unit();
      const double error = s.depth.max() < .5 ? 0 : std::min(std::max(near, far), s.depth.max());
      map.depth_ulp.push_back(drawn ? static_cast<float>(error) : -1.F);
      map.color_lsb.push_back(drawn ? static_cast<float>(near) : -1.F);
      const bool wrong = s.missing + s.extra != 0 && radius > .9 && radius < 1;
      const int bits = (drawn && s.missing != 0 ? 1 : 0) | (!drawn && s.extra != 0 ? 2 : 0);
      map.coverage.push_back(static_cast<uint8_t>(wrong ? bits : 0));
    }
  }
  return map;
}

struct Row {
  const char* name;
  const char* summary;
  double depth_ulp;
  double color_lsb;
  double mpixels;  // a second
  double cycles;   // a covered pixel
  double depth_bound;
  double color_bound;
};

constexpr Row kDesigns[] = {
    {"low", "one Newton step, 19 bits: for a depth buffer of 16 bits", 88.2, 17.9, 41.2, .401, 193,
     33.4},
    {"med", "one Newton step, 22 bits", 6.41, 1.43, 40.8, .401, 13.4, 2.6},
    {"med_plus", "one Newton step from a large ROM, 26 bits", .861, .772, 40.1, .401, 1.2, 1.02},
    {"high", "two Newton steps, 30 bits", .541, .546, 39.7, .4013, .65, .63},
    {"high_tile", "default: error at the rounding limit, in-tile steps of 8 fraction bits", .5522,
     .556, 39.9, .4013, .68, .66},
    {"high_plus", "two Newton steps, 32 bits", .514, .512, 38.8, .4013, .54, .53},
    {"div28", "restoring division of 28 bits in place of a ROM", .569, .548, 36.6, .633, .72, .63},
    {"exact", "quotient and remainder planes: every code is the nearest one", .5, .5, 9.3, .401, .5,
     .5},
};

struct Wrong {
  uint64_t missing;
  uint64_t extra;
};
struct Baseline {
  Row row;
  Wrong wrong;
};

constexpr Baseline kBaselines[] = {
    {{"edge_walk", "spans between two edges that are walked row by row", .5, .5, 58, 1.1, 0, 0},
     {0, 0}},
    {{"edge_flat", "edge equations of 12 fraction bits, one colour and one depth a triangle", 8.3e6,
      211, 44, 1.64, 0, 0},
     {0, 0}},
    {{"edge_smooth", "edge equations and planes of 12 fraction bits, set up exactly", 4.3, 1.05, 35,
      1.64, 0, 0},
     {0, 0}},
    {{"edge_fp32_determinant", "edge_smooth set up in binary32, C by the determinant", 21004, 31,
      34.1, 1.64, 0, 0},
     {12345, 9876}},
    {{"edge_fp32_vertex", "edge_smooth set up in binary32, C from one vertex", 9034, 22, 34.4, 1.64,
      0, 0},
     {211, 190}},
    {{"edge_fp32_average", "edge_smooth set up in binary32, C from two vertices averaged", 8716, 21,
      34.2, 1.64, 0, 0},
     {188, 203}},
    {{"barycentric", "three divisions a pixel, column by column, an off-screen point for ties", .5,
      .5, 3.4, 2.2, 0, 0},
     {492, 0}},
    {{"barycentric_incremental", "the same, stepped along rows, colours too", .501, .502, 14.8, 2.2,
      0, 0},
     {492, 0}},
    {{"fp64", "edge equations and planes in double precision", .5, .5, 27, 2.2, 0, 0}, {0, 0}},
    {{"fp32", "edge equations and planes in single precision", 2.9e5, 41, 28.5, 2.2, 0, 0},
     {17, 31}},
    {{"painter", "fp64 without a depth buffer, triangles far to near", .5, .5, 22, 2.2, 0, 0},
     {2431, 0}},
    {{"subdivision", "quarters of the frame: rejected, accepted or split, down to a pixel", .5, .5,
      1.2, 3.7, 0, 0},
     {0, 0}},
    {{"points", "each vertex is a point; no setup", 0, 0, 0, .02, 0, 0}, {1234567, 0}},
};

Subject subject_of(const Row& row, const Wrong& wrong, const ErrorStudy& study, Random* random) {
  const auto samples = static_cast<double>(study.samples);
  Subject s;
  s.name = row.name;
  s.summary = row.summary;
  s.missing = wrong.missing;
  s.extra = wrong.extra;
  if (row.mpixels > 0) {  // not points: it judges nothing and has no time
    const double tail = row.depth_ulp > 1 ? .6 : row.depth_ulp > .5 ? .01 : 0;
    s.depth = errors_up_to(row.depth_ulp, tail, random);
    s.color = errors_up_to(row.color_lsb, tail, random);
    s.seconds = samples / row.mpixels / 1e6;
  }
  s.map = map_of(s, random);
  return s;
}

}  // namespace

ErrorStudy sample_study() {
  Random random(1);
  ErrorStudy study;
  study.width = study.height = kSidePx;
  study.triangles = 6320;
  study.samples = 284'113;
  study.affine_lsb = 3.4;
  const auto samples = static_cast<double>(study.samples);
  for (const Row& row : kDesigns) {
    Subject s = subject_of(row, {0, 0}, study, &random);
    s.is_design = true;
    s.bounds = spec::ErrorBounds{row.depth_bound, row.color_bound};
    s.cycles = samples * row.cycles;
    study.subjects.push_back(s);
  }
  for (const Baseline& b : kBaselines) {
    Subject s = subject_of(b.row, b.wrong, study, &random);
    s.visited = samples * b.row.cycles;
    s.judged_by_frame = s.name == "painter";
    study.subjects.push_back(s);
  }
  return study;
}

Subject* find(ErrorStudy* study, const std::string& name) {
  return &*std::find_if(study->subjects.begin(), study->subjects.end(),
                        [&](const Subject& s) { return s.name == name; });
}

}  // namespace pineda::studies
