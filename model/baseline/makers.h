// One factory function for each baseline; catalogue.cpp lists them.
#pragma once

#include <memory>

#include "model/baseline/baseline.h"

namespace pineda::baseline {

using Maker = std::unique_ptr<Rasterizer>(const spec::Contract&, const spec::FrameState&);

Maker make_edge_walk;
Maker make_edge_flat;
Maker make_edge_smooth;
Maker make_edge_fp32_determinant;
Maker make_edge_fp32_vertex;
Maker make_edge_fp32_average;
Maker make_barycentric;
Maker make_barycentric_incremental;
Maker make_fp64;
Maker make_fp32;
Maker make_subdivision;
Maker make_points;

}  // namespace pineda::baseline
