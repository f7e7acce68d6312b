// The calls of pineda/golden.h that a model answers.
#include <algorithm>
#include <vector>

#include "golden/model.h"
#include "golden/ranges.h"
#include "golden/structs.h"
#include "model/scene/snap.h"
#include "model/spec/design_file.h"

namespace pineda::golden {
namespace {

thread_local char last_error[512] = "";

void open(const spec::Design& design, pineda_model** model) { *model = new pineda_model(design); }

exact::Format format_of(const spec::Contract& contract) {
  const spec::Design& d = contract.design;
  return {d.subpixel_bits, d.guard_bits, d.depth_bits, 4, 8};
}

/// A checked triangle in screen coordinates, snapped.
spec::Triangle snapped(const spec::Contract& contract, const pineda_screen_triangle& triangle) {
  const auto screen = screen_of(format_of(contract), triangle);
  scene::SnappedSource source(
      contract, std::make_unique<scene::ListReader>(std::vector<scene::ScreenTriangle>{screen}));
  spec::Triangle result;
  source.next(&result);
  return result;
}

/// Draws all triangles, each as `inner(triangle)` makes it, once none is refused.
template <class Triangle, class Inner>
void draw(pineda_model* model, const Triangle* triangles, size_t count, Inner&& inner) {
  if (!model->renderer) refuse(PINEDA_NO_FRAME, "expected pineda_begin_frame() before triangles");
  if (count == 0) return;
  require_pointer(triangles, "triangles");
  std::vector<spec::Triangle> all;
  all.reserve(std::min<size_t>(count, 1 << 16));
  for (size_t i = 0; i < count; ++i) {
    all.push_back(checked("triangles", i, [&] { return inner(triangles[i]); }));
  }
  for (const spec::Triangle& triangle : all) model->renderer->draw(triangle);
}

template <class T>
void read(pineda_model* model, T* to, size_t count, std::vector<T> core::FrameBuffer::*member,
          const char* name) {
  if (!model->renderer) refuse(PINEDA_NO_FRAME, "expected pineda_begin_frame() before reading");
  require_pointer(to, name);
  const core::FrameBuffer buffer = model->renderer->buffer();
  const std::vector<T>& from = buffer.*member;
  if (count != from.size()) {
    refuse(PINEDA_WRONG_SIZE, "{}: expected {} values, got {}", name, from.size(), count);
  }
  std::copy(from.begin(), from.end(), to);
}

}  // namespace

void keep_error(const char* text) noexcept {
  size_t length = 0;
  for (; text[length] != '\0' && length + 1 < sizeof last_error; ++length) {
    last_error[length] = text[length];
  }
  last_error[length] = '\0';
}

}  // namespace pineda::golden

using namespace pineda;  // NOLINT: a file of C functions
using golden::call;
using golden::call_on;
using golden::refuse;
using golden::require_pointer;

const char* pineda_version(void) { return PINEDA_VERSION; }
int pineda_abi(void) { return PINEDA_GOLDEN_ABI; }
const char* pineda_last_error(void) { return golden::last_error; }

const char* pineda_status_text(int32_t status) {
  switch (status) {
    case PINEDA_OK:
      return "ok";
    case PINEDA_NULL_POINTER:
      return "null pointer";
    case PINEDA_NO_DESIGN:
      return "no design";
    case PINEDA_NO_FRAME:
      return "no frame";
    case PINEDA_OUT_OF_RANGE:
      return "out of range";
    case PINEDA_WRONG_SIZE:
      return "wrong size";
    case PINEDA_UNSUPPORTED:
      return "unsupported";
    case PINEDA_OUT_OF_MEMORY:
      return "out of memory";
    case PINEDA_INTERNAL:
      return "internal error";
  }
  return "no status";
}

pineda_status pineda_open(const char* design, pineda_model** model) {
  return call([&] {
    require_pointer(design, "design");
    require_pointer(model, "model");
    const spec::Design* named = spec::find_design(design);
    if (named == nullptr) {
      std::string names;
      for (const spec::Design& d : spec::designs()) {
        names += (names.empty() ? "" : ", ") + std::string(d.name);
      }
      refuse(PINEDA_NO_DESIGN, "expected a design of {}, got '{}'", names, design);
    }
    golden::open(*named, model);
  });
}

