#include <algorithm>
#include <numeric>

#include "model/baseline/makers.h"

namespace pineda::baseline {

const std::vector<Baseline>& baselines() {
  static const std::vector<Baseline> kBaselines{
      {"edge_walk", "spans between two edges that are walked row by row",
       "6.837 Lecture 6, Fall 2000, slides 7 and 8; Rasterization, 2006, slides 8 and 9", false,
       make_edge_walk},
      {"edge_flat", "edge equations of 12 fraction bits, one colour and one depth a triangle",
       "6.837 Lecture 6, Fall 2000, slides 9 to 21", false, make_edge_flat},
      {"edge_smooth", "edge equations and planes of 12 fraction bits, set up exactly",
       "6.837 Lecture 6, Fall 2000, slides 9 to 29", false, make_edge_smooth},
      {"edge_fp32_determinant", "edge_smooth set up in binary32, C by the determinant",
       "6.837 Lecture 6, Fall 2000, slide 12", false, make_edge_fp32_determinant},
      {"edge_fp32_vertex", "edge_smooth set up in binary32, C from one vertex",
       "6.837 Lecture 6, Fall 2000, slide 13", false, make_edge_fp32_vertex},
      {"edge_fp32_average", "edge_smooth set up in binary32, C from two vertices averaged",
       "6.837 Lecture 6, Fall 2000, slide 13", false, make_edge_fp32_average},
      {"barycentric", "three divisions a pixel, column by column, an off-screen point for ties",
       "Triangles, barycentric coordinates", false, make_barycentric},
      {"barycentric_incremental", "the same, stepped along rows, colours too",
       "Triangles, barycentric coordinates", false, make_barycentric_incremental},
      {"fp64", "edge equations and planes in double precision",
       "6.837 Lecture 6, Fall 2000, slides 12 and 24", false, make_fp64},
      {"fp32", "edge equations and planes in single precision",
       "6.837 Lecture 6, Fall 2000, slides 12 and 24", false, make_fp32},
      {"painter", "fp64 without a depth buffer, triangles far to near",
       "Triangles, hidden surface removal", true, make_fp64},
      {"subdivision", "quarters of the frame: rejected, accepted or split, down to a pixel",
       "6.837 Lecture 6, Fall 2000, slide 6 (Warnock)", false, make_subdivision},
      {"points", "each vertex is a point; no setup", "6.837 Lecture 6, Fall 2000, slides 31 and 32",
       false, make_points},
  };
  return kBaselines;
}

std::vector<uint32_t> paint_order(const std::vector<spec::Triangle>& triangles) {
  std::vector<uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  const auto depth = [&](uint32_t i) {  // three times the mean depth
    const auto& v = triangles[i].v;
    return v[0].z + v[1].z + v[2].z;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return depth(a) > depth(b); });
  return order;
}

}  // namespace pineda::baseline
