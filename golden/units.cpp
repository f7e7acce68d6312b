// The calls of pineda/golden.h for one unit at a time, and for packed structs.
#include "golden/model.h"
#include "golden/ranges.h"
#include "golden/structs.h"
#include "model/core/interp.h"
#include "model/core/setup.h"
#include "model/core/traversal.h"
#include "model/spec/pack.h"

namespace pineda::golden {
namespace {

void require_codes(const spec::Contract& contract, const uint32_t* codes, const char* name) {
  require_pointer(codes, name);
  for (int i = 0; i < contract.width.lanes; ++i) {
    require(codes[i], 0, (int64_t{1} << contract.design.depth_bits) - 1, name);
  }
}

void require_words(size_t count, int bits) {
  const auto words = static_cast<size_t>((bits + 31) / 32);
  if (count != words) refuse(PINEDA_WRONG_SIZE, "words: expected {}, got {}", words, count);
}

/// A frame as the interface states it: the scissor is the rectangle that the RTL is told.
pineda_frame stated(const spec::FrameState& state) {
  pineda_frame frame{};
  frame.width = state.width;
  frame.height = state.height;
  frame.cull = static_cast<int32_t>(state.cull);
  frame.depth_func = static_cast<int32_t>(state.depth);
  frame.depth_write = state.depth_write ? 1 : 0;
  frame.shade = static_cast<int32_t>(state.shade);
  frame.has_scissor = 1;
  frame.scissor_x = state.scissor_x0;
  frame.scissor_y = state.scissor_y0;
  frame.scissor_width = state.scissor_x1 - state.scissor_x0;
  frame.scissor_height = state.scissor_y1 - state.scissor_y0;
  frame.bias_slope = state.bias_slope;
  frame.bias_constant = state.bias_constant;
  frame.clear_depth = state.clear_depth;
  return frame;
}

/// Calls visit(checked struct) of a kind.
template <class Visit>
void with_value(const spec::Contract& contract, int32_t kind, const void* value, Visit&& visit) {
  switch (kind) {
    case PINEDA_PACKED_FRAME:
      return visit(frame_of(static_cast<const pineda_frame*>(value), contract));
    case PINEDA_PACKED_TRIANGLE:
      return visit(triangle_of(contract, *static_cast<const pineda_triangle*>(value)));
    case PINEDA_PACKED_SETUP_PRIM:
      return visit(prim_of(contract, *static_cast<const pineda_setup_prim*>(value)));
    case PINEDA_PACKED_STAMP:
      return visit(stamp_of(contract, *static_cast<const pineda_stamp*>(value)));
  }
  refuse(PINEDA_OUT_OF_RANGE, "kind: expected a pineda_packed, got {}", kind);
}

/// Calls visit(struct of model/spec, struct of the interface), neither with a value.
template <class Visit>
void with_types(int32_t kind, Visit&& visit) {
  switch (kind) {
    case PINEDA_PACKED_FRAME:
      return visit(spec::FrameState{}, pineda_frame{});
    case PINEDA_PACKED_TRIANGLE:
      return visit(spec::Triangle{}, pineda_triangle{});
    case PINEDA_PACKED_SETUP_PRIM:
      return visit(spec::SetupPrim{}, pineda_setup_prim{});
    case PINEDA_PACKED_STAMP:
      return visit(spec::Stamp{}, pineda_stamp{});
  }
  refuse(PINEDA_OUT_OF_RANGE, "kind: expected a pineda_packed, got {}", kind);
}

}  // namespace
}  // namespace pineda::golden

using namespace pineda;  // NOLINT: a file of C functions
using golden::call_on;
using golden::refuse;
using golden::require_pointer;
using golden::same;

