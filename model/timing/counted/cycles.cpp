#include "model/timing/counted/cycles.h"

namespace pineda::timing {
namespace {

struct UnitWords {
  const char* name;
  const char* title;
};
constexpr UnitWords kUnitWords[kUnits] = {{"setup", "setup"},
                                          {"tiles", "traversal, tiles"},
                                          {"coverage", "traversal, coverage"},
                                          {"stamps", "traversal, stamps"},
                                          {"interp_ztest", "interp_ztest"}};

struct CauseWords {
  const char* name;
  const char* meaning;
};
constexpr CauseWords kCauseWords[kCauses] = {
    {"busy", "at work"},
    {"starved", "nothing to work on"},
    {"blocked", "the next unit, or a full table, does not take what is there"},
    {"hazard", "the stamp's address is in flight"},
    {"memory", "a memory port does not take what is offered"}};

}  // namespace

const char* unit_name(Unit unit) { return kUnitWords[static_cast<size_t>(unit)].name; }
const char* unit_title(Unit unit) { return kUnitWords[static_cast<size_t>(unit)].title; }

const char* cause_name(Cause cause) { return kCauseWords[static_cast<size_t>(cause)].name; }
const char* cause_meaning(Cause cause) { return kCauseWords[static_cast<size_t>(cause)].meaning; }

const char* fifo_name(Fifo fifo) {
  static constexpr const char* kNames[kFifos] = {"prims", "tiles", "stamps"};
  return kNames[static_cast<size_t>(fifo)];
}

int fifo_depth(const spec::Design& design, Fifo fifo) {
  switch (fifo) {
    case Fifo::kPrims:
      return design.prim_fifo_depth;
    case Fifo::kTiles:
      return design.tile_fifo_depth;
    case Fifo::kStamps:
      break;
  }
  return design.stamp_fifo_depth;
}

}  // namespace pineda::timing