pineda_status pineda_open_toml(const char* text, const char* name, pineda_model** model) {
  return call([&] {
    require_pointer(text, "text");
    require_pointer(name, "name");
    require_pointer(model, "model");
    std::optional<spec::Design> design;
    try {
      design = spec::parse_design(text, name);
    } catch (const spec::DesignFileError& error) {
      refuse(PINEDA_NO_DESIGN, "{}", error.what());
    }
    golden::open(*design, model);
  });
}

void pineda_close(pineda_model* model) { delete model; }

pineda_status pineda_get_design(pineda_model* model, pineda_design* design) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(design, "design");
    const spec::Design& d = contract.design;
    *design = {};
    design->subpixel_bits = d.subpixel_bits;
    design->guard_bits = d.guard_bits;
    design->depth_bits = d.depth_test ? d.depth_bits : 0;
    design->attribute_bits = d.attribute_bits;
    design->attributes = d.attributes;
    design->flat_attributes = d.flat_attributes;
    design->perspective = d.perspective ? 1 : 0;
    design->inverse_w_bits = d.perspective ? d.inverse_w_bits : 0;
    design->tile_px = 1 << d.tile_log2;
    design->stamp_width_px = 1 << d.stamp_width_log2;
    design->stamp_height_px = 1 << d.stamp_height_log2;
  });
}

pineda_status pineda_get_toml(pineda_model* model, char* text, size_t capacity, size_t* length) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(length, "length");
    const std::string toml = spec::design_toml(contract.design);
    *length = toml.size();
    if (toml.size() >= capacity) {
      refuse(PINEDA_WRONG_SIZE, "capacity: expected at least {}, got {}", toml.size() + 1,
             capacity);
    }
    require_pointer(text, "text");
    std::copy_n(toml.c_str(), toml.size() + 1, text);
  });
}

pineda_frame pineda_default_frame(int32_t width, int32_t height) {
  pineda_frame frame{};
  frame.width = width;
  frame.height = height;
  frame.depth_write = 1;
  frame.clear_depth = 1;
  return frame;
}

pineda_status pineda_snap(pineda_model* model, const pineda_screen_triangle* screen,
                          pineda_triangle* triangle) {
  return call_on(model, [&](const spec::Contract& contract) {
    require_pointer(screen, "screen");
    require_pointer(triangle, "triangle");
    *triangle = golden::same<pineda_triangle>(golden::snapped(contract, *screen));
  });
}

pineda_status pineda_begin_frame(pineda_model* model, const pineda_frame* frame) {
  return call_on(model, [&](const spec::Contract& contract) {
    const auto state = golden::frame_of(frame, contract);
    // The frame before stays if there is no memory for this one.
    fast::Renderer renderer(contract, state);
    model->renderer.emplace(std::move(renderer));
  });
}

pineda_status pineda_draw(pineda_model* model, const pineda_triangle* triangles, size_t count) {
  return call_on(model, [&](const spec::Contract& contract) {
    golden::draw(model, triangles, count,
                 [&](const pineda_triangle& t) { return golden::triangle_of(contract, t); });
  });
}

pineda_status pineda_draw_screen(pineda_model* model, const pineda_screen_triangle* triangles,
                                 size_t count) {
  return call_on(model, [&](const spec::Contract& contract) {
    golden::draw(model, triangles, count,
                 [&](const pineda_screen_triangle& t) { return golden::snapped(contract, t); });
  });
}

pineda_status pineda_read_hits(pineda_model* model, uint16_t* hits, size_t count) {
  return call_on(model, [&](const spec::Contract&) {
    golden::read(model, hits, count, &core::FrameBuffer::hits, "hits");
  });
}

pineda_status pineda_read_depth(pineda_model* model, uint32_t* depth, size_t count) {
  return call_on(model, [&](const spec::Contract& contract) {
    if (!contract.design.depth_test) {
      refuse(PINEDA_UNSUPPORTED, "expected a design with depth, got {}", contract.design.name);
    }
    golden::read(model, depth, count, &core::FrameBuffer::depth, "depth");
  });
}

pineda_status pineda_read_color(pineda_model* model, uint16_t* color, size_t count) {
  return call_on(model, [&](const spec::Contract&) {
    golden::read(model, color, count, &core::FrameBuffer::color, "color");
  });
}
