// Every sample of a triangle as core draws it, before any depth test.
#pragma once

#include "model/core/frame.h"
#include "model/judge/sample.h"

namespace pineda::judge {

/// Calls visit(Stamp, Fragment) for each stamp of a triangle within some rows of tiles, in
/// traversal order. No memories, no depth test.
template <class Visit>
void for_each_fragment(const spec::Contract& contract, const spec::FrameState& frame,
                       core::TileRows rows, const spec::Triangle& triangle, Visit&& visit) {
  struct Sink {
    Visit& visit;
    void prim(const spec::SetupPrim&) {}
    void stamp(const spec::Stamp&) {}
    void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
      visit(stamp, fragment);
    }
  };
  core::FrameCounters counters;
  core::draw_triangle(contract, frame, rows, triangle, &counters, Sink{visit});
}

/// Calls visit(Drawn) for each sample of the whole triangle.
template <class Visit>
void for_each_sample(const spec::Contract& contract, const spec::FrameState& frame,
                     const spec::Triangle& triangle, Visit&& visit) {
  for_each_fragment(contract, frame, {}, triangle,
                    [&](const spec::Stamp& stamp, const spec::Fragment& fragment) {
                      for_each_sample(contract.design, stamp, fragment, visit);
                    });
}

}  // namespace pineda::judge