pineda_status pineda_setup(pineda_model* model, const pineda_frame* frame,
                           const pineda_triangle* triangle, pineda_setup_prim* prim,
                           pineda_drop* drop) {
  return call_on(model, [&](const spec::Contract& contract) {
    const spec::FrameState state = golden::frame_of(frame, contract);
    require_pointer(triangle, "triangle");
    require_pointer(prim, "prim");
    require_pointer(drop, "drop");
    const spec::Triangle input = golden::triangle_of(contract, *triangle);
    spec::SetupPrim output;
    *drop = static_cast<pineda_drop>(core::setup(contract, state, input, &output));
    if (*drop == PINEDA_KEPT) *prim = same<pineda_setup_prim>(output);
  });
}

pineda_status pineda_traverse(pineda_model* model, const pineda_setup_prim* prim,
                              pineda_stamp* stamps, size_t capacity, size_t* count) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(prim, "prim");
    require_pointer(count, "count");
    if (capacity > 0) require_pointer(stamps, "stamps");
    const spec::SetupPrim input = golden::prim_of(contract, *prim);
    size_t found = 0;
    core::for_each_stamp(contract, input, [&](const spec::Stamp& stamp) {
      if (found < capacity) stamps[found] = same<pineda_stamp>(stamp);
      ++found;
    });
    *count = found;
    if (found > capacity) {
      refuse(PINEDA_WRONG_SIZE, "capacity: expected at least {}, got {}", found, capacity);
    }
  });
}

pineda_status pineda_interpolate(pineda_model* model, const pineda_stamp* stamp,
                                 pineda_fragment* fragment) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(stamp, "stamp");
    require_pointer(fragment, "fragment");
    if (contract.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
      refuse(PINEDA_UNSUPPORTED, "expected a design with a reciprocal, got {}",
             contract.design.name);
    }
    const spec::Stamp input = golden::stamp_of(contract, *stamp);
    spec::Fragment output;
    core::interpolate(contract, input, &output);
    *fragment = same<pineda_fragment>(output);
  });
}

pineda_status pineda_depth_test(pineda_model* model, int32_t func, uint32_t mask, const uint32_t* z,
                                const uint32_t* stored, uint32_t* passed) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(passed, "passed");
    golden::require(func, 0, static_cast<int64_t>(std::size(spec::kDepthFuncNames)) - 1, "func");
    golden::require_lanes(contract, mask);
    golden::require_codes(contract, z, "z");
    golden::require_codes(contract, stored, "stored");
    std::array<uint32_t, spec::kMaxLanes> new_codes{}, old_codes{};
    std::copy_n(z, contract.width.lanes, new_codes.begin());
    std::copy_n(stored, contract.width.lanes, old_codes.begin());
    *passed =
        core::depth_test(contract, static_cast<spec::DepthFunc>(func), mask, new_codes, old_codes);
  });
}

pineda_status pineda_packed_bits(pineda_model* model, int32_t kind, size_t* bits) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(bits, "bits");
    golden::with_types(kind, [&](auto inner, auto) {
      *bits = static_cast<size_t>(spec::packed_bits(spec::fields<decltype(inner)>(contract)));
    });
  });
}

pineda_status pineda_pack(pineda_model* model, int32_t kind, const void* value, uint32_t* words,
                          size_t count) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(value, "value");
    require_pointer(words, "words");
    golden::with_value(contract, kind, value, [&](const auto& checked) {
      const spec::Packer<std::decay_t<decltype(checked)>> packer(contract);
      golden::require_words(count, packer.bits());
      packer.pack(checked, words);
    });
  });
}

pineda_status pineda_unpack(pineda_model* model, int32_t kind, const uint32_t* words, size_t count,
                            void* value) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(words, "words");
    require_pointer(value, "value");
    golden::with_types(kind, [&](auto inner, auto outer) {
      using Inner = decltype(inner);
      using Outer = decltype(outer);
      const spec::Packer<Inner> packer(contract);
      golden::require_words(count, packer.bits());
      const Inner unpacked = packer.unpack(words);
      if constexpr (std::is_same_v<Outer, pineda_frame>) {
        *static_cast<Outer*>(value) = golden::stated(unpacked);
      } else {
        *static_cast<Outer*>(value) = same<Outer>(unpacked);
      }
    });
  });
}
