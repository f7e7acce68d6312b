// Small cases of each unit, made in memory.
#pragma once

#include "model/spec/bounds.h"
#include "vectors/grammar/file.h"

namespace pineda::vectors {

inline const spec::Contract kContract = spec::contract(spec::kHighTile);
inline const spec::ErrorBounds kBounds = spec::error_bounds(spec::kHighTile);

// Two triangles that overlap in one tile, the second nearer, and one without area.
inline std::vector<spec::Triangle> sample_triangles() {
  const auto vertex = [](int x, int y, int64_t z, int value) {
    return spec::Vertex{x, y, z, {value, 255 - value, 7, 255}};
  };
  return {{0, {vertex(128, 128, 90000, 0), vertex(1500, 300, 80000, 9), vertex(200, 1400, 9, 99)}},
          {1, {vertex(0, 0, 0, 0), vertex(256, 256, 0, 0), vertex(512, 512, 0, 0)}},
          {2, {vertex(-9, 700, 700, 1), vertex(1300, 90, 800, 200), vertex(900, 1500, 5, 255)}}};
}

inline spec::FrameState sample_frame() { return {7, 6, spec::Cull::kNone, spec::DepthFunc::kLess}; }

template <class Case>
Case sample_case();

template <>
inline SetupCase sample_case() {
  return run_model(kContract,
                   SetupCase{"sample.0", sample_frame(), sample_triangles(), {}, {}, {}});
}
template <>
inline TraversalCase sample_case() {
  const auto prims = sample_case<SetupCase>().out;
  return run_model(kContract, TraversalCase{"sample.0", sample_frame(), prims, {}, {}});
}
template <>
inline InterpZtestCase sample_case() {
  const auto stamps = sample_case<TraversalCase>().out;
  return run_model(kContract, InterpZtestCase{"sample.0", sample_frame(), stamps, {}, {}, {}});
}
template <>
inline FrameCase sample_case() {
  return run_model(kContract,
                   FrameCase{"sample.0", sample_frame(), sample_triangles(), {}, {}, {}, {}});
}

template <class Case>
File<Case> sample_file() {
  return {kContract, 1, 5, {sample_case<Case>(), sample_case<Case>()}};
}

}  // namespace pineda::vectors
