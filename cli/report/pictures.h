// A model's memories as the pictures and dumps that scene/ writes.
#pragma once

#include <utility>

#include "model/core/frame.h"
#include "model/scene/writers.h"

namespace pineda::cli {

inline scene::Frame picture_of(const spec::Contract& contract, core::FrameBuffer buffer) {
  scene::Frame frame;
  frame.width = buffer.width;
  frame.height = buffer.height;
  frame.attributes = buffer.channels;
  frame.attribute_bits = contract.design.attribute_bits;
  frame.clear_depth = buffer.clear_depth;
  frame.depth = std::move(buffer.depth);
  frame.color = std::move(buffer.color);
  frame.hits = std::move(buffer.hits);
  return frame;
}

inline void write_pictures(const std::string& folder, const scene::Frame& frame) {
  scene::write_color_png(folder + "/color.png", frame);
  scene::write_depth_png(folder + "/depth.png", frame);
}

}  // namespace pineda::cli
