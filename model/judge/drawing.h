// Every sample that core draws of a triangle, hidden ones included, for whoever judges it.
#pragma once

#include "model/core/frame.h"
#include "model/judge/sample.h"

namespace pineda::judge {

/// Calls visit(Stamp, Fragment) for each stamp of a triangle, or of what lies in some rows of
/// tiles, in the order of traversal. No memories, no depth test.
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

/// The same, sample by sample: visit(Drawn).
template <class Visit>
void for_each_sample(const spec::Contract& contract, const spec::FrameState& frame,
                     const spec::Triangle& triangle, Visit&& visit) {
  for_each_fragment(contract, frame, {}, triangle,
                    [&](const spec::Stamp& stamp, const spec::Fragment& fragment) {
                      for_each_sample(contract.design, stamp, fragment, visit);
                    });
}

}  // namespace pineda::judge
