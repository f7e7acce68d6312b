#include "model/timing/units/triangle_source.h"

#include <algorithm>

namespace pineda::timing {

namespace {

// The next triangles, none where there are none or next throws.
Triangles pulled(const Next& next, TriangleSource::Failure* failure) {
  try {
    return next();
  } catch (const sc_core::sc_unwind_exception&) {
    throw;  // the process is killed or reset, and must not go on
  } catch (...) {
    failure->thrown = std::current_exception();
    return {};
  }
}

// Fetches a triangle into the processor's cache. It may lie behind the last one: then nothing comes.
void prefetch(const spec::Triangle* triangle) {
  const auto address = reinterpret_cast<uintptr_t>(triangle);
  for (uintptr_t line = 0; line < sizeof *triangle; line += 64) {
    __builtin_prefetch(reinterpret_cast<const void*>(address + line));
  }
}

}  // namespace

// How many of the triangles come before one out of range.
size_t TriangleSource::legal(const Triangles& triangles, Failure* failure) const {
  for (size_t i = 0; i < triangles.count; ++i) {
    const spec::Triangle& triangle = triangles.first[i];
    if (range_.holds(triangle)) continue;
    failure->out_of_range =
        "triangle " + std::to_string(triangle.id) + ", " + range_.reason(triangle);
    return i;
  }
  return triangles.count;
}

TriangleSource::Failure TriangleSource::draw(const Next& next, Cycle run_from, Frame* frame) {
  Failure failure;
  Cycle offered = 0;
  while (failure.out_of_range.empty()) {
    const Triangles triangles = pulled(next, &failure);
    if (triangles.count == 0) break;
    const size_t count = legal(triangles, &failure);
    // For one alone it does not pay.
    fast::SmallWalks* const walks = count > 1 ? frame->small_walks : nullptr;
    if (walks != nullptr) walks->find(triangles.first, count, &frame->stamps_by_samples);
    // Of a group, the next one in memory.
    const spec::Triangle* const ahead = triangles.first + (count > 1 ? count : 0);
    for (size_t i = 0; i < count; ++i) {
      prefetch(ahead + i);
      frame->walk = walks != nullptr ? walks->walk(i) : nullptr;
      if (ready_) offered = first_ready(ready_, ExternalPort::kTriangle, offered);
      offered = tri_o->take(triangles.first[i], std::max(offered, run_from)) + 1;
    }
  }
  return failure;
}

}  // namespace pineda::timing
