// The plain structs of the C interface and those of model/spec: the same bytes, which is asserted.
#pragma once

#include <pineda/golden.h>

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "model/spec/structs.h"

namespace pineda::golden {

#define PINEDA_SAME(C, Cpp, member)                             \
  static_assert(offsetof(C, member) == offsetof(Cpp, member) && \
                sizeof(C::member) == sizeof(Cpp::member))
#define PINEDA_SAME_SIZE(C, Cpp) \
  static_assert(sizeof(C) == sizeof(Cpp) && std::is_trivially_copyable_v<Cpp>)

PINEDA_SAME(pineda_vertex, spec::Vertex, x);
PINEDA_SAME(pineda_vertex, spec::Vertex, y);
PINEDA_SAME(pineda_vertex, spec::Vertex, z);
PINEDA_SAME(pineda_vertex, spec::Vertex, attr);
PINEDA_SAME(pineda_vertex, spec::Vertex, inverse_w);
PINEDA_SAME(pineda_vertex, spec::Vertex, inverse_w_shift);
PINEDA_SAME_SIZE(pineda_vertex, spec::Vertex);
PINEDA_SAME(pineda_triangle, spec::Triangle, id);
PINEDA_SAME(pineda_triangle, spec::Triangle, v);
PINEDA_SAME_SIZE(pineda_triangle, spec::Triangle);

PINEDA_SAME(pineda_plane, spec::Plane, dx);
PINEDA_SAME(pineda_plane, spec::Plane, dy);
PINEDA_SAME(pineda_plane, spec::Plane, ref);
PINEDA_SAME_SIZE(pineda_plane, spec::Plane);
PINEDA_SAME(pineda_edge, spec::EdgeFunction, a);
PINEDA_SAME(pineda_edge, spec::EdgeFunction, b);
PINEDA_SAME(pineda_edge, spec::EdgeFunction, e);
PINEDA_SAME_SIZE(pineda_edge, spec::EdgeFunction);

PINEDA_SAME(pineda_planes, spec::PlaneSet, z);
PINEDA_SAME(pineda_planes, spec::PlaneSet, z_steep);
PINEDA_SAME(pineda_planes, spec::PlaneSet, z_bias);
PINEDA_SAME(pineda_planes, spec::PlaneSet, attr);
PINEDA_SAME(pineda_planes, spec::PlaneSet, flat);
static_assert(offsetof(pineda_planes, e_low) == offsetof(spec::PlaneSet, perspective));
static_assert(offsetof(pineda_planes, inverse_w) - offsetof(pineda_planes, e_low) ==
              offsetof(spec::PerspectiveSet, inverse_w));
static_assert(offsetof(pineda_planes, inverse_w_shift) - offsetof(pineda_planes, e_low) ==
              offsetof(spec::PerspectiveSet, inverse_w_shift));
static_assert(offsetof(pineda_planes, vertex_attr) - offsetof(pineda_planes, e_low) ==
              offsetof(spec::PerspectiveSet, attr));
PINEDA_SAME_SIZE(pineda_planes, spec::PlaneSet);

PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, id);
PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, x0);
PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, y0);
PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, x1);
PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, y1);
PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, edge);
PINEDA_SAME(pineda_setup_prim, spec::SetupPrim, planes);
PINEDA_SAME_SIZE(pineda_setup_prim, spec::SetupPrim);

PINEDA_SAME(pineda_stamp, spec::Stamp, id);
PINEDA_SAME(pineda_stamp, spec::Stamp, x);
PINEDA_SAME(pineda_stamp, spec::Stamp, y);
PINEDA_SAME(pineda_stamp, spec::Stamp, mask);
PINEDA_SAME(pineda_stamp, spec::Stamp, first);
PINEDA_SAME(pineda_stamp, spec::Stamp, planes);
PINEDA_SAME(pineda_stamp, spec::Stamp, edge);
PINEDA_SAME_SIZE(pineda_stamp, spec::Stamp);

PINEDA_SAME(pineda_fragment, spec::Fragment, z);
PINEDA_SAME(pineda_fragment, spec::Fragment, attr);
PINEDA_SAME_SIZE(pineda_fragment, spec::Fragment);

#undef PINEDA_SAME
#undef PINEDA_SAME_SIZE

static_assert(PINEDA_MAX_ATTRIBUTES == spec::kMaxAttributes && PINEDA_MAX_LANES == spec::kMaxLanes);

/// The same value as the other side's struct. A byte that becomes a bool must be 0 or 1.
template <class To, class From>
To same(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof to);
  return to;
}

}  // namespace pineda::golden
